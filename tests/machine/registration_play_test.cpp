// SPDX-License-Identifier: Apache-2.0
// examples/registration-marks, played on a virtual clock. The judge reads the tick logs alone: where
// the web was, where the cylinder was, and where the marks were.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"
#include "support/errors.hpp"

namespace jounce::registration_play_test {
namespace {

using namespace std::chrono_literals;
using test::Site;
using ::testing::HasSubstr;

const std::filesystem::path example = JOUNCE_SOURCE_DIR "/examples/registration-marks";

/// Texts of the example, and what replaces them.
struct Replaced {
  std::string from, to;
};

/// A copy of the example in which some texts are replaced.
class Copy {
 public:
  explicit Copy(const std::vector<Replaced>& replaced = {})
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("registration_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    for (const auto& file : std::filesystem::directory_iterator(example)) {
      std::ifstream in(file.path());
      std::string text{std::istreambuf_iterator<char>(in), {}};
      for (const auto& [from, to] : replaced)
        if (const auto at = text.find(from); at != std::string::npos)
          text.replace(at, from.size(), to);
      std::ofstream(folder_ / file.path().filename()) << text;
    }
  }
  ~Copy() { std::filesystem::remove_all(folder_); }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
  [[nodiscard]] MachineParts parts() const {
    return machine_parts({.files = {file("machine.toml")}, .log = file("run.csv"), .enable = true});
  }

 private:
  std::filesystem::path folder_;
};

/// The run of the whole web.
struct Printing {
  explicit Printing(const Copy& copy, Nanos time = 27s)
      : site(copy.parts().axes, {.masters = {}, .recorded = true, .said = {}}) {
    MemoryTransport listener(site.network);
    listener.subscribe(wire::channel("cylinder", wire::Lane::event), 100000);
    const Input cam = read_inputs(copy.file("cam.toml")).front();
    EXPECT_TRUE(site.stream(stream_plan("cylinder", cam, {.live = true})).ok());
    Client roller(site.link, "web", {}, site.clock);
    EXPECT_TRUE(roller.command(command::StartTable{}).ok());
    static_cast<void>(roller.release());
    site.advance(time);
    Rejects rejects;
    while (const auto message = next_message(listener, 0ns, rejects))
      if (const auto* event = std::get_if<wire::Event>(&message->body))
        events[event->count] = *event;
    replay = site.replayed();
    log.emplace(copy.file("run.cylinder.csv"));
    cylinder = log->numbers("position");
    web = test::LogColumns(copy.file("run.web.csv")).numbers("position");
  }

  /// The last number of a column of the cylinder.
  [[nodiscard]] double last(const char* column) const { return log->numbers(column).back(); }
  [[nodiscard]] std::string fault() const { return log->text.at("fault").back(); }

  [[nodiscard]] std::int64_t count(wire::EventKind kind, wire::MarkEvent what) const {
    return std::count_if(events.begin(), events.end(), [&](const auto& each) {
      return each.second.kind == kind && each.second.number == static_cast<std::uint32_t>(what);
    });
  }

  Site site;
  std::map<std::int64_t, wire::Event> events;
  Replay replay;
  std::optional<test::LogColumns> log;
  std::vector<double> cylinder, web;  // positions, deg and mm
};

/// Distance of mark k from its place in register, mm: the numbers of cylinder.toml.
double off(int k, double stretch = 0.4, double wander = 1.5, double start = 8) {
  return start + stretch * k + wander * std::sin(2 * std::numbers::pi * k / 24);
}

/// The greatest error of each print, mm on the web, in its zone from 20 to 230 mm after its mark: the
/// cylinder must be at 360 deg a print, plus 1 deg for each mm of the web. Print k + 1 has the mark k.
std::vector<double> print_errors(const Printing& run, double (*off_of)(int)) {
  std::vector<double> errors(58);
  for (std::size_t i = 0; i < run.cylinder.size(); ++i) {
    for (int k = 0; k < 58; ++k) {
      const double on_web = run.web[i] - off_of(k) - 400.0 * (k + 1);
      if (on_web < 20 || on_web > 230) continue;
      const double error = run.cylinder[i] - 360.0 * (k + 1) - on_web;
      auto& worst = errors[static_cast<std::size_t>(k)];
      if (std::abs(error) > std::abs(worst)) worst = error;
    }
  }
  return errors;
}

/// Velocity and acceleration by differences of positions.
void expect_within_limits(const std::vector<double>& positions, double acceleration = 60000) {
  double fastest = 0, hardest = 0;
  for (std::size_t i = 2; i < positions.size(); ++i) {
    const double p0 = positions[i - 2], p1 = positions[i - 1], p2 = positions[i];
    fastest = std::max(fastest, std::abs(p2 - p1) / 1e-3);
    hardest = std::max(hardest, std::abs(p2 - 2 * p1 + p0) / 1e-6);
  }
  EXPECT_LE(fastest, 3000);
  EXPECT_LE(hardest, acceleration);
  EXPECT_GT(fastest, 900) << "it ran";
}

/// Greatest error of the place of a mark, mm: the sensor interpolates on a straight line, a dt^2 / 8.
constexpr double sensor = 500 * 1e-6 / 8 + 1e-4;

TEST(RegistrationPlay, BringsThePrintsIntoRegisterWithMarksThatDrift) {
  const Copy copy;
  const Printing run(copy);
  const auto errors = print_errors(run, [](int k) { return off(k); });
  for (std::size_t k = 1; k < 6; ++k)
    EXPECT_LT(std::abs(errors[k]), std::abs(errors[k - 1])) << k << ": converges";
  EXPECT_GT(errors[0], 5.9);
  double last = 0;  // the last mark that was there
  for (int k = 5; k < 58; ++k) {
    const bool there = k != 20 && k != 21 && k != 33;
    if (there) last = off(k);
    EXPECT_LE(std::abs(errors[static_cast<std::size_t>(k)]), std::abs(off(k) - last) + sensor) << k;
  }
  EXPECT_GT(std::abs(errors[21]), 0.5) << "without its mark, the print keeps the last correction";
  expect_within_limits(run.cylinder);
  EXPECT_EQ(run.fault(), "none");
  EXPECT_EQ(run.last("missed"), 3);
  EXPECT_EQ(run.last("strays"), 1);
  EXPECT_EQ(run.last("marks"), 57);
  EXPECT_FALSE(run.replay.difference) << run.replay.difference->what.field;
  EXPECT_EQ(run.count(wire::EventKind::mark, wire::MarkEvent::accepted), 57);
  EXPECT_EQ(run.count(wire::EventKind::mark, wire::MarkEvent::missing), 3);
  EXPECT_EQ(run.count(wire::EventKind::mark, wire::MarkEvent::stray), 1);
  // EndOfProfile of MC_CamIn: at each 400 mm of the corrected master, which ends at 23968 mm.
  double passes = 0;
  for (const auto& [count, event] : run.events) {
    if (event.kind != wire::EventKind::end_of_profile) continue;
    passes += 1;
    EXPECT_NEAR(event.position, 400 * passes, 1e-6);
    EXPECT_EQ(event.number, passes);
  }
  EXPECT_EQ(passes, 59);
  std::string in_log;  // the same in the log, without the ages
  std::string expected;
  for (const std::string& cell : run.log->text.at("profile"))
    if (!cell.empty()) in_log += cell.substr(0, cell.find('@')) + " ";
  for (int k = 1; k <= 59; ++k) expected += "pass" + std::to_string(k) + " ";
  EXPECT_EQ(in_log, expected);
}

// Without a stretch, the correction of the slave stays small and keeps the prints in register.
TEST(RegistrationPlay, OfTheSlaveCorrectsTheCylinderItself) {
  const Copy copy(std::vector<Replaced>{{"distance = 400.4", "distance = 400"},
                                        {"most = 2 ", "of = \"slave\"\nratio = 1\nmost = 2 "},
                                        {"first = 263", "first = 258"}});
  const Printing run(copy);
  const auto errors = print_errors(run, [](int k) { return off(k, 0, 1.5, 3); });
  for (int k = 5; k < 58; ++k) {
    if (k == 20 || k == 21 || k == 33) continue;
    EXPECT_LE(std::abs(errors[static_cast<std::size_t>(k)]), sensor) << k;
  }
  expect_within_limits(run.cylinder);
  EXPECT_FALSE(run.replay.difference);
}

TEST(RegistrationPlay, TooManyMissingMarksAreAFaultAndTheCylinderStopsWithinItsLimits) {
  const Copy copy(std::vector<Replaced>{{"missing = [20, 21, 33]", "missing = [20, 21, 22]"}});
  const Printing run(copy);
  EXPECT_EQ(run.fault(), "marks_lost");
  EXPECT_EQ(run.last("missed"), 3);
  EXPECT_EQ(run.cylinder.back(), run.cylinder[run.cylinder.size() - 1000]);
  expect_within_limits(run.cylinder, 2 * 60000 * (1 + 1e-9));  // a stop: twice the limit
  EXPECT_EQ(run.count(wire::EventKind::mark, wire::MarkEvent::lost), 1);
  EXPECT_FALSE(run.replay.difference);
}

TEST(RegistrationPlay, OrItHoldsItsCorrectionAndFindsTheMarksAgain) {
  const Copy copy(
      std::vector<Replaced>{{"missing = [20, 21, 33]", "missing = [20, 21, 22, 23, 24, 25]"},
                            {"misses = 3 ", "on_loss = \"hold\"\nmisses = 3 "}});
  const Printing run(copy);
  EXPECT_EQ(run.fault(), "none");
  EXPECT_EQ(run.last("missed"), 6);
  const auto errors = print_errors(run, [](int k) { return off(k); });
  for (std::size_t k = 32; k < 58; ++k) EXPECT_LE(std::abs(errors[k]), sensor) << k;
  expect_within_limits(run.cylinder);
}

// ---- specs ---------------------------------------------------------------------------------------

std::string error_with(const std::vector<Replaced>& replaced) {
  const Copy copy(replaced);
  return test::error_of([&] { static_cast<void>(copy.parts()); });
}

TEST(RegistrationPlay, AMistakeInTheSpecIsNamedWithItsKey) {
  EXPECT_THAT(error_with({{"period = 400 ", "period = 0 "}}),
              ::testing::AllOf(HasSubstr("cylinder.toml"), HasSubstr("registration.period")));
  EXPECT_THAT(error_with({{"search = 60 ", "search = 250 "}}),
              HasSubstr("must be at most 200 mm: half the period"));
  EXPECT_THAT(error_with({{"input = 1 ", "input = 2 "}}),
              HasSubstr("is a trigger input that the drive does not have"));
  EXPECT_THAT(error_with({{"follow = { master = \"web\" }", ""}}), HasSubstr("needs a master"));
  EXPECT_THAT(error_with({{"most = 2 ", "ratio = 1\nmost = 2 "}}),
              HasSubstr("of = \"slave\" only"));
  EXPECT_THAT(error_with({{"width = 4", "width = 300"}}), HasSubstr("half the distance"));
  EXPECT_THAT(error_with({{"cycle = ", "cutter = \"knife.toml\"\ncycle = "}}),
              HasSubstr("cylinder.toml:17:1: registration: cannot be combined with axis.cutter"));
  EXPECT_THAT(error_with({{"of = \"master\"", "of = \"film\""}}), HasSubstr("of"));
}

}  // namespace
}  // namespace jounce::registration_play_test

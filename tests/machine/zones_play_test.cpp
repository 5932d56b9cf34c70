// SPDX-License-Identifier: Apache-2.0
// Position compare of two axes in a group: examples/position-compare/zones.toml as the program of a
// group. The judge reads the tick logs alone.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/design/output_events.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"
#include "stream/src/transport/memory_transport.hpp"
#include "support/errors.hpp"

namespace jounce::zones_play_test {
namespace {

using namespace std::chrono_literals;
using test::LogColumns;

const std::string program = JOUNCE_SOURCE_DIR "/examples/position-compare/zones.toml";

/// A machine with the axes x and y, and a group with a program.
class Folder {
 public:
  explicit Folder(const std::string& path)
      : folder_(std::filesystem::path(testing::TempDir()) / ("zones_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    for (const char* axis : {"x", "y"})
      std::ofstream(folder_ / axis)
          << "jounce = 1\nkind = \"axis\"\nname = \"" << axis
          << "\"\nunits = { position = \"mm\" }\n[axis]\ncycle = \"1 ms\"\n[limits]\n"
             "velocity = 200\nacceleration = 2000\njerk = 50000\n";
    std::ofstream(folder_ / "machine.toml")
        << "jounce = 1\nkind = \"machine\"\n[[axis]]\nspec = \"x\"\n[[axis]]\nspec = "
           "\"y\"\n[[group]]\nname = \"plotter\"\naxes = [\"x\", \"y\"]\nprogram = \""
        << path << "\"\n";
  }
  ~Folder() { std::filesystem::remove_all(folder_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
  [[nodiscard]] MachineParts parts() const {
    return machine_parts({.files = {file("machine.toml")}, .log = file("run.csv"), .enable = true});
  }

 private:
  std::filesystem::path folder_;
};

/// An edge in the log: its instant in ticks, its output, on or off.
struct Edge {
  double tick = 0;
  int output = 0;
  bool on = false;
};

std::vector<Edge> edges_of(const LogColumns& log) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < log.text.at("edges").size(); ++i) {
    std::istringstream cell(log.text.at("edges")[i]);
    for (std::string word; cell >> word;) {
      const auto at = word.find('@');
      edges.push_back({static_cast<double>(i) - 1 + std::stod(word.substr(at + 1)) * 1e3,
                       std::stoi(word.substr(1, at - 1)), word[0] == '+'});
    }
  }
  return edges;
}

double between(const std::vector<double>& values, double tick) {
  const auto i = static_cast<std::size_t>(tick);
  return values[i] + (tick - std::floor(tick)) * (values[i + 1] - values[i]);
}

TEST(ZonesPlay, TheOutputsOfAGroupGoOnAtTheEdgesOfTheZones) {
  const Folder folder(program);
  test::Site site(folder.parts().axes, {.masters = {}, .recorded = true, .said = {}});
  site.advance(20ms);
  Client group(site.link, "plotter", {}, site.clock);
  ASSERT_TRUE(group.command(command::Enable{}).ok());
  site.advance(20ms);
  const CallOutcome start = group.command(command::StartTable{});
  ASSERT_TRUE(start.ok()) << start.reason;
  static_cast<void>(group.release());
  site.advance(6s);
  EXPECT_FALSE(site.replayed().difference);
  const auto x = LogColumns(folder.file("run.x.csv")).numbers("position");
  const auto y = LogColumns(folder.file("run.y.csv")).numbers("position");
  const auto edges = edges_of(LogColumns(folder.file("run.plotter.csv")));
  struct Zone {
    double x, y;
    int output;
  };
  const std::vector<Zone> zones{{50, 0, 16}, {100, 50, 17}, {50, 100, 16}};
  ASSERT_EQ(edges.size(), 2 * zones.size());
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Edge& on = edges[2 * i];
    const Edge& off = edges[2 * i + 1];
    const double dx = std::abs(between(x, on.tick) - zones[i].x);
    const double dy = std::abs(between(y, on.tick) - zones[i].y);
    EXPECT_TRUE(on.on && !off.on);
    EXPECT_EQ(on.output, zones[i].output);
    EXPECT_EQ(off.output, zones[i].output);
    EXPECT_NEAR(std::max(dx, dy), 0.5, 1e-6) << "at the edge of the zone " << i;
    EXPECT_NEAR(off.tick - on.tick, 2, 1e-6) << "a pulse of 2 ms";
  }
}

// Pulses along rounded corners: the messages of the group have the instants and places of `jounce events`.
TEST(ZonesPlay, PulsesAlongAPathAreThoseOfItsEvents) {
  const Folder folder("corner.toml");
  std::ofstream(folder.file("corner.toml"))
      << "jounce = 1\nkind = \"path\"\nname = \"corner\"\nunits = { position = \"mm\", time = "
         "\"s\" }\n[path]\nvelocity = 190\ncorner = { distance = 5 }\n"
         "[[axis]]\nname = \"x\"\nlimits = { velocity = 200, acceleration = 2000, jerk = 50000 }\n"
         "[[axis]]\nname = \"y\"\nlimits = { velocity = 200, acceleration = 2000, jerk = 50000 }\n"
         "[[command]]\ntype = \"line\"\nto = [30, 0]\n[[command]]\ntype = \"line\"\n"
         "to = [30, 30]\n[[command]]\ntype = \"line\"\nto = [5, 40]\n[compare]\naxis = \"path\"\n"
         "mode = \"linear\"\nstart = 0.7\nincrement = 1.1\ncount = 74\npulse = \"10 us\"\n";
  const std::vector<OutputEvent> wanted =
      output_events(read_inputs(folder.file("corner.toml"))).all;
  ASSERT_GT(wanted.size(), 130U);
  test::Site site(folder.parts().axes);
  MemoryTransport listener(site.network);
  listener.subscribe(wire::channel("plotter", wire::Lane::event), 4096);
  site.advance(20ms);
  Client group(site.link, "plotter", {}, site.clock);
  ASSERT_TRUE(group.command(command::Enable{}).ok());
  site.advance(20ms);
  const CallOutcome start = group.command(command::StartTable{});
  ASSERT_TRUE(start.ok()) << start.reason;
  static_cast<void>(group.release());
  site.advance(3s);
  std::map<std::int64_t, wire::Event> seen;  // a message may come twice
  Rejects rejects;
  while (const auto message = next_message(listener, 0ns, rejects))
    if (const auto* event = std::get_if<wire::Event>(&message->body);
        event != nullptr && event->kind == wire::EventKind::compare)
      seen[event->count] = *event;
  ASSERT_EQ(seen.size(), wanted.size());
  const auto time = [](const wire::Event& event) {
    return static_cast<double>(event.tick) * 1e-3 - event.offset_s;
  };
  const double begin = time(seen.begin()->second) - wanted.front().time;
  std::size_t k = 0;
  for (const auto& [count, event] : seen) {
    EXPECT_NEAR(time(event) - begin, wanted[k].time, 2e-7) << k;
    EXPECT_EQ(event.on, wanted[k].on) << k;
    EXPECT_NEAR(event.position, wanted[k].position, event.on ? 0 : 1e-4) << k;
    ++k;
  }
}

TEST(ZonesPlay, ACompareOfOneAxisBelongsInTheSpecOfThisAxis) {
  const std::string copy = testing::TempDir() + "/one_axis_" + std::to_string(getpid()) + ".toml";
  std::ifstream in(program);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto from = text.find("mode = \"zone\"");
  const auto to = text.find("[[axis]]");
  text.replace(from, to - from, "mode = \"equal\"\naxis = \"x\"\nposition = 50\n");
  std::ofstream(copy) << text;
  const Folder folder(copy);
  EXPECT_THAT(test::error_of([&] { static_cast<void>(folder.parts()); }),
              testing::HasSubstr("must be \"path\" in the program of a group"));
  std::filesystem::remove(copy);
}

}  // namespace
}  // namespace jounce::zones_play_test

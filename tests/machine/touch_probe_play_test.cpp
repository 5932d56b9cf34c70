// SPDX-License-Identifier: Apache-2.0
// examples/touch-probe, commanded through the protocol on a virtual clock: answers, events, log, record.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"

namespace jounce::touch_probe_play_test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

struct Slide {
  explicit Slide(const std::string& example = "touch-probe/axis.toml")
      : log(testing::TempDir() + "/touch_probe_" + std::to_string(getpid()) + ".csv"),
        site(machine_parts({.files = {examples + example}, .log = log, .enable = true}).axes,
             {.masters = {}, .recorded = true, .said = {}}),
        listener(site.network) {
    listener.subscribe(wire::channel("slide", wire::Lane::event), 1000);
    site.advance(20ms);
  }
  ~Slide() { std::filesystem::remove(log); }
  Slide(const Slide&) = delete;
  Slide& operator=(const Slide&) = delete;

  CallOutcome order(const ClientCommand& command) {
    Client client(site.link, "slide", {}, site.clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    return outcome;
  }
  /// The events so far, by their numbers.
  std::map<std::int64_t, wire::Event> events() {
    std::map<std::int64_t, wire::Event> all;
    Rejects rejects;
    while (const auto message = next_message(listener, 0ns, rejects))
      if (const auto* event = std::get_if<wire::Event>(&message->body)) all[event->count] = *event;
    return all;
  }

  std::string log;
  test::Site site;
  MemoryTransport listener;
};

TEST(TouchProbePlay, CapturesAreEventsInTheLogAndInTheReplay) {
  Slide slide;
  ASSERT_TRUE(
      slide.order(command::TouchProbe{.edge = ProbeEdge::both, .count = 4, .first_position = 50})
          .ok());
  ASSERT_TRUE(slide.order(command::MoveAbsolute{.position = 150}).ok());
  slide.site.advance(3s);
  std::vector<double> positions;
  for (const auto& [count, event] : slide.events()) {
    EXPECT_EQ(event.kind, wire::EventKind::probe);
    EXPECT_EQ(event.number, 1U);
    EXPECT_EQ(event.on, count % 2 == 1);
    EXPECT_GE(event.offset_s, 0);
    EXPECT_LE(event.offset_s, 1e-3);
    positions.push_back(event.position);
  }
  EXPECT_EQ(positions, (std::vector<double>{60, 64, 100, 104}));
  EXPECT_FALSE(slide.site.replayed().difference);
  std::string captures;
  const test::LogColumns log(slide.log);
  for (const std::string& cell : log.text.at("captures"))
    captures += cell.empty() ? "" : cell.substr(0, 2) + cell.substr(cell.find('=')) + " ";
  EXPECT_EQ(captures, "1+=60 1-=64 1+=100 1-=104 ");
}

// LS_ZeroLatch and EzLatch of the PMC600, on the machine of examples/homing: after the homing, its home switch is on
// from 1 to 16 mm (20 to 35 mm of the machine, whose index at 24 mm gets the position 5).
TEST(TouchProbePlay, LatchesTheHomeSwitchAndTheIndex) {
  Slide slide("homing/axis.toml");
  ASSERT_TRUE(slide.order(command::Home{}).ok());
  slide.site.advance(20s);
  ASSERT_TRUE(slide.order(command::MoveAbsolute{.position = -4}).ok());
  slide.site.advance(3s);
  const std::size_t before = slide.events().size();
  ASSERT_TRUE(slide.order(command::TouchProbe{.input = home_switch_input}).ok());
  ASSERT_TRUE(
      slide.order(command::TouchProbe{.input = index_input, .count = 3, .first_position = 10})
          .ok());
  ASSERT_TRUE(slide.order(command::MoveAbsolute{.position = 60}).ok());
  slide.site.advance(3s);
  ASSERT_EQ(before, 0U) << "no capture without a touch probe";
  std::vector<std::pair<std::uint32_t, double>> captures;
  for (const auto& [count, event] : slide.events()) {
    EXPECT_TRUE(event.on);
    captures.emplace_back(event.number, event.position);
  }
  ASSERT_EQ(captures.size(), 4U);
  const std::vector<std::pair<std::uint32_t, double>> want{
      {home_switch_input, 1}, {index_input, 15}, {index_input, 25}, {index_input, 35}};
  for (std::size_t k = 0; k < want.size(); ++k) {
    EXPECT_EQ(captures[k].first, want[k].first) << k;
    EXPECT_NEAR(captures[k].second, want[k].second, 1e-9) << k;
  }
  EXPECT_FALSE(slide.site.replayed().difference);
}

TEST(TouchProbePlay, MistakesAreAnsweredWithTheirReason) {
  Slide slide;
  EXPECT_THAT(slide.order(command::TouchProbe{.input = 2}).reason, HasSubstr("no_trigger_input"));
  EXPECT_THAT(slide.order(command::TouchProbe{.input = index_input}).reason,
              HasSubstr("no_trigger_input"));
  EXPECT_THAT(slide.order(command::TouchProbe{.first_position = 400}).reason,
              HasSubstr("probe_window"));
  EXPECT_THAT(slide.order(command::TouchProbe{.first_position = 20, .last_position = 10}).reason,
              HasSubstr("probe_window"));
  EXPECT_THAT(slide.order(command::AbortTrigger{}).reason, HasSubstr("no_touch_probe"));
  EXPECT_TRUE(slide.order(command::TouchProbe{}).ok());
  EXPECT_TRUE(slide.order(command::TouchProbe{}).ok()) << "replaces the first one";
  EXPECT_TRUE(slide.order(command::AbortTrigger{}).ok());
}

}  // namespace
}  // namespace jounce::touch_probe_play_test

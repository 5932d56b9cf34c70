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

const std::string example = JOUNCE_SOURCE_DIR "/examples/touch-probe/axis.toml";

struct Slide {
  Slide()
      : log(testing::TempDir() + "/touch_probe_" + std::to_string(getpid()) + ".csv"),
        site(machine_parts({.files = {example}, .log = log, .enable = true}).axes,
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

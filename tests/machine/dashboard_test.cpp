// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/dashboard.hpp"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>

#include "jounce/command/cause.hpp"
#include "jounce/machine/detail/status_text.hpp"
#include "jounce/machine/detail/terminal.hpp"

#include "machine/src/operate/dashboard_text.hpp"

namespace jounce::dashboard {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

wire::Status moving() {
  wire::Status s;
  s.state = State::synchronized_motion;
  s.progress = wire::Progress::running;
  s.tick = 4711;
  s.cycle_ns = 1'000'000;
  s.master_position = 45.5;
  s.slave_position = 123.25;
  s.slave_velocity = -7.5;
  s.actual_position = 123;
  s.following_error = 0.25;
  s.torque = 0.4;
  s.override_ = 0.5;
  s.queue_rows = 1024;
  s.queue_capacity = 4096;
  s.outputs = 0b101;
  s.late_ticks = 3;
  s.lateness[6] = 1000;
  s.lateness[9] = 1;
  s.units = {"deg", "mm"};
  return s;
}

std::vector<Watched> two_axes() {
  std::vector<Watched> axes;
  take(axes, "knife", wire::Status{}, 1s);
  take(axes, "feeder", moving(), 1s);
  return axes;
}

std::string text_of(const Row& row) {
  std::string text;
  for (const Span& span : row) text += span.text;
  return text;
}

std::string text_of(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += text_of(row) + "\n";
  return text;
}

std::string screen(const std::vector<Watched>& axes, const View& view) {
  return text_of(rows_of(axes, view));
}

/// Tone of the first span with this text; nullopt if there is none.
std::optional<Tone> tone_of(const std::vector<Row>& rows, const std::string& text) {
  for (const Row& row : rows)
    for (const Span& span : row)
      if (span.text.find(text) != std::string::npos) return span.tone;
  return std::nullopt;
}

std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

TEST(Dashboard, ShowsTheAxesByNameAndTheFirstInDetail) {
  const std::string text = screen(two_axes(), {.now = 1s});
  EXPECT_LT(text.find("> feeder"), text.find("  knife"));
  for (const char* said :
       {"synchronized_motion", "motion running", "123.25 mm", "master 45.5 deg", "-7.5 mm/s",
        "torque 40 %", "following error 0.25 mm", "50 %", "1024 of 4096 rows", "1 3 ", "3 cycles",
        "late by 1 ms or more; present tick 4711", "99.9 % within 64 us"})
    EXPECT_THAT(text, HasSubstr(said));
}

TEST(Dashboard, ShowsUnknownValues) {
  const std::string text = screen(two_axes(), {.chosen = "knife", .now = 1s});
  EXPECT_THAT(text, HasSubstr("> knife"));
  EXPECT_THAT(text, HasSubstr("torque not known"));
  EXPECT_THAT(text, HasSubstr("following error not known"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(Dashboard, FitsEveryScreen) {
  for (const bool ascii : {false, true})
    for (int width = 0; width <= 200; width += 7)
      for (int height = 0; height <= 60; ++height) {
        const auto rows =
            rows_of(two_axes(), {.width = width, .height = height, .ascii = ascii, .now = 1s});
        ASSERT_LE(rows.size(), static_cast<std::size_t>(height));
        for (const Row& row : rows)
          ASSERT_LE(columns(text_of(row)), static_cast<std::size_t>(width))
              << width << " x " << height << ": " << text_of(row);
      }
}

TEST(Dashboard, ShowsTheWholeAxisAndItsKeysOn80By24) {
  const std::string text = screen(two_axes(), {.now = 1s});
  EXPECT_THAT(text, HasSubstr("packets"));
  EXPECT_THAT(text, HasSubstr("q quit"));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24);
}

TEST(Dashboard, KeepsTheChosenOneOfManyInSight) {
  std::vector<Watched> axes;
  for (int i = 10; i < 74; ++i) take(axes, "axis" + std::to_string(i), moving(), 1s);
  for (const Watched& axis : axes) {
    const std::string text = screen(axes, {.chosen = axis.name, .now = 1s});
    EXPECT_THAT(text, HasSubstr("> " + axis.name));
    EXPECT_THAT(text, HasSubstr("q quit"));
  }
}

TEST(Dashboard, IsAsciiWhereItHasToBe) {
  std::vector<Watched> axes = two_axes();
  axes[0].status->units.position = "µm";
  EXPECT_THAT(screen(axes, {.now = 1s}), HasSubstr("123.25 µm"));
  const std::string text = screen(axes, {.ascii = true, .now = 1s});
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c > 0; })) << text;
  EXPECT_THAT(text, HasSubstr("123.25 ?m"));
}

TEST(Dashboard, SendsNoControlCharacterToTheTerminal) {
  std::vector<Watched> axes = two_axes();
  // CSI as one character of two bytes, an escape, a byte that ends nothing.
  axes[0].status->units.position =
      "\xC2\x9B"
      "2J\x1b[2J\x80";
  const std::string text = screen(axes, {.now = 1s});
  EXPECT_THAT(text, HasSubstr("?2J?[2J?"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\xC2\x9B")));
}

TEST(Dashboard, ShowsAFaultInWordsWithItsNumber) {
  std::vector<Watched> axes = two_axes();
  axes[0].status->state = State::error_stop;
  axes[0].status->last_error = 6;
  const auto rows = rows_of(axes, {.width = 120, .now = 1s});
  EXPECT_THAT(text_of(rows), HasSubstr("6 following_error: The following error exceeded"));
  EXPECT_EQ(tone_of(rows, "error_stop"), Tone::wrong);
  EXPECT_EQ(tone_of(rows, "6 following_error"), Tone::wrong);
}

TEST(Dashboard, ShowsASilentAxisInPlaceOfItsState) {
  const std::vector<Watched> axes = two_axes();
  EXPECT_THAT(screen(axes, {.now = 4s, .silence = 3s}), Not(HasSubstr("silent")));
  const auto rows = rows_of(axes, {.now = 6s, .silence = 3s});
  EXPECT_THAT(text_of(rows), HasSubstr("silent for 5 s"));
  EXPECT_EQ(tone_of(rows, "silent for 5 s"), Tone::wrong);
}

TEST(Dashboard, ShowsThatNoStatusArrives) {
  EXPECT_THAT(screen({}, {}), HasSubstr("no message yet"));
  EXPECT_THAT(screen({{.name = "feeder"}}, {}), HasSubstr("no message yet"));
}

TEST(Dashboard, HasAMarkForOneLateCycleAmongMillions) {
  std::vector<Watched> axes = two_axes();
  axes[0].status->lateness = {};
  axes[0].status->lateness[0] = std::numeric_limits<std::int32_t>::max();
  axes[0].status->lateness[15] = 1;
  EXPECT_THAT(screen(axes, {.ascii = true, .now = 1s}), HasSubstr("@              ."));
}

TEST(Sparkline, ExtendsFromTheLowestToTheHighestShownValue) {
  EXPECT_EQ(machine_detail::sparkline({0, 1, 2, 7}, 80, true), ".:-@");
  EXPECT_EQ(machine_detail::sparkline({100, 0, 7}, 2, true), ".@");
  EXPECT_EQ(machine_detail::sparkline({5, 5}, 80, false), "▁▁");
  EXPECT_EQ(machine_detail::sparkline({}, 80, true), "");
  EXPECT_EQ(machine_detail::sparkline({1, 2}, 0, true), "");
}

TEST(Heard, KeepsTenPositionsASecondAndNoMoreThanAreShown) {
  std::vector<Watched> axes;
  wire::Status s;
  for (int i = 0; i < 100'000; ++i) {
    s.slave_position = i;
    take(axes, "feeder", s, i * 1ms);
  }
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_EQ(axes[0].trace.size(), Watched::traced);
  EXPECT_EQ(axes[0].trace.back(), 99'900);
  EXPECT_EQ(axes[0].trace.front(), 99'900 - 100.0 * (Watched::traced - 1));
  EXPECT_EQ(axes[0].received, 99'999ms);
}

TEST(Events, AreKeptOnceAndInOrder) {
  std::vector<Watched> axes = two_axes();
  const auto event = [](std::int64_t count, std::int64_t boot = 1) {
    return wire::Event{.boot = boot,
                       .count = count,
                       .kind = wire::EventKind::probe,
                       .number = 1,
                       .on = true,
                       .position = 12.5};
  };
  EXPECT_FALSE(take(axes, "unknown", event(1)));
  EXPECT_TRUE(take(axes, "feeder", event(7)));
  EXPECT_FALSE(take(axes, "feeder", event(7))) << "sent again";
  EXPECT_TRUE(take(axes, "feeder", event(8)));
  EXPECT_FALSE(take(axes, "feeder", event(7)));
  EXPECT_TRUE(take(axes, "feeder", event(11)));
  EXPECT_EQ(axes[0].lost_events, 2);
  for (int i = 12; i < 400; ++i) take(axes, "feeder", event(i));
  EXPECT_EQ(axes[0].events.size(), 256U);
  EXPECT_TRUE(take(axes, "feeder", event(1, 2))) << "of an executor that was started again";
  EXPECT_EQ(axes[0].events.size(), 1U);
}

TEST(StatusText, ShowsNoRoundingAsAPosition) {
  wire::Status status;
  status.units = {"deg", "mm"};
  status.slave_position = -8.95247e-60;
  status.slave_velocity = 1e-15;
  EXPECT_THAT(status_text("slide", status), HasSubstr("position 0 mm           velocity 0 mm/s "));
}

TEST(Events, AreLinesOfText) {
  const wire::Event probe{.count = 17,
                          .kind = wire::EventKind::probe,
                          .number = 6,
                          .on = true,
                          .tick = 1203,
                          .offset_s = 412e-6,
                          .position = 123.25};
  EXPECT_EQ(status_text("label", probe),
            "label        event 17     tick 1203 - 412.0 us  probe index rising at 123.25");
  EXPECT_EQ(event_text({.kind = wire::EventKind::mark, .number = 1, .position = -0.25}),
            "mark, deviation -0.25");
  EXPECT_EQ(event_text({.kind = wire::EventKind::mark, .number = 2}), "mark missing");
  EXPECT_EQ(event_text({.kind = wire::EventKind::track, .number = 3, .position = 5}),
            "track 3 off at 5");
  EXPECT_EQ(event_text({.kind = wire::EventKind::end_of_profile, .number = 3, .position = 400}),
            "end of profile 3, master at 400");
  EXPECT_EQ(event_text({.kind = wire::EventKind::table_begin, .number = 2, .position = 50000}),
            "follow table 2 begins, master at 50000");
}

TEST(Status, IsALineWithUnits) {
  wire::Status status;
  status.units = {"deg", "mm"};
  status.master_position = std::numeric_limits<double>::quiet_NaN();
  status.slave_position = 12.5;
  status.slave_velocity = -20;
  const std::string line = status_text("feeder", status);
  EXPECT_THAT(line, ::testing::HasSubstr("no master "));
  EXPECT_THAT(line, ::testing::HasSubstr("position 12.5 mm "));
  EXPECT_THAT(line, ::testing::HasSubstr("velocity -20 mm/s "));
  status.master_position = 90;
  EXPECT_THAT(status_text("feeder", status), ::testing::HasSubstr("master 90 deg "));
  EXPECT_THAT(status_text("feeder", status), ::testing::Not(::testing::HasSubstr("override")));
  status.override_ = 0.5;
  EXPECT_THAT(status_text("feeder", status), ::testing::HasSubstr("override 50 %"));
  status.state = State::standstill;
  status.reason = static_cast<std::int32_t>(Cause::start_position);
  EXPECT_THAT(status_text("feeder", status), ::testing::HasSubstr("start dropped: start_position"));
}

TEST(Keys, HoldAndResumeAreForTheChosenAxis) {
  const auto axes = two_axes();
  View view;
  EXPECT_EQ(press(view, axes, Key{'h'}), Action::hold);
  EXPECT_EQ(view.chosen, "feeder");
  EXPECT_EQ(press(view, axes, Key::down), Action::nothing);
  EXPECT_EQ(press(view, axes, Key{'r'}), Action::resume);
  EXPECT_EQ(view.chosen, "knife");
  EXPECT_EQ(press(view, axes, Key::down), Action::nothing);
  EXPECT_EQ(view.chosen, "feeder");
  EXPECT_EQ(press(view, axes, Key::up), Action::nothing);
  EXPECT_EQ(view.chosen, "knife");
  EXPECT_EQ(press(view, axes, Key{'q'}), Action::quit);
}

TEST(Keys, AStopIsAskedForTwice) {
  const auto axes = two_axes();
  View view;
  EXPECT_EQ(press(view, axes, Key{'s'}), Action::nothing);
  EXPECT_THAT(screen(axes, view), HasSubstr("Stop feeder?"));
  EXPECT_EQ(press(view, axes, Key{'s'}), Action::nothing);
  EXPECT_THAT(screen(axes, view), Not(HasSubstr("Stop feeder?")));
  EXPECT_EQ(press(view, axes, Key{'y'}), Action::nothing);
  EXPECT_EQ(press(view, axes, Key{'s'}), Action::nothing);
  EXPECT_EQ(press(view, axes, Key{'y'}), Action::stop);
  EXPECT_EQ(press(view, axes, Key{'y'}), Action::nothing);
}

// An operator who reads "Stop knife?" and presses y stops the knife, for any messages in between.
TEST(Keys, AnAxisThatAppearsTakesNothingFromTheChosenOne) {
  auto axes = two_axes();
  View view{.chosen = "knife"};
  EXPECT_EQ(press(view, axes, Key{'s'}), Action::nothing);
  take(axes, "auger", wire::Status{}, 2s);
  EXPECT_THAT(screen(axes, view), HasSubstr("Stop knife?"));
  EXPECT_EQ(press(view, axes, Key{'y'}), Action::stop);
  EXPECT_EQ(view.chosen, "knife");
}

TEST(Keys, HaveNoEffectWithoutStatus) {
  View view;
  for (const int c :
       {int('h'), int('r'), int('s'), int('y'), int('\t'), int(Key::up), int(Key::down)})
    EXPECT_EQ(press(view, {}, Key{c}), Action::nothing);
  EXPECT_FALSE(view.asks);
}

TEST(Terminal, ClearsWhatARowLeavesOver) {
  EXPECT_EQ(drawn({{{"a", Tone::plain}}, {}}),
            "\x1b[H\x1b[0ma\x1b[0m\x1b[K\r\n\x1b[0m\x1b[K\x1b[J");
}

TEST(Dashboard, ShowsThePlaceOfAGroupOnItsPath) {
  std::vector<Watched> axes;
  take(axes, "plotter", moving(), 1s);
  take(axes, "plotter",
       wire::GroupStatus{.boot = 7,
                         .tick = 10,
                         .axes = {"x", "c"},
                         .place = {10, -2.5},
                         .framed = true,
                         .line = 12,
                         .commands = 3,
                         .estimated = true,
                         .position = 12.5,
                         .length = 400,
                         .feed = 80,
                         .remaining_s = 4.25,
                         .look_ahead = 380,
                         .units = {"mm", "deg"}});
  std::string all;
  for (const Row& row : rows_of(axes, {.height = 40, .now = 1s}))
    for (const Span& span : row) all += span.text;
  EXPECT_THAT(all, HasSubstr("frame x 10 mm c -2.5 deg; path 12.5 mm of 400 mm, line 12"));
  EXPECT_THAT(all, HasSubstr("4.25 s (estimate), 3 commands, look-ahead 380 mm"));
}

TEST(Dashboard, ShowsNoLengthForAGroupWithoutAPath) {
  const wire::GroupStatus rests{.axes = {"x"}, .place = {10}, .position = 50, .units = {"mm"}};
  EXPECT_EQ(place_text(rests, "mm"), "x 10 mm; no path");
}

TEST(Dashboard, ShowsWhichPartOfTheListIsOnTheScreen) {
  std::vector<Watched> axes;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) take(axes, name, moving(), 1s);
  View view{.width = 80, .height = 20, .now = 1s};
  view.chosen = "a";
  std::size_t listed = 0;
  const std::string first = screen(axes, view);
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    listed += first.find("\n  " + std::string(name) + " ") != std::string::npos ||
                      first.find("> " + std::string(name) + " ") != std::string::npos
                  ? 1
                  : 0;
  ASSERT_LT(listed, 6U) << first;
  EXPECT_THAT(first, HasSubstr("\n  axes 1 to " + std::to_string(listed) + " of 6\n")) << first;
  view.chosen = "f";
  EXPECT_THAT(screen(axes, view), HasSubstr(" to 6 of 6\n"));
  view.height = 60;
  EXPECT_THAT(screen(axes, view), Not(HasSubstr("of 6")));
}

TEST(Dashboard, ShowsTheMasterOfTheChosenAxis) {
  std::vector<Watched> axes;
  const wire::MasterStatus there{7, "line", "mm", 10, false, 1234.5, 500, 0.0013, 12, 1};
  take(axes, "knife", there);
  EXPECT_TRUE(axes.empty()) << "an axis appears with its status";
  wire::Status status = moving();
  status.boot = 7;
  take(axes, "knife", status, 1s);
  take(axes, "knife", there);
  const auto text = [&] {
    std::string all;
    for (const Row& row : rows_of(axes, {.height = 40, .now = 1s}))
      for (const Span& span : row) all += span.text;
    return all;
  };
  EXPECT_THAT(text(), HasSubstr("line 1234.5 mm, 500 mm/s, measured 1.3 ms ago"));
  take(axes, "knife", wire::MasterStatus{7, "line", "mm", 11, true});
  EXPECT_THAT(text(), HasSubstr("line, no valid sample yet"));
  take(axes, "knife", wire::MasterStatus{7, "line", "mm", 11, true, NAN, NAN, NAN, 0, 3100});
  EXPECT_THAT(text(), HasSubstr("3100 rejected (unit, epoch, order)"));
  EXPECT_EQ(axes[0].masters.size(), 1U);
  for (int i = 0; i < 1000; ++i)
    take(axes, "knife", wire::MasterStatus{7, "m" + std::to_string(i), "mm", 12 + i, true});
  EXPECT_EQ(axes[0].masters.size(), Watched::most_masters) << "for any invented masters";
  EXPECT_EQ(axes[0].masters.back().master, "m999");
}

}  // namespace
}  // namespace jounce::dashboard

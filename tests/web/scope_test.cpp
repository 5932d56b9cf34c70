// SPDX-License-Identifier: Apache-2.0
#include "web/src/scope.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"

namespace jounce::web::scope_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

TraceTick tick(std::int64_t number, double position, double master = no_value) {
  return {.tick = number,
          .values = {position, no_value, no_value, no_value, no_value, no_value, master, no_value}};
}

json window(const Trace& trace, const std::string& query) {
  return json::parse(scope_json(trace, 0, scope_query({.query = query})));
}

/// A trace of one axis at 1 kHz.
struct Traced : testing::Test {
  Trace trace = Trace::of(std::vector<std::int64_t>{1'000'000});
};

TEST_F(Traced, ABucketHasTheExtremesOfAllItsTicks) {
  for (std::int64_t k = 1; k <= 1000; ++k) trace.add(0, tick(k, k == 777 ? 99 : k == 333 ? -5 : 1));
  const json seen = window(trace, "span=1&buckets=10");
  EXPECT_EQ(seen["each"], 100);
  EXPECT_EQ(seen["missing"], 0);
  ASSERT_EQ(seen["ticks"].size(), 11U);
  EXPECT_EQ(seen["ticks"][1], 100);
  EXPECT_EQ(seen["low"]["position"][3], -5);
  EXPECT_EQ(seen["high"]["position"][3], 1);
  EXPECT_EQ(seen["high"]["position"][7], 99);
  EXPECT_FALSE(seen["low"].contains("torque")) << "an unknown value has no trace";
}

TEST_F(Traced, AShortWindowHasEveryTick) {
  for (std::int64_t k = 1; k <= 100; ++k) trace.add(0, tick(k, 0.1 * static_cast<double>(k)));
  const json seen = window(trace, "span=0.01&until=50");
  EXPECT_EQ(seen["each"], 1);
  EXPECT_EQ(seen["ticks"].front(), 40);
  EXPECT_EQ(seen["ticks"].back(), 50);
  EXPECT_EQ(seen["low"]["position"].back(), 0.1 * 50.0);
  EXPECT_FALSE(seen.contains("high"));
}

TEST_F(Traced, ATriggerIsFoundBetweenAnyTwoTicks) {
  for (std::int64_t k = 1; k <= 1000; ++k) trace.add(0, tick(k, k % 250 == 0 ? 10 : 0));
  const json last = window(trace, "span=0.1&before=0.02&signal=position&level=5");
  EXPECT_EQ(last["trigger"], 750) << "the window after tick 1000 is not complete";
  EXPECT_EQ(last["first"], 730);
  EXPECT_EQ(last["last"], 830);
  EXPECT_EQ(
      window(trace, "span=0.1&before=0.02&signal=position&level=5&after=250&pick=first")["trigger"],
      500);
  EXPECT_EQ(
      window(trace, "span=0.1&signal=position&level=5&edge=falling&after=0&pick=first")["trigger"],
      251);
  EXPECT_EQ(window(trace, "span=0.1&signal=position&level=11")["trigger"], nullptr);
}

TEST_F(Traced, AMasterTurnsInItsPeriod) {
  for (std::int64_t k = 1; k <= 1000; ++k)
    trace.add(0, tick(k, 0, 0.72 * static_cast<double>(k)));  // 120 turns in a minute, deg
  const json seen =
      window(trace, "span=1&modulo=360&signal=master&level=180&before=0&after=600&pick=first");
  EXPECT_EQ(seen["trigger"], nullptr) << "the window is not complete";
  const json first = window(trace, "span=0.2&modulo=360&signal=master&level=180&before=0.1");
  EXPECT_EQ(first["trigger"], 750);
  for (const json& value : first["low"]["master"]) {
    EXPECT_GE(value, 0);
    EXPECT_LT(value, 360);
  }
}

TEST_F(Traced, MissingTicksAreCounted) {
  for (std::int64_t k = 1; k <= 100; ++k)
    if (k < 40 || k > 49) trace.add(0, tick(k, 1));
  EXPECT_EQ(window(trace, "span=0.1")["missing"], 10);
}

TEST_F(Traced, TheRingHasTheNewestTicks) {
  constexpr auto more = static_cast<std::int64_t>(Trace::most_ticks) + 500;
  for (std::int64_t k = 0; k < more; ++k) trace.add(0, tick(k, static_cast<double>(k)));
  const auto all = trace.ticks(0, 0, more);
  ASSERT_EQ(all.size(), Trace::most_ticks - 1);
  EXPECT_EQ(all.back().tick, more - 1);
  EXPECT_EQ(all.front().tick, all.back().tick - static_cast<std::int64_t>(all.size()) + 1);
  EXPECT_EQ(all.front().values[0], static_cast<double>(all.front().tick));
  trace.clear(0);
  EXPECT_EQ(trace.newest(0), std::nullopt);
  EXPECT_TRUE(trace.ticks(0, 0, more).empty());
}

TEST_F(Traced, AnotherProcessOnlyReads) {
  trace.add(0, tick(7, 1.5));
  const auto reader = Trace::opened(trace.reading_descriptor());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->newest(0), 7);
  trace.add(0, tick(8, 2.5));
  EXPECT_EQ(reader->ticks(0, 8, 8).at(0).values[0], 2.5);
  EXPECT_FALSE(Trace::opened(-1));
}

TEST_F(Traced, TablesAreShownWithTheirPicture) {
  const auto table =
      std::make_shared<const Table>(Domain::time, Interpolation::linear, Extrapolation::hold,
                                    Columns{.x = {0, 1, 2}, .p = {0, 4, 0}, .v = {}, .a = {}});
  trace.add(0, StoredTable{content_hash(*table, {"s", "mm"}), {"s", "mm"}, table});
  const json seen = json::parse(tables_json(trace, {"feeder"}))["tables"];
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0]["axis"], "feeder");
  EXPECT_EQ(seen[0]["hash"], hex(content_hash(*table, {"s", "mm"})));
  EXPECT_EQ(seen[0]["unit"], "mm");
  EXPECT_EQ(seen[0]["position"].size(), TraceTable::samples);
  EXPECT_EQ(seen[0]["position"].back(), 0);
}

TEST_F(Traced, AGroupHasItsPlannedPath) {
  const auto path = [&](const std::string& query) {
    return json::parse(path_json(trace, 0, {.query = query}));
  };
  EXPECT_EQ(path(""), (json{{"ok", true}, {"number", 0}}));
  TracePath planned{.coordinates = 2, .points = 3, .origin = 7};
  planned.names[0] = {'x'};
  planned.names[1] = {'y'};
  planned.unit = {'m', 'm'};
  planned.at[1] = 5;
  planned.at[2] = 8;
  planned.places[0][1] = 4;
  trace.set(0, planned);
  const json seen = path("seen=0");
  EXPECT_EQ(seen["number"], 1);
  EXPECT_THAT(seen["names"], ElementsAre("x", "y"));
  EXPECT_EQ(seen["unit"], "mm");
  EXPECT_EQ(seen["origin"], 7);
  EXPECT_THAT(seen["at"], ElementsAre(0, 5, 8));
  EXPECT_THAT(seen["places"], ElementsAre(json{0.0, 4.0, 0.0}, json{0.0, 0.0, 0.0}));
  EXPECT_EQ(path("seen=1"), (json{{"ok", true}, {"number", 1}})) << "nothing new";
  trace.set(0, planned);
  EXPECT_EQ(path("seen=1")["number"], 2);
}

std::string error_of(const std::string& query) {
  try {
    static_cast<void>(scope_query({.query = query}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ScopeQuery, NumbersOutOfRangeAreRejected) {
  EXPECT_THAT(error_of("span=0"), HasSubstr("span"));
  EXPECT_THAT(error_of("buckets=1e9"), HasSubstr("must be a number from 0 to 4000"));
  EXPECT_THAT(error_of("signal=force"), HasSubstr("must be one of position, actual position"));
  EXPECT_THAT(error_of("signal=position&edge=up"), HasSubstr("must be rising or falling"));
  EXPECT_THAT(error_of("span=1&signal=position&before=2"), HasSubstr("before"));
  EXPECT_EQ(error_of("signal=following%20error&level=-1e3"), "");
}

}  // namespace
}  // namespace jounce::web::scope_test

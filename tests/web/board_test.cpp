// SPDX-License-Identifier: Apache-2.0
#include "web/src/board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/command/cause.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

wire::Status at(std::int64_t tick, double position) {
  return {.state = State::discrete_motion,
          .tick = tick,
          .cycle_ns = 1'000'000,
          .slave_position = position,
          .slave_velocity = 2,
          .units = {"s", "mm"}};
}

json next(const Board& board, std::int64_t& seen, Nanos now = 0s) {
  return json::parse(board.json_since(seen, now));
}

TEST(Board, DistinguishesAnAxisWithoutStatus) {
  Board board({"feeder", "knife"});
  board.take("feeder", at(10, 1.5), 3s);
  std::int64_t seen = 0;
  const json axes = next(board, seen, 5s)["axes"];
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes[0]["name"], "feeder");
  EXPECT_EQ(axes[0]["state"], "discrete_motion");
  EXPECT_EQ(axes[0]["unit"], "mm");
  EXPECT_EQ(axes[0]["heard"], 2.0);
  EXPECT_EQ(axes[0]["fault"], nullptr);
  EXPECT_EQ(axes[1]["name"], "knife");
  EXPECT_EQ(axes[1]["heard"], nullptr);
  EXPECT_TRUE(axes[1]["samples"].empty());
}

TEST(Board, GivesEachReaderEachSampleOnce) {
  Board board({"feeder"});
  board.take("feeder", at(1, 1), 0s);
  board.take("feeder", at(2, 2), 0s);
  std::int64_t early = 0, late = 0;
  EXPECT_EQ(next(board, early)["axes"][0]["samples"].size(), 2U);
  EXPECT_EQ(next(board, early)["axes"][0]["samples"].size(), 0U);
  board.take("feeder", at(3, 3), 0s);
  const json samples = next(board, early)["axes"][0]["samples"];
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0], (json{0.003, 3.0, 2.0, nullptr}));  // no drive: no following error
  EXPECT_EQ(next(board, late)["axes"][0]["samples"].size(), 3U);
}

TEST(Board, AGroupHasItsPlaceOnThePath) {
  Board board({"plotter", "x"});
  std::int64_t seen = 0;
  wire::GroupStatus group{.boot = 7, .tick = 1, .axes = {"x", "y"}, .place = {1, 2}};
  board.take("plotter", group);
  EXPECT_EQ(next(board, seen)["axes"][0]["group"], nullptr) << "before its first status";
  wire::Status status = at(1, 1);
  status.boot = 7;
  board.take("plotter", status, 0s);
  group.length = 400;
  group.line = 12;
  board.take("plotter", group);
  const json axes = next(board, seen)["axes"];
  EXPECT_EQ(axes[0]["group"]["length"], 400.0);
  EXPECT_EQ(axes[0]["group"]["line"], 12);
  EXPECT_EQ(axes[0]["group"]["remaining"], nullptr);
  EXPECT_EQ(axes[0]["group"]["place"], (json{1.0, 2.0}));
  EXPECT_EQ(axes[1]["group"], nullptr);
  EXPECT_EQ(board.group("plotter").axes, (std::vector<std::string>{"x", "y"}));
  EXPECT_TRUE(board.group("x").axes.empty());
}

TEST(Board, ListsEventsOfAllTicksWithTheirRemedy) {
  Board board({"feeder"});
  const auto tick = [](std::int64_t number, State state) {
    return TraceTick{.tick = number, .state = state};
  };
  TraceTick refused = tick(11, State::standstill);
  refused.refused = Cause::velocity_limit;
  TraceTick moving = tick(12, State::discrete_motion);
  TraceTick failed = tick(13, State::error_stop);
  failed.fault = Cause::following_error;
  failed.reason = Cause::following_error;
  board.take("feeder", {tick(10, State::standstill), refused, moving}, 1'000'000);
  board.take("feeder", {failed, tick(14, State::error_stop)}, 1'000'000);
  board.take("stranger", {tick(10, State::standstill)}, 1'000'000);
  std::int64_t seen = 0;
  const json log = next(board, seen)["log"];
  std::vector<std::string> kinds;
  for (const json& event : log) kinds.push_back(event["kind"]);
  EXPECT_THAT(kinds, testing::ElementsAre("state", "rejected", "state", "state", "fault"));
  EXPECT_EQ(log[1]["name"], "velocity_limit");
  EXPECT_DOUBLE_EQ(log[1]["time"], 0.011);
  EXPECT_EQ(log[4]["text"], meaning(Cause::following_error));
  EXPECT_NE(log[4]["remedy"], "");
  EXPECT_TRUE(next(board, seen)["log"].empty()) << "each reader gets each event once";
}

TEST(Board, TakesNothingOldAndNothingOfOthers) {
  Board board({"feeder"});
  board.take("feeder", at(5, 5), 0s);
  board.take("feeder", at(5, 6), 0s);
  board.take("feeder", at(4, 4), 0s);
  board.take("stranger", at(9, 9), 0s);
  std::int64_t seen = 0;
  const json axes = next(board, seen)["axes"];
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_EQ(axes[0]["position"], 5.0);
  EXPECT_EQ(axes[0]["samples"].size(), 1U);
  EXPECT_TRUE(board.has("feeder"));
  EXPECT_FALSE(board.has("stranger"));
}

TEST(Board, ContinuesWhereTheExecutorWasStartedAgain) {
  Board board({"feeder"});
  wire::Status status = at(1000, 1);
  status.boot = 1;
  board.take("feeder", status, 0s);
  status = at(3, 7);
  status.boot = 2;
  board.take("feeder", status, 0s);
  std::int64_t seen = 0;
  EXPECT_EQ(next(board, seen)["axes"][0]["position"], 7.0);
}

TEST(Board, ForgetsTheOldestSamples) {
  Board board({"feeder"});
  const auto most = static_cast<std::int64_t>(Board::most_samples);
  for (std::int64_t tick = 1; tick <= most + 10; ++tick) board.take("feeder", at(tick, 0), 0s);
  std::int64_t seen = 0;
  const json samples = next(board, seen)["axes"][0]["samples"];
  ASSERT_EQ(samples.size(), Board::most_samples);
  EXPECT_NEAR(samples[0][0].get<double>(), 0.011, 1e-12);
}

TEST(Board, ShowsAFaultWithNumberNameAndMeaning) {
  Board board({"feeder"});
  wire::Status status = at(1, 0);
  status.last_error = static_cast<std::int32_t>(Cause::following_error);
  board.take("feeder", status, 0s);
  std::int64_t seen = 0;
  const json fault = next(board, seen)["axes"][0]["fault"];
  EXPECT_EQ(fault["number"], 6);
  EXPECT_EQ(fault["name"], "following_error");
  EXPECT_EQ(fault["meaning"], meaning(Cause::following_error));
}

TEST(Board, KeepsALimitedNumberOfMasters) {
  Board board({"knife"});
  wire::Status status = at(10, 1.5);
  status.boot = 5;
  board.take("knife", status, 3s);
  for (int i = 0; i < 1000; ++i)
    board.take("knife", wire::MasterStatus{5, "m" + std::to_string(i), "mm", 10 + i, true});
  std::int64_t seen = 0;
  const json masters = next(board, seen, 5s)["axes"][0]["masters"];
  EXPECT_EQ(masters.size(), Board::most_masters);
  EXPECT_EQ(masters[masters.size() - 1]["name"], "m999") << "the newest stay";
}

TEST(Board, ListsTheMastersOfAnAxis) {
  Board board({"knife"});
  wire::Status status = at(10, 1.5);
  status.boot = 5;
  board.take("knife", status, 3s);
  board.take("knife", wire::MasterStatus{5, "web", "mm", 10, true});
  board.take("knife", wire::MasterStatus{5, "line", "mm", 10, false, 7.5, -2, 0.004, 12, 1});
  board.take("knife", wire::MasterStatus{4, "old", "mm", 10, true});
  std::int64_t seen = 0;
  const json masters = next(board, seen, 5s)["axes"][0]["masters"];
  ASSERT_EQ(masters.size(), 2U) << "nothing of another boot";
  EXPECT_EQ(masters[0]["name"], "line");
  EXPECT_EQ(masters[0]["position"], 7.5);
  EXPECT_EQ(masters[0]["age_ms"], 4);
  EXPECT_EQ(masters[1]["lost"], true);
  EXPECT_EQ(masters[1]["position"], nullptr);
}

}  // namespace
}  // namespace jounce::web

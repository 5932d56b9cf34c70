// SPDX-License-Identifier: Apache-2.0
// Axes that are to start together: they begin in one tick or not at all, also where their streamer dies. The test reads
// the motion from the tick logs.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/stream/detail/group.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

namespace jounce::group_start_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

const Units in_mm{.x = "s", .position = "mm"};
const std::string names[] = {"x", "y"};

std::filesystem::path log_of(const std::string& name) {
  return std::filesystem::temp_directory_path() /
         ("jounce-group-" + std::to_string(::getpid()) + "-" + name + ".csv");
}

std::vector<ExecutorOptions> logged() {
  std::vector<ExecutorOptions> axes;
  for (const std::string& name : names) {
    axes.push_back(axis_named(name, limits(1000, 1e5), {"", "mm"}));
    axes.back().log = log_of(name);
  }
  return axes;
}

/// The motion in a log.
struct Seen {
  std::int64_t began = -1;  ///< first tick with a job
  double furthest = 0;      ///< u
};

Seen seen_in(const std::string& name) {
  std::ifstream file(log_of(name));
  Seen seen;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<std::string> all;
    for (std::string cell; std::getline(cells, cell, ',');) all.push_back(cell);
    if (seen.began < 0 && all.at(8) != "0") seen.began = std::stoll(all[0]);
    seen.furthest = std::max(seen.furthest, std::abs(std::stod(all.at(5))));
  }
  return seen;
}

/// Two axes, and a streamer that arms both, sends their starts, and dies.
struct Pair : Site {
  Pair() : Site(logged(), {.recorded = true}) {}
  ~Pair() {
    for (const std::string& name : names) std::filesystem::remove(log_of(name));
  }

  using Deliver = std::function<bool(wire::Message&)>;

  /// `deliver` sees each start first, may change it, and returns whether it arrives.
  void start_and_die(const Deliver& deliver) {
    Group group(plans(), 4711, {.lead = 200ms});
    for (const std::string& name : names)
      for (const auto lane : {wire::Lane::reply, wire::Lane::status})
        link.subscribe(wire::channel(name, lane), 64);
    Rejects rejects;
    int starts = 0;
    for (int i = 0; i < 5000 && starts < 2; ++i) {
      for (wire::Message& message : group.poll(clock())) {
        const bool start = std::holds_alternative<wire::Start>(message.body);
        starts += start ? 1 : 0;
        if (!start || deliver(message)) send_message(link, message);
      }
      while (const auto message = next_message(link, 0ns, rejects))
        group.receive(*message, clock());
      advance(1ms);
    }
    ASSERT_EQ(starts, 2) << "not armed";
  }

  static std::vector<StreamPlan> plans() {
    const TablePtr table = trapezoid_table(50, 100, 1000, 1000);
    return {{.executor = "x", .tables = {{*table, in_mm}}},
            {.executor = "y", .tables = {{*table, in_mm}}}};
  }

  /// The run is over, its logs are written, and each axis does the same again from its record alone.
  void ends() {
    advance(3s);
    EXPECT_TRUE(replayed().same());
  }
};

void none_moves(const Pair::Deliver& deliver) {
  Pair site;
  site.start_and_die(deliver);
  site.ends();
  for (const std::string& name : names) EXPECT_EQ(seen_in(name).furthest, 0) << name;
}

TEST(GroupStart, BeginsInOneTickThoughItsStreamerIsDead) {
  Pair site;
  site.start_and_die([](const wire::Message&) { return true; });
  site.ends();
  const Seen x = seen_in("x"), y = seen_in("y");
  EXPECT_GT(x.began, 0);
  EXPECT_EQ(x.began, y.began);
  EXPECT_GT(x.furthest, 10);
  EXPECT_EQ(x.furthest, y.furthest);
}

TEST(GroupStart, NoneMovesWhereOneStartIsLost) {
  for (const std::string& lost : names)
    none_moves([&](const wire::Message& message) { return message.executor != lost; });
}

TEST(GroupStart, NoneMovesWhereOneStartIsRejected) {
  for (const std::string& late : names)
    none_moves([&](wire::Message& message) {
      if (message.executor == late) std::get<wire::Start>(message.body).tick = 1;
      return true;
    });
}

TEST(GroupStart, NoneMovesWhereTheirTicksDiffer) {
  for (const std::string& later : names)
    none_moves([&](wire::Message& message) {
      if (message.executor == later) std::get<wire::Start>(message.body).tick += 20;
      return true;
    });
}

// The stop is over when the other axis's start comes.
TEST(GroupStart, NoneMovesWhereOneWasStoppedBeforeTheStart) {
  for (const auto mode : {wire::StopMode::stop, wire::StopMode::abort})
    for (const std::string& stopped : names) {
      Pair site;
      MemoryTransport operators{site.network};
      site.start_and_die([&](const wire::Message& message) {
        if (message.executor == "x") {
          EXPECT_TRUE(operator_stop(operators, stopped, mode, 2s, {}, site.clock));
          site.advance(50ms);
        }
        return true;
      });
      site.ends();
      for (const std::string& name : names)
        EXPECT_EQ(seen_in(name).furthest, 0) << name << ", stopped: " << stopped;
    }
}

TEST(GroupStart, AnotherSessionStartsBothAfterwards) {
  Pair site;
  site.start_and_die([](const wire::Message& message) { return message.executor == "x"; });
  site.advance(2s);
  for (const StreamOutcome& outcome : stream_group(site.link, Pair::plans(), {}, {}, site.clock))
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
  site.ends();
  EXPECT_EQ(seen_in("x").began, seen_in("y").began);
  EXPECT_EQ(seen_in("x").furthest, 50);
}

}  // namespace
}  // namespace jounce::group_start_test

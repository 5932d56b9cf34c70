// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/mpi_world.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/src/sweep/mpi_calls.hpp"
#include "support/errors.hpp"

namespace jounce::mpi_world_test {
namespace {

/// Ranks as threads of this process, in place of MPI: who calls is known by the thread.
struct Post {
  std::mutex mutex;
  std::condition_variable arrived;
  std::map<int, std::deque<std::pair<int, std::string>>> boxes;
  std::size_t sent = 0;  ///< orders of the first rank
};
Post post;
thread_local int me = 0;

void send(int to, const std::string& bytes) {
  const std::lock_guard lock(post.mutex);
  post.boxes[to].emplace_back(me, bytes);
  post.sent += me == 0 ? 1 : 0;
  post.arrived.notify_all();
}

int receive(std::string& bytes) {
  std::unique_lock lock(post.mutex);
  auto& box = post.boxes[me];
  post.arrived.wait(lock, [&] { return !box.empty(); });
  const int from = box.front().first;
  bytes = box.front().second;
  box.pop_front();
  return from;
}

const study_detail::MpiCalls calls{nullptr, send, receive, nullptr, nullptr};

std::vector<std::size_t> first(std::size_t n) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < n; ++i) all.push_back(i);
  return all;
}

/// Runs a world of `size`; answers what rank 0 took.
std::map<std::size_t, std::string> taken(int size, std::size_t cases, std::size_t most) {
  post.boxes.clear();
  std::vector<std::jthread> workers;
  for (int rank = 1; rank < size; ++rank)
    workers.emplace_back([rank, size, cases] {
      me = rank;
      farm_over(calls, rank, size, "id")(
          first(cases), [](std::size_t k) { return "case " + std::to_string(k); },
          [](std::size_t, const std::string&) { return false; });
    });
  std::map<std::size_t, std::string> all;
  me = 0;
  farm_over(calls, 0, size, "id")(
      first(cases), [](std::size_t k) { return "case " + std::to_string(k); },
      [&](std::size_t k, const std::string& line) {
        EXPECT_TRUE(all.emplace(k, line).second) << k << " is taken twice";
        return all.size() < most;
      });
  return all;
}

TEST(MpiFarm, HandsOutEachCaseOnce) {
  for (const int size : {2, 4, 9})
    for (const std::size_t cases : {0U, 1U, 3U, 200U}) {
      const auto all = taken(size, cases, cases + 1);
      EXPECT_EQ(all.size(), cases);
      for (const auto& [k, line] : all) EXPECT_EQ(line, "case " + std::to_string(k));
    }
}

TEST(MpiFarm, StopsWhenNoMoreIsWantedAndTakesWhatWasBegun) {
  const auto all = taken(4, 2000, 10);
  EXPECT_GE(all.size(), 10U);
  EXPECT_LE(all.size(), 10U + 3 * 65 + 1);  // at most the cases of three workers, and one here
}

/// Cheap cases go out many in a message, dear ones one by one; each worker's lines come back one by one.
TEST(MpiFarm, SendsCheapCasesTogetherAndDearOnesOneByOne) {
  const auto orders = [](std::chrono::milliseconds each) {
    post.boxes.clear();
    post.sent = 0;
    constexpr std::size_t cases = 60;
    const auto make = [each](std::size_t k) {
      std::this_thread::sleep_for(each);
      return std::to_string(k);
    };
    std::jthread worker([&] {
      me = 1;
      farm_over(calls, 1, 2, "id")(first(cases), make,
                                   [](std::size_t, const std::string&) { return false; });
    });
    me = 0;
    std::size_t lines = 0;
    farm_over(calls, 0, 2, "id")(first(cases), make,
                                 [&](std::size_t, const std::string&) { return ++lines > 0; });
    EXPECT_EQ(lines, cases);
    return post.sent;  // to the worker
  };
  EXPECT_LT(orders(std::chrono::milliseconds(1)), 40U);  // 30 or so cases are the worker's
  EXPECT_GE(orders(std::chrono::milliseconds(25)), 20U);
}

TEST(MpiFarm, EndsWhereACaseThrowsOnTheFirstRank) {
  post.boxes.clear();
  std::atomic<bool> begun = false;  // the first rank has a case, before the worker has done all
  std::jthread worker([&] {
    me = 1;
    farm_over(calls, 1, 2, "id")(
        first(50),
        [&](std::size_t) {
          begun.wait(false);
          return "x";
        },
        [](std::size_t, const std::string&) { return false; });
  });
  me = 0;
  EXPECT_THAT(test::error_of([&] {
                farm_over(calls, 0, 2, "id")(
                    first(50),
                    [&](std::size_t) -> std::string {
                      begun = true;
                      begun.notify_all();
                      throw InputError("case", "", "is bad");
                    },
                    [](std::size_t, const std::string&) { return true; });
              }),
              ::testing::HasSubstr("case"));
}

TEST(MpiFarm, RejectsAWorkerWithOtherFiles) {
  post.boxes.clear();
  post.boxes[0].emplace_back(1, "other");
  me = 0;
  EXPECT_THAT(test::error_of([] {
                farm_over(calls, 0, 2, "id")(
                    first(3), [](std::size_t) { return ""; },
                    [](std::size_t, const std::string&) { return true; });
              }),
              ::testing::HasSubstr("rank 1 reads another sweep"));
}

}  // namespace
}  // namespace jounce::mpi_world_test

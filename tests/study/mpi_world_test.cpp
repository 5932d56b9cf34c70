#include "jounce/study/mpi_world.hpp"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/study/detail/mpi_calls.hpp"

#include "support/errors.hpp"

namespace jounce {
namespace {

/// Ranks as threads of this process, in place of MPI: who calls is known by the thread.
struct Post {
  std::mutex mutex;
  std::condition_variable arrived;
  std::map<int, std::deque<std::pair<int, std::string>>> boxes;
};
Post post;
thread_local int me = 0;

void send(int to, const std::string& bytes) {
  const std::lock_guard lock(post.mutex);
  post.boxes[to].emplace_back(me, bytes);
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

const detail::MpiCalls calls{nullptr, send, receive, nullptr, nullptr};

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
      first(cases),
      [](std::size_t) -> std::string {
        ADD_FAILURE() << "the first rank makes nothing";
        return "";
      },
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
  const auto all = taken(4, 200, 10);
  EXPECT_GE(all.size(), 10U);
  EXPECT_LE(all.size(), 12U);
}

TEST(MpiFarm, RefusesAWorkerWithOtherFiles) {
  post.boxes.clear();
  post.boxes[0].emplace_back(1, "other");
  me = 0;
  EXPECT_THAT(testing::error_of([] {
                farm_over(calls, 0, 2, "id")(
                    first(3), [](std::size_t) { return ""; },
                    [](std::size_t, const std::string&) { return true; });
              }),
              ::testing::HasSubstr("rank 1 reads another sweep"));
}

}  // namespace
}  // namespace jounce

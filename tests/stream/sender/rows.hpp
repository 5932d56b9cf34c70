// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "jounce/stream/detail/row_sender.hpp"

#include "stream/harness.hpp"

/// Rows to be streamed, where they come from, and an executor that plays them.
namespace jounce::test {

/// Row number i, from 0: 16 ms long.
inline wire::Row row(std::size_t i, bool last = false) {
  const double x = 0.016 * static_cast<double>(i + 1);
  return {.x_end = x, .p_end = std::sin(x), .v_start = 1, .v_end = 1, .last = last};
}

inline wire::Queue queue_of(std::uint32_t capacity, std::uint32_t prefill = 1) {
  return {.units = {"s", "mm"}, .capacity = capacity, .prefill = prefill};
}

/// An executor that plays rows at a steady pace, and reports starving when it has none.
class Player {
 public:
  Player(World& world, Nanos each) : world_(world), each_(each) {
    world.each_turn = [this] { turn(); };
  }
  std::size_t played = 0, most_waiting = 0;
  int starved = 0;

 private:
  void turn() {
    auto& executor = *world_.executor;
    most_waiting = std::max(most_waiting, executor.rows.size() - played);
    if (!executor.queue_started) begun_ = world_.now;
    if (!executor.queue_started || finished_) return;
    auto progress = wire::Progress::running;
    while (world_.now - begun_ >= each_ && !finished_) {
      if (played == executor.rows.size()) {
        progress = wire::Progress::starving;
        starved += starving_ ? 0 : 1;
        starving_ = true;
        begun_ = world_.now;
        break;
      }
      starving_ = false;
      finished_ = executor.rows[played++].last;
      begun_ += each_;
    }
    if (starving_) progress = wire::Progress::starving;
    if (finished_) progress = wire::Progress::done;
    executor.pump.receiver().level(
        wire::first_queue,
        {.freed = {played, 0}, .played = static_cast<std::int64_t>(played), .progress = progress});
  }

  World& world_;
  Nanos each_, begun_{};
  bool finished_ = false, starving_ = false;
};

/// The first `count` of `all` rows, as fast as they are wanted, then none.
inline RowSource source_of(std::size_t count, std::size_t all) {
  return [=, next = std::size_t{0}](std::size_t most) mutable {
    std::vector<wire::Row> rows;
    for (; next < count && rows.size() < most; ++next) rows.push_back(row(next, next + 1 == all));
    return rows;
  };
}
inline RowSource source_of(std::size_t count) {
  return source_of(count, count);
}

}  // namespace jounce::test

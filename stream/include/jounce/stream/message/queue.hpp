// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

/// Queues of rows: what is played while more of it arrives. A rolling stream is a dynamic queue, for
/// motions longer than memory or computed on the fly; Googol's FIFOs are its banks.
///
///     Queue{.queue = 64, .units = {"s", "mm"}, .capacity = 1024, .prefill = 200,
///           .origin = 120, .lowest = 0, .highest = 80};   // from 120 mm, and never beyond 200 mm
///     Rows{.queue = 64, .rows = {{.x_end = 0.1, .p_end = 2, .v_end = 40, .order = RowOrder::cubic}}};
///
/// **Origin and range.** A queue announces its origin and its range. An axis that stands elsewhere, or whose
/// range is narrower, refuses it; rows that leave the announced range are refused, or the axis stops.
///
/// u: the unit of p, m: that of x (s over time).
namespace jounce::wire {

inline constexpr std::size_t rows_each = 200;     ///< rows of one message: 12.8 KB
inline constexpr std::uint32_t first_queue = 64;  ///< first queue of a queue's index
inline constexpr std::uint32_t last_queue = 127;  ///< below are tables

/// Curve of a row between its ends.
enum class RowOrder : std::int8_t {
  linear = 1,     ///< from p alone
  quadratic = 2,  ///< from p and one v, at whichever end is given; NaN: it is left open. With both
                  ///< open it goes on at the v at which the row before ended
  cubic = 3,      ///< from p and v at both ends
  quintic = 5,    ///< from p, v and a at both ends
};

/// One piece of the curve. x and p count from the origin of its bank, 0 there, and so the ends of a
/// row are the beginnings of the next one.
struct Row {
  double x_end = 0;    ///< m, greater than that of the row before
  double p_end = 0;    ///< u
  double v_start = 0;  ///< u/m
  double v_end = 0;    ///< u/m
  double a_start = 0;  ///< u/m^2
  double a_end = 0;    ///< u/m^2
  RowOrder order = RowOrder::cubic;
  bool last = false;  ///< the stream ends here, at rest

  bool operator==(const Row&) const = default;
};

enum class QueueMode : std::int8_t {
  static_ = 0,  ///< two banks; each is filled, played as a whole, and stays until it is cleared
  dynamic = 1,  ///< both banks are one stream, sent as bank 0; played rows free space
};

/// Start event of a queue over master, with Googol's codes.
enum class QueueEvent : std::int8_t { start = 1, pass = 2 };

/// Opens a queue, and like a Header the session where it is the first.
struct Queue {
  std::uint32_t queue = first_queue;  ///< index within the session, 64...127
  Domain axis = Domain::time;
  Units units{};
  QueueMode mode = QueueMode::dynamic;
  std::uint32_t capacity = 1024;  ///< rows of each of the two banks, >= 2
  std::int32_t loops = 1;         ///< loops of a static bank; below 1: endless
  QueueEvent event = QueueEvent::start;
  double event_position = 0;        ///< m, with pass
  std::int8_t event_direction = 0;  ///< 1 or -1 with pass
  std::uint32_t prefill = 1;        ///< rows without which it does not start
  /// False: the axis must stand at `origin`, where the first row begins. True: the rows count from
  /// where the axis stands.
  bool relative = false;
  double origin = 0;          ///< u; 0 where it is relative
  double lowest = -no_bound;  ///< u, of the whole motion, from where it begins: <= 0
  double highest = no_bound;  ///< u, likewise: >= 0

  static constexpr double no_bound = std::numeric_limits<double>::infinity();
};
bool operator==(const Queue& a, const Queue& b);

/// Some rows for a bank.
struct Rows {
  std::uint32_t queue = first_queue;
  std::uint8_t bank = 0;        ///< 0 or 1; 0 in a dynamic queue
  std::uint32_t seq = 0;        ///< from 0, within queue and bank; goes on after a clear
  std::uint64_t first_row = 0;  ///< rows of this bank in all messages before
  std::vector<Row> rows{};      ///< 1...200
};

/// Error of a queue, as a sentence; empty: none.
std::string contradiction(const Queue& queue);

/// Rows that a queue holds in a bank, as its mode counts them.
std::uint32_t room(const Queue& queue);

}  // namespace jounce::wire

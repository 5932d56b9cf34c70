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

/// Queues of rows, which an axis plays while more rows arrive. A rolling stream is a dynamic queue,
/// for motions longer than memory or computed on the fly; its banks are Googol's FIFOs.
///
///     Queue{.queue = 64, .units = {"s", "mm"}, .capacity = 1024, .prefill = 200,
///           .origin = 120, .lowest = 0, .highest = 80};   // from 120 mm, at most to 200 mm
///     Rows{.queue = 64,
///          .rows = {{.x_end = 0.1, .p_end = 2, .v_end = 40, .order = RowOrder::cubic}}};
///
/// **Origin and range.** A queue announces its origin and its range. An axis rejects it if it
/// stands elsewhere, or if its own range is narrower. Rows that leave the announced range are
/// rejected, or the axis stops.
///
/// u: the unit of p, m: that of x (s over time).
namespace jounce::wire {

inline constexpr std::size_t rows_each = 200;     ///< rows of one message: 12.8 KB
inline constexpr std::uint32_t first_queue = 64;  ///< first index of a queue; tables are below
inline constexpr std::uint32_t last_queue = 127;  ///< last index of a queue

/// Curve of a row between its ends.
enum class RowOrder : std::int8_t {
  linear = 1,     ///< from p alone
  quadratic = 2,  ///< from p and one v, given at either end; NaN at the other. With both NaN, it
                  ///< continues at the end v of the previous row
  cubic = 3,      ///< from p and v at both ends
  quintic = 5,    ///< from p, v and a at both ends
};

/// One piece of the curve. x and p are relative to the origin of its bank, with 0 there. The end of
/// a row is the beginning of the next one.
struct Row {
  double x_end = 0;    ///< m, greater than that of the previous row
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
  static_ = 0,  ///< two banks; each is filled, played as a whole, and kept until it is cleared
  dynamic = 1,  ///< both banks are one stream, sent as bank 0; played rows free space
};

/// Start event of a queue over master, with Googol's codes.
enum class QueueEvent : std::int8_t { start = 1, pass = 2 };

/// Opens a queue, and, like a Header, the session if it is the first.
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
  std::uint32_t prefill = 1;        ///< least number of rows for its start
  /// False: the axis must stand at `origin`, the start of the first row. True: rows are relative to
  /// the position of the axis.
  bool relative = false;
  double origin = 0;          ///< u; 0 if relative
  double lowest = -no_bound;  ///< u, of the whole motion, relative to its start: <= 0
  double highest = no_bound;  ///< u, likewise: >= 0

  static constexpr double no_bound = std::numeric_limits<double>::infinity();
};
bool operator==(const Queue& a, const Queue& b);

/// Some rows for a bank.
struct Rows {
  std::uint32_t queue = first_queue;
  std::uint8_t bank = 0;        ///< 0 or 1; 0 in a dynamic queue
  std::uint32_t seq = 0;        ///< from 0, within queue and bank; continues after a clear
  std::uint64_t first_row = 0;  ///< rows of this bank in all previous messages
  std::vector<Row> rows{};      ///< 1...200
};

/// Error of a queue, as a sentence; empty: none.
std::string contradiction(const Queue& queue);

/// Number of rows in a bank of the queue, depending on its mode.
std::uint32_t room(const Queue& queue);

}  // namespace jounce::wire

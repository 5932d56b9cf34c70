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

/// Queues of rows, which an axis plays while more rows arrive. A rolling stream is a dynamic queue.
/// Use it for motions that are longer than the memory, or that are computed during the motion. The
/// banks of a queue are Googol's FIFOs.
///
///     Queue{.queue = 64, .units = {"s", "mm"}, .capacity = 1024, .prefill = 200,
///           .origin = 120, .lowest = 0, .highest = 80};   // from 120 mm, at most to 200 mm
///     Rows{.queue = 64,
///          .rows = {{.x_end = 0.1, .p_end = 2, .v_end = 40, .order = RowOrder::cubic}}};
///
/// **Origin and range.** A queue announces its origin and its range of positions. An axis rejects
/// the queue if the axis does not stand at the origin, or if its own position range does not
/// contain the announced range. Rows that leave the announced range are rejected. If the axis would
/// leave the range for another reason, it stops.
///
/// **Units**: u is the unit of the position p, m the unit of x (s over time).
namespace jounce::wire {

inline constexpr std::size_t rows_each = 200;  ///< greatest number of rows in a message: 12.8 KB
/// First index of a queue; tables have lower indices.
inline constexpr std::uint32_t first_queue = 64;
inline constexpr std::uint32_t last_queue = 127;  ///< last index of a queue

/// The polynomial of a row between its two ends.
enum class RowOrder : std::int8_t {
  linear = 1,  ///< given by p at both ends
  /// Given by p at both ends and one of v_start and v_end; the other is NaN. If both are NaN, the
  /// row begins at the velocity at the end of the previous row.
  quadratic = 2,
  cubic = 3,    ///< given by p and v at both ends
  quintic = 5,  ///< given by p, v and a at both ends
};

/// One piece of the curve. It begins at the end of the previous row. x and p count from the origin
/// of the bank.
struct Row {
  /// end of the row, m, greater than the end of the previous row
  double x_end = 0;
  double p_end = 0;                  ///< position at the end, u
  double v_start = 0;                ///< velocity at the start, u/m
  double v_end = 0;                  ///< velocity at the end, u/m
  double a_start = 0;                ///< acceleration at the start, u/m^2
  double a_end = 0;                  ///< acceleration at the end, u/m^2
  RowOrder order = RowOrder::cubic;  ///< the polynomial
  bool last = false;                 ///< true: the stream ends with this row, at rest

  bool operator==(const Row&) const = default;
};

/// Use of the two banks.
enum class QueueMode : std::int8_t {
  /// Two tables: each bank is filled, played as a whole, and kept until it is cleared.
  static_ = 0,
  /// One stream: all rows are sent to bank 0, and rows that were played free their space.
  dynamic = 1,
};

/// Start of a queue over a master: at once (start), or when the master passes a position (pass).
/// The numbers are Googol's.
enum class QueueEvent : std::int8_t { start = 1, pass = 2 };

/// Opens a queue. As the first message of a session, it also opens the session.
struct Queue {
  std::uint32_t queue = first_queue;    ///< index of the queue in the session, 64 to 127
  Domain axis = Domain::time;           ///< variable of the queue
  Units units{};                        ///< units of x and of the position
  QueueMode mode = QueueMode::dynamic;  ///< use of the banks
  std::uint32_t capacity = 1024;        ///< rows in each of the two banks, 2 to 2^30
  std::int32_t loops = 1;  ///< passes of a static bank; below 1: endless; 1 in a dynamic queue
  QueueEvent event = QueueEvent::start;  ///< start condition, over a master
  double event_position = 0;             ///< for pass: position of the master, m; otherwise 0
  std::int8_t event_direction = 0;  ///< for pass: direction of the master, 1 or -1; otherwise 0
  /// Number of rows that a start requires, from 1 to the capacity (of both banks in a dynamic
  /// queue); fewer rows are enough if the stream ends with them.
  std::uint32_t prefill = 1;
  /// False: the axis must stand at `origin`, the start of the first row. True: rows count from the
  /// position of the axis at the start.
  bool relative = false;
  double origin = 0;  ///< start of the first row, u; 0 if relative
  /// Lowest position of the whole motion, relative to its start, u, <= 0.
  double lowest = -no_bound;
  /// Highest position of the whole motion, relative to its start, u, >= 0.
  double highest = no_bound;
  /// Over a master: the direction of the master that moves the slave, 1 or -1; 0: both. With 1 or
  /// -1, the slave stands still while the master moves in the other direction, and until the master
  /// is back at the position at which it turned.
  std::int8_t direction = 0;

  static constexpr double no_bound = std::numeric_limits<double>::infinity();  ///< no limit
};
bool operator==(const Queue& a, const Queue& b);

/// Some rows for a bank of a queue.
struct Rows {
  std::uint32_t queue = first_queue;  ///< index of the queue
  std::uint8_t bank = 0;              ///< 0 or 1; 0 in a dynamic queue
  /// Number of the message in its queue and bank, from 0. After a clear, the numbers continue.
  std::uint32_t seq = 0;
  std::uint64_t first_row = 0;  ///< number of rows of this bank in all previous messages
  std::vector<Row> rows{};      ///< 1 to 200 rows
};

/// Returns the error of a queue as a sentence; "" if the queue is valid.
std::string contradiction(const Queue& queue);

/// Returns the number of the variable of the queue in messages and records: 0 time, 1 travel of the
/// master, 2 its forward travel, 3 its backward travel.
std::int8_t variable_number(const Queue& queue);

/// Sets `axis` and `direction` from this number. Returns false for another number.
bool set_variable(std::int64_t number, Queue& queue);

/// Returns the number of rows for which a bank has space. In a dynamic queue, this is the space of
/// both banks.
std::uint32_t room(const Queue& queue);

}  // namespace jounce::wire

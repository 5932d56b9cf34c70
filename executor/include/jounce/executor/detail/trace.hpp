// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/tick.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/stream/receiver/stored_table.hpp"

namespace jounce {

/// The values of an axis in one tick, for traces. NaN: unknown. u is the unit of the axis, m the
/// unit of its master.
struct TraceTick {
  /// Names and quantities of the values.
  static constexpr std::array<Field, 8> signals{{{"position", Quantity::position},
                                                 {"actual position", Quantity::position},
                                                 {"following error", Quantity::position},
                                                 {"velocity", Quantity::velocity},
                                                 {"acceleration", Quantity::acceleration},
                                                 {"torque", Quantity::none},
                                                 {"master", Quantity::master},
                                                 {"master velocity", Quantity::none}}};

  std::int64_t tick = 0;                        ///< number of the tick
  std::array<double, signals.size()> values{};  ///< values in the order of `signals`
  State state = State::disabled;                ///< state of the axis
  Cause fault = Cause::none;                    ///< the latched fault
  Cause reason = Cause::none;                   ///< why the last motion ended
  Cause refused = Cause::none;                  ///< why a command of this tick was rejected
  Cause dropped = Cause::none;                  ///< why the waiting motion was dropped
};

/// Returns the values of a tick for a trace.
TraceTick trace_tick(const Tick& tick);

/// A table that an executor has received, with a picture.
struct TraceTable {
  static constexpr std::size_t samples = 240;   ///< number of samples of the picture
  static constexpr std::size_t most_unit = 24;  ///< greatest length of a unit, bytes

  std::uint64_t number = 0;  ///< number of the table, from 1; 0: none
  std::uint64_t axis = 0;    ///< index of the axis that has received it
  Sha256 hash{};             ///< its content_hash()
  std::uint64_t knots = 0;   ///< number of its knots
  Domain over = Domain::time;
  double start = 0;                        ///< first time or master position
  double end = 0;                          ///< last time or master position
  std::array<char, most_unit> x_unit{};    ///< unit of the variable, cut if it is longer
  std::array<char, most_unit> unit{};      ///< unit of the position
  std::array<double, samples> position{};  ///< position at equal distances from start to end
};

/// The planned path of a group as a polygon, for a picture. On lines it is exact. The coordinates
/// are those of the machine, without the frame of the commands. u is the unit of the axes.
struct TracePath {
  static constexpr std::size_t most_points = 4096;  ///< greatest number of points
  /// Greatest number of coordinates: the first axes of the group, or of the path of its tool.
  static constexpr std::size_t most_names = 3;
  static constexpr std::size_t most_name = 24;  ///< greatest length of a name, bytes

  std::uint64_t number = 0;       ///< number of the path, from 1; 0: none
  std::uint64_t coordinates = 0;  ///< number of coordinates
  std::uint64_t points = 0;       ///< number of points
  double origin = 0;              ///< position of the group at the start of the path, u
  std::array<std::array<char, most_name>, most_names> names{};  ///< names of the coordinates
  std::array<char, TraceTable::most_unit> unit{};               ///< unit u; "": not known
  std::array<double, most_points> at{};  ///< length along the path, from 0, u
  std::array<std::array<double, most_points>, most_names> places{};  ///< coordinates, u
};

/// Returns the path of a program as points: the ends of all pieces, and points between the ends of
/// curved pieces. A path with too many pieces has points at equal distances. A fast move of joints
/// (fast_program()) has no points. The number is 0. `origin`: see TracePath.
std::unique_ptr<TracePath> trace_path(const GroupProgram& program, const ExecutorGroup& group,
                                      double origin);

/// The last ticks of several axes, the last tables, and the paths of groups, in memory that two
/// processes can share: one writes, others read, and neither waits.
///
///     Trace trace = Trace::of(std::vector<std::int64_t>{1'000'000});            // the executor: one axis at 1 kHz
///     trace.add(0, tick);                                 // its communication thread, each tick
///     std::optional<Trace> seen = Trace::opened(descriptor);  // the page process, which only reads
///     std::vector<TraceTick> ticks = seen->ticks(0, 100, 200);
///
/// The executor adds each tick that its communication thread receives from the cycle, so the trace
/// has the rate of the cycle, and costs the cycle nothing. A reader that is slow misses ticks; it
/// never delays the writer.
class Trace {
 public:
  static constexpr std::size_t most_ticks =
      65536;  ///< greatest number for each axis: 65 s at 1 kHz
  static constexpr std::size_t most_bytes = std::size_t{16} << 20U;  ///< memory of all axes
  static constexpr std::size_t tables = 16;                          ///< number of tables

  /// New memory. `periods`: cycle of each axis, ns, > 0. Throws std::system_error.
  static Trace of(const std::vector<std::int64_t>& periods);
  /// New memory for the axes of an executor.
  static Trace of(const std::vector<ExecutorOptions>& axes);
  /// The memory of another process, for reading. Returns nullopt if the descriptor is not open or
  /// is not a trace. Owns the descriptor.
  static std::optional<Trace> opened(int descriptor);

  Trace(Trace&& other) noexcept;
  Trace& operator=(Trace&&) = delete;
  ~Trace();

  /// A descriptor that can only read the memory; the caller owns it. Throws std::system_error.
  [[nodiscard]] int reading_descriptor() const;

  /// Adds a tick. One thread of the writing process calls this. Does not allocate or wait.
  void add(std::size_t axis, const TraceTick& tick) noexcept;
  /// Removes all ticks of an axis. Call when its executor was started again.
  void clear(std::size_t axis) noexcept;
  /// Adds a table; replaces the oldest one.
  void add(std::size_t axis, const StoredTable& table);
  /// Sets the path of a group, and numbers it. One thread of the writing process calls this.
  void set(std::size_t group, TracePath& path);

  [[nodiscard]] std::size_t axes() const;
  [[nodiscard]] std::int64_t period(std::size_t axis) const;  ///< ns
  void set_period(std::size_t axis, std::int64_t ns) noexcept;
  /// The newest tick; nullopt: there is none.
  [[nodiscard]] std::optional<std::int64_t> newest(std::size_t axis) const;
  /// Returns the ticks whose numbers are from `first` to `last`, ascending. Ticks that were
  /// overwritten are missing.
  [[nodiscard]] std::vector<TraceTick> ticks(std::size_t axis, std::int64_t first,
                                             std::int64_t last) const;
  /// The tables, the newest first.
  [[nodiscard]] std::vector<TraceTable> last_tables() const;
  /// Number of the path of a group; 0: none.
  [[nodiscard]] std::uint64_t path_number(std::size_t group) const;
  /// The path of a group; null: none, or the writer replaced it during each attempt to read it.
  [[nodiscard]] std::unique_ptr<TracePath> path(std::size_t group) const;

 private:
  struct Memory;
  Trace(int descriptor, std::size_t bytes, Memory* memory);

  int descriptor_ = -1;
  std::size_t bytes_ = 0;
  Memory* memory_ = nullptr;
};

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "jounce/axis/ring.hpp"
#include "jounce/executor/detail/record.hpp"
#include "jounce/executor/recorder_options.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/receiver/stored_table.hpp"

namespace jounce {

/// A ring buffer from the cyclic thread to the recorder. It contains cycles, and the number of
/// cycles that were lost.
///
///     buffer.add(i, command, inputs, tick);        // the cyclic thread, after every step of an axis
class RecordBuffer {
 public:
  /// Greatest number of items: 16 s of one axis at 1 kHz, or 0.25 s of 64 axes.
  static constexpr std::size_t capacity = 16384;

  /// Adds a cycle of an axis. Does not allocate or wait. If the ring is full, the cycle is lost,
  /// and the loss is counted.
  void add(std::size_t axis, const Command& command, const Inputs& inputs,
           const Tick& tick) noexcept;
  /// Adds an input of a master in a cycle. Call before the add() of the master's value in this
  /// cycle.
  void add(std::size_t master, const MasterSample& sample) noexcept;
  /// Adds the value of a master in a cycle. Call before the add() of the axes in this cycle.
  void add(std::size_t master, const MasterReading& sight) noexcept;

 private:
  friend class Recorder;
  struct Item {
    enum class What : std::uint8_t { cycle, sight, sample };
    What what = What::cycle;
    RecordedCycle cycle = {};
    RecordedSight sight = {};
    RecordedSample sample = {};
    std::int64_t lost_before = 0;
  };
  void push(Item& item) noexcept;

  Ring<Item, capacity> items_;
  std::int64_t lost_ = 0;  // since the last stored item; used by the cyclic thread
};

/// Writes the record of a run, in the communication thread:
///
///     Recorder recorder({.log = "run.lcmlog", .black_box = "fault.lcmlog"}, axes, buffer);
///     recorder.job({.axis = 0, .id = id}, time_table);       // before its arm is sent to the axis
///     recorder.turn();                                       // often: empties the buffer
///     recorder.close();
///
/// **The log** is written as LOG.part, and gets its final name when it is closed. If the executor
/// is killed, LOG.part is a valid record up to some point. If the path exists and is not a regular
/// file, it is written directly. If the disk is full, the log ends with one notice, and the motion
/// continues.
///
/// **The black box** contains the last cycles of every axis. It is written at a fault of an axis,
/// and ends with the cycle of the fault. A new fault replaces the file. The file is first written
/// under a temporary name; if writing fails, the previous file stays unchanged, and one notice
/// reports the failure.
///
/// Cycles that did not fit into the buffer are recorded as lost. A replay ends at this place.
class Recorder {
 public:
  /// Throws InputError for a black box of 0 cycles, and std::system_error if the log or the black
  /// box cannot be created. `buffer` must outlive the recorder.
  Recorder(RecorderOptions options, std::vector<RecordedAxis> axes, RecordBuffer& buffer,
           std::vector<RecordedMaster> masters = {});
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Records the arguments of a Job. `time` and `cam` give the hashes of its tables. Each table is
  /// written only once.
  void job(const RecordedJob& job, const StoredTable& time, const StoredTable* cam = nullptr);
  /// Records the arguments of another movement, or a change of a queue.
  void note(const RecordEvent& event) { write(event, now_); }
  /// Writes the content of the buffer. Call often.
  void turn();
  /// Writes all remaining items, and gives the log its name. Without this call, LOG.part remains.
  void close();

  /// Reason for the first failure to write a file; "" if all files were written.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// Files that could not be written: bits of wire::Unwritten.
  [[nodiscard]] std::uint8_t unwritten() const { return unwritten_; }
  [[nodiscard]] std::int64_t lost() const { return lost_; }  ///< number of lost cycles

 private:
  /// The last encoded cycles of one axis, or sights of one master.
  struct Box {
    std::vector<std::string> kept = {};
    std::vector<std::int64_t> microseconds = {};
    std::size_t count = 0;
    Cause fault = Cause::none;
  };

  void write(const RecordEvent& event, std::int64_t microseconds);
  void write(std::string_view channel, const std::string& data, std::int64_t microseconds);
  void write(const StoredTable& table);
  void append(std::string_view channel, const std::string& data, std::int64_t microseconds);
  void write_check();
  void write_triggers(const RecordedCycle& cycle);
  void write_references(const RecordedCycle& cycle);
  void flush();
  void keep(Box& box, const std::string& data, std::int64_t microseconds);
  void watch(Box& box, const RecordedCycle& cycle);
  [[nodiscard]] std::int64_t instant_of(const RecordBuffer::Item& item) const;
  void take(const RecordBuffer::Item& item);
  void write_black_box();
  void fail(wire::Unwritten which, const std::string& what);

  RecorderOptions options_;
  std::vector<RecordedAxis> axes_;
  std::vector<RecordedMaster> masters_;
  RecordBuffer& ring_;
  std::filesystem::path part_;
  std::ofstream file_;
  std::string buffer_;
  std::int64_t number_ = 0;
  Sha256 check_{};        // checksum of the log so far
  std::int64_t now_ = 0;  // us
  std::set<Sha256> tables_;
  /// The states of the trigger inputs of each axis in the record: wired, on.
  std::map<std::size_t, std::pair<std::uint8_t, std::uint8_t>> triggers_;
  std::set<std::size_t> referenced_;  // axes with Inputs::referenced in the last cycle
  std::vector<Box> boxes_;            // black boxes of the masters, then of the axes
  std::string trouble_;
  std::uint8_t unwritten_ = 0;
  std::int64_t lost_ = 0;
};

}  // namespace jounce

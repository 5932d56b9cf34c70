// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "jounce/axis/ring.hpp"
#include "jounce/executor/record.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/receiver/table_store.hpp"

namespace jounce {

/// The ring from the cyclic thread to the record: cycles, and the number of lost ones.
///
///     tape.add(i, command, inputs, tick);          // the cyclic thread, after every step of an axis
class Tape {
 public:
  static constexpr std::size_t capacity = 16384;  ///< 16 s of one axis at 1 kHz, 0.25 s of 64

  /// Neither allocates nor waits; a cycle is lost and counted if the ring is full.
  void add(std::size_t axis, const Command& command, const Inputs& inputs,
           const Tick& tick) noexcept;
  /// Inputs of a master in the step, then its state; before its axes.
  void add(std::size_t master, const MasterSample& sample) noexcept;
  void add(std::size_t master, const MasterSight& sight) noexcept;

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
  std::int64_t lost_ = 0;  // since the last stored item; of the cyclic thread
};

struct RecorderOptions {
  std::optional<std::filesystem::path> log = {};  ///< log of the whole run; none: not kept
  std::optional<std::filesystem::path> black_box =
      {};                               ///< written when a fault comes; none: not kept
  std::size_t black_box_cycles = 2000;  ///< black box cycles of each axis, that it holds
  std::function<void(const std::string&)> notify = {};  ///< events as text
};

/// Writes what the cyclic thread did, on the side that communicates:
///
///     Recorder recorder({.log = "run.lcmlog", .black_box = "fault.lcmlog"}, axes, tape);
///     recorder.job({.axis = 0, .id = id}, time_table);         // before its arm is sent to the axis
///     recorder.turn();                                         // often: takes what is on the tape
///     recorder.close();
///
/// **The log** grows as LOG.part and has its name when it is closed: of an executor that was killed, LOG.part is a
/// record all the same, cut off somewhere. A path that exists and is no regular file is written to directly. A
/// full disk ends the log, with one `notify`, and nothing else: the motion continues.
///
/// **The black box** has the last cycles of every axis. It is written when an axis comes into a fault (each new fault
/// replaces it; its last cycle is the fault's), under a temporary name first: a disk that refuses leaves the one
/// before as it was, and is reported once by `notify`.
///
/// What was lost on the way to the tape is written as such: a replay ends there.
class Recorder {
 public:
  /// Throws InputError for a black box of 0 cycles, std::system_error where the log or the black box
  /// cannot be made.
  Recorder(RecorderOptions options, std::vector<RecordedAxis> axes, Tape& tape,
           std::vector<RecordedMaster> masters = {});
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Parts of a Job, with the arguments of its constructor; its tables' hashes are taken from
  /// where they are kept. Each table is written once.
  void job(const RecordedJob& job, const StoredTable& time, const StoredTable* cam = nullptr);
  /// Parts of another movement, and its rows.
  void note(const RecordEvent& event) { write(event, now_); }
  void turn();
  /// Takes what is left and gives the log its name. Not closed: LOG.part stays.
  void close();

  /// Why the first file could not be written; empty: all is well.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// Failed files: bits of wire::Unwritten.
  [[nodiscard]] std::uint8_t unwritten() const { return unwritten_; }
  [[nodiscard]] std::int64_t lost() const { return lost_; }  ///< cycles

 private:
  /// The last encoded cycles of one axis, or sights of one master.
  struct Box {
    std::vector<std::string> kept;
    std::vector<std::int64_t> microseconds;
    std::size_t count = 0;
    Cause fault = Cause::none;
  };

  void write(const RecordEvent& event, std::int64_t microseconds);
  void write(std::string_view channel, const std::string& data, std::int64_t microseconds);
  void write(const StoredTable& table);
  void flush();
  void keep(Box& box, const std::string& data, std::int64_t microseconds);
  void watch(Box& box, const RecordedCycle& cycle);
  [[nodiscard]] std::int64_t instant_of(const Tape::Item& item) const;
  void take(const Tape::Item& item);
  void write_black_box();
  void fail(wire::Unwritten which, const std::string& what);

  RecorderOptions options_;
  std::vector<RecordedAxis> axes_;
  std::vector<RecordedMaster> masters_;
  Tape& tape_;
  std::filesystem::path part_;
  std::ofstream file_;
  std::string buffer_;
  std::int64_t number_ = 0;
  std::int64_t now_ = 0;  // us
  std::set<Sha256> tables_;
  std::vector<Box> boxes_;  // boxes of the masters, then of the axes
  std::string trouble_;
  std::uint8_t unwritten_ = 0;
  std::int64_t lost_ = 0;
};

}  // namespace jounce

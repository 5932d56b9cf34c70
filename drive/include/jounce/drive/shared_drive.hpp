// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "jounce/drive/cia402_axis.hpp"
#include "jounce/drive/seqlock.hpp"

namespace jounce {

/// Content of the shared memory `/dev/shm/NAME` between an executor and a process that simulates a
/// drive, or communicates with one. Each side writes its own half as a whole, with a count of its
/// cycles.
struct SharedProcessData {
  static constexpr std::uint64_t magic_number = 0x3145'4349'5244'4a4a;  ///< "JJDRICE1"

  template <class T>
  struct Counted {
    std::uint64_t cycle = 0;  ///< cycle of the writing side; 0: not written yet
    T data{};
  };

  std::atomic<std::uint64_t> magic;  ///< written last by the executor
  Seqlock<Counted<Cia402Outputs>> outputs;
  Seqlock<Counted<Cia402Inputs>> inputs;
};

/// A mapping of the shared memory, for either side.
class SharedMemory {
 public:
  enum class Side {
    executor,  ///< creates it, or takes over that of an ended executor; removes it at the end
    drive,     ///< opens the memory of an executor
  };
  /// `name`: 1 to 64 characters, each a letter A-Z a-z, a digit, `_` or `-`. Throws InputError for
  /// a bad name, or one in use by another executor (which holds a lock on it); std::system_error if
  /// the system rejects it, or if no executor has created it yet.
  SharedMemory(const std::string& name, Side side);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  SharedProcessData& operator*() const { return *data_; }
  SharedProcessData* operator->() const { return data_; }

 private:
  std::string path_;
  Side side_;
  int file_ = -1;
  SharedProcessData* data_ = nullptr;
};

/// A CiA 402 drive behind shared memory: an example of an adapter. `examples/drive-shm` is the
/// other side. An adapter for a field bus has the same structure, with its process image instead of
/// the memory.
///
///     SharedDrive drive("feeder", {.increments_per_rev = 131072, .position_per_rev = 10});
///
/// If the process writes nothing for `silent_cycles` calls of feedback(), the drive has a fault.
/// Before its first write, the drive is not ready.
class SharedDrive final : public AxisDrive {
 public:
  /// Throws like SharedMemory and Cia402Axis; silent_cycles >= 1.
  SharedDrive(const std::string& name, const Cia402Config& config, int silent_cycles = 50);

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  SharedMemory memory_;
  Cia402Axis axis_;
  int silent_cycles_;
  int silent_ = 0;  // calls since the last write
  std::uint64_t cycle_ = 0;
  SharedProcessData::Counted<Cia402Inputs> inputs_{};
};

}  // namespace jounce

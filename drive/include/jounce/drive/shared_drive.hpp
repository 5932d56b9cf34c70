// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "jounce/drive/cia402_axis.hpp"
#include "jounce/drive/seqlock.hpp"

namespace jounce {

/// Content of the shared memory `/dev/shm/jounce-drive-NAME` between an executor and another
/// process. The other process simulates a drive or communicates with a real one. Each side writes
/// its own half as a whole, together with the number of its cycle.
struct SharedProcessData {
  static constexpr std::uint64_t magic_number = 0x3245'4349'5244'4a4a;  ///< "JJDRICE2"

  /// Data with the number of the cycle in which they were written.
  template <class T>
  struct Counted {
    std::uint64_t cycle = 0;  ///< cycle of the writer; 0: not written yet
    T data{};                 ///< the data
  };

  /// The executor writes magic_number last, when the memory is complete.
  std::atomic<std::uint64_t> magic;
  Seqlock<Counted<Cia402Outputs>> outputs;  ///< written by the executor
  Seqlock<Counted<Cia402Inputs>> inputs;    ///< written by the process of the drive
};

/// A mapping of the shared memory, for the executor or for the process of the drive.
class SharedMemory {
 public:
  enum class Side {
    /// Creates the memory, or takes over the memory of an executor that has ended; removes it at
    /// the end.
    executor,
    drive,  ///< opens the memory that an executor has created
  };
  /// `name` has 1 to 64 characters, each a letter A-Z a-z, a digit, `_` or `-`. Throws InputError
  /// for an invalid name, and for a name that another running executor uses (it holds a lock).
  /// Throws std::system_error if the system reports an error, or if no executor has created the
  /// memory yet.
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

/// Throws InputError for a name or a configuration that SharedDrive rejects. Opens no memory.
void require_shared_drive(const std::string& name, const Cia402Config& config);

/// A CiA 402 drive behind shared memory, and an example of an adapter. `examples/drive-shm` is the
/// other process. An adapter for a field bus has the same structure, with the process image of the
/// bus in place of the shared memory.
///
///     SharedDrive drive("feeder", {.increments_per_rev = 131072, .position_per_rev = 10});
///
/// Before the first write of the other process, the drive is not ready. If, after that, the other
/// process writes nothing during `silent_cycles` calls of feedback(), the drive reports a fault.
class SharedDrive final : public AxisDrive {
 public:
  /// For `name`, see SharedMemory. Throws like SharedMemory and Cia402Axis, and InputError unless
  /// silent_cycles >= 1.
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

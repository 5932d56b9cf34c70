// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "jounce/drive/cia402_axis.hpp"
#include "jounce/drive/seqlock.hpp"

namespace jounce {

/// Content of the shared memory `/dev/shm/NAME` between an executor and a process that plays, or
/// talks to, a drive. Each side writes its own half whole, with a count of its cycles.
struct SharedProcessData {
  static constexpr std::uint64_t magic_number = 0x3145'4349'5244'4a4a;  ///< "JJDRICE1"

  template <class T>
  struct Counted {
    std::uint64_t cycle = 0;  ///< cycle of the side that writes; 0: it has not written yet
    T data{};
  };

  std::atomic<std::uint64_t> magic;  ///< written last by the executor
  Seqlock<Counted<Cia402Outputs>> outputs;
  Seqlock<Counted<Cia402Inputs>> inputs;
};

/// A mapping of it, of either side.
class SharedMemory {
 public:
  enum class Side {
    executor,  ///< makes it, or takes over what an executor that died has left; removes it in the end
    drive,     ///< opens what an executor has made
  };
  /// `name`: 1 to 64 of A-Z a-z 0-9 _ - . Throws InputError for a bad name, or one that another executor
  /// (which holds a lock on it) uses, and std::system_error where the machine refuses, or where an
  /// executor has made nothing yet.
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

/// A CiA 402 drive behind shared memory: the example of an adapter. `examples/drive-shm` is the other
/// side; one for a field bus looks the same, with its process image in place of the memory.
///
///     SharedDrive drive("feeder", {.increments_per_rev = 131072, .position_per_rev = 10});
///
/// A process that has written nothing for `silent_cycles` calls of feedback() is a fault of the drive
/// (and one that has written nothing at all is not ready).
class SharedDrive final : public AxisDrive {
 public:
  /// Throws as SharedMemory and Cia402Axis; silent_cycles >= 1.
  SharedDrive(const std::string& name, const Cia402Config& config, int silent_cycles = 50);

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  SharedMemory memory_;
  Cia402Axis axis_;
  int silent_cycles_;
  int silent_ = 0;  // calls since it wrote last
  std::uint64_t cycle_ = 0;
  SharedProcessData::Counted<Cia402Inputs> inputs_{};
};

}  // namespace jounce

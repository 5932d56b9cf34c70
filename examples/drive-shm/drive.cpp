// SPDX-License-Identifier: Apache-2.0
// A process that plays a CiA 402 drive in shared memory, for an executor in another one:
//
//     drive-shm NAME [SECONDS]
//
// It follows its target position exactly, a cycle of its own (1 ms) later, goes through the states as
// the controlword demands, and ends after SECONDS (10), when the executor is gone, or with 1 where none
// comes within that time. Replace follow() by what moves your motor.
//
// A sensor on touch probe 1 sees a mark of 400 increments at each 4000 increments.

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "jounce/drive/shared_drive.hpp"
#include "jounce/profiles/error.hpp"

namespace {

using jounce::Cia402Inputs;
using jounce::Cia402Outputs;
using jounce::Cia402State;
using jounce::SharedMemory;
using jounce::SharedProcessData;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds cycle{1};

/// Touch probe 1 of the drive (objects 0x60B8 to 0x60BB, and the counters 0x60D5 and 0x60D6).
class MyProbe {
 public:
  /// The drive moves from one position to another within a cycle. The probe latches the edges that it
  /// passes; of several edges of one kind, the last one stays.
  void move(std::int32_t from, std::int32_t to, std::uint16_t function) {
    constexpr unsigned enabled = 1, continuous = 2;
    if ((function & enabled) == 0) {
      status_ = 0;
      return;
    }
    status_ |= enabled;
    const int step = to > from ? 1 : -1;
    for (std::int32_t p = from; p != to; p += step) {
      const bool before = on_mark(step > 0 ? p - 1 : p);
      const bool after = on_mark(step > 0 ? p : p - 1);
      if (before == after) continue;
      const unsigned edge = after ? 0 : 1;  // rising, falling
      const auto stored = static_cast<std::uint16_t>(2U << edge);
      const bool wanted = (function & (16U << edge)) != 0;
      if (!wanted || ((status_ & stored) != 0 && (function & continuous) == 0)) continue;
      status_ = static_cast<std::uint16_t>(status_ | stored);
      position_.at(edge) = p;
      ++count_.at(edge);
    }
  }

  void put(Cia402Inputs& inputs) const {
    inputs.touch_probe_status = status_;
    inputs.touch_probe_position = position_;
    inputs.touch_probe_count = count_;
  }

 private:
  /// True if the sensor sees a mark between the increments p and p + 1.
  static bool on_mark(std::int32_t p) {
    constexpr std::int32_t distance = 4000, width = 400;
    return ((p % distance) + distance) % distance < width;
  }

  std::uint16_t status_ = 0;
  std::array<std::int32_t, jounce::cia402_captures> position_{};
  std::array<std::uint16_t, jounce::cia402_captures> count_{};
};

struct MyDrive {
  Cia402State state = Cia402State::not_ready_to_switch_on;
  std::uint16_t last_word = 0;
  std::int32_t position = 1000;
  std::int32_t velocity = 0;
  MyProbe probe;

  void follow(const Cia402Outputs& outputs) {
    state = jounce::next(state, outputs.controlword, last_word,
                         {.initialised = true, .stopped = velocity == 0});
    last_word = outputs.controlword;
    const std::int32_t before = position;
    if (state == Cia402State::operation_enabled) position = outputs.target_position;
    velocity = (position - before) * 1000;
    probe.move(before, position, outputs.touch_probe);
  }

  [[nodiscard]] Cia402Inputs inputs() const {
    const bool operates = state == Cia402State::operation_enabled;
    Cia402Inputs now{.statusword = jounce::statusword({.state = state, .follows = operates}),
                     .mode = 8,
                     .position_actual = position,
                     .velocity_actual = velocity};
    probe.put(now);
    return now;
  }
};

/// The executor may be started after this process.
std::unique_ptr<SharedMemory> wait_for(const std::string& name, Clock::time_point end) {
  while (Clock::now() < end) {
    try {
      return std::make_unique<SharedMemory>(name, SharedMemory::Side::drive);
    } catch (const std::system_error&) {
      std::this_thread::sleep_for(10 * cycle);
    }
  }
  return nullptr;
}

int play(const std::string& name, Clock::time_point end) {
  const auto memory = wait_for(name, end);
  if (!memory) {
    std::fprintf(stderr, "drive-shm: no executor has made %s\n", name.c_str());
    return 1;
  }
  SharedProcessData& shared = **memory;
  MyDrive drive;
  std::uint64_t cycles = 0;
  for (auto next = Clock::now(); next < end && shared.magic == SharedProcessData::magic_number;
       next += cycle) {
    std::this_thread::sleep_until(next);
    if (const auto setpoint = shared.outputs.read(); setpoint && setpoint->cycle > 0)
      drive.follow(setpoint->data);
    shared.inputs.write({++cycles, drive.inputs()});
  }
  std::printf("%llu cycles, %s at %d increments\n", static_cast<unsigned long long>(cycles),
              name.c_str(), drive.position);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: drive-shm NAME [SECONDS]\n");
    return 2;
  }
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  if (!(seconds > 0 && seconds <= 1e6)) {
    std::fprintf(stderr, "drive-shm: SECONDS must be a number up to 1e6, not %s\n", argv[2]);
    return 2;
  }
  try {
    const std::chrono::duration<double> length(seconds);
    return play(argv[1], Clock::now() + std::chrono::duration_cast<Clock::duration>(length));
  } catch (const jounce::InputError& error) {
    std::fprintf(stderr, "drive-shm: %s\n", error.what());
    return 2;
  }
}

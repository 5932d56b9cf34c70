// SPDX-License-Identifier: Apache-2.0
// A process that plays a CiA 402 drive in shared memory, for an executor in another one:
//
//     drive-shm NAME [SECONDS]
//
// It follows its target position exactly, a cycle of its own (1 ms) later, goes through the states as
// the controlword demands, and ends after SECONDS (10), when the executor is gone, or with 1 where none
// comes within that time. Replace follow() by what moves your motor.

#include <chrono>
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

struct MyDrive {
  Cia402State state = Cia402State::not_ready_to_switch_on;
  std::uint16_t last_word = 0;
  std::int32_t position = 1000;
  std::int32_t velocity = 0;

  void follow(const Cia402Outputs& outputs) {
    state = jounce::next(state, outputs.controlword, last_word,
                         {.initialised = true, .stopped = velocity == 0});
    last_word = outputs.controlword;
    const std::int32_t before = position;
    if (state == Cia402State::operation_enabled) position = outputs.target_position;
    velocity = (position - before) * 1000;
  }

  [[nodiscard]] Cia402Inputs inputs() const {
    const bool operates = state == Cia402State::operation_enabled;
    return {.statusword = jounce::statusword({.state = state, .follows = operates}),
            .mode = 8,
            .position_actual = position,
            .velocity_actual = velocity};
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

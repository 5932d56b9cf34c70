// SPDX-License-Identifier: Apache-2.0
// Preloaded into a process, it steps the process's wall clock an hour back and forth, twenty times
// a second, like an endless setting of the time; the monotonic clock is not affected. At the end it
// writes the number of readings of the wall clock to the file CLOCK_STEPS, so that a test can check
// that there were some.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

std::atomic<long> readings{0};

struct Report {
  ~Report() {
    const char* const path = std::getenv("CLOCK_STEPS");
    if (path == nullptr) return;
    if (std::FILE* const file = std::fopen(path, "a")) {
      std::fprintf(file, "%ld\n", readings.load());
      std::fclose(file);
    }
  }
} report;

int stepped(clockid_t clock, timespec* time) {
  const auto result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  if (result != 0 || (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE)) return result;
  timespec even{};
  syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &even);
  const long step = even.tv_sec * 20 + even.tv_nsec / 50'000'000;
  time->tv_sec += (step % 3 - 1) * 3600;
  ++readings;
  return result;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  return stepped(clock, time);
}

int gettimeofday(timeval* time, void* /*zone*/) noexcept {
  timespec now{};
  const int result = stepped(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return result;
}

time_t time(time_t* where) noexcept {
  timespec now{};
  stepped(CLOCK_REALTIME, &now);
  if (where != nullptr) *where = now.tv_sec;
  return now.tv_sec;
}
}

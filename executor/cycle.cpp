#include "jounce/executor/cycle.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <ctime>
#include <system_error>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace jounce {
namespace {

constexpr std::int64_t second = 1'000'000'000;

std::string because(int error) {
  return " (" + std::generic_category().message(error) + ")";
}

std::string ask_for_fifo(int priority) {
  sched_param wanted{};
  wanted.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
  if (error == 0) return "SCHED_FIFO " + std::to_string(priority);
  return "no SCHED_FIFO" + because(error) + ": grant CAP_SYS_NICE or an rtprio limit";
}

std::string lock_memory() {
  // With a bound on locked memory, locking what is yet to come would make allocations fail.
  rlimit bound{};
  const bool unbounded = getrlimit(RLIMIT_MEMLOCK, &bound) == 0 && bound.rlim_cur == RLIM_INFINITY;
  if (mlockall(unbounded ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0) return "memory locked";
  return "memory not locked" + because(errno) + ": grant CAP_IPC_LOCK or a memlock limit";
}

void touch_stack() {
  volatile unsigned char pages[128 * 1024];
  for (std::size_t i = 0; i < sizeof pages; i += 1024) pages[i] = 0;
}

}  // namespace

std::int64_t MonotonicPacer::now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * second + t.tv_nsec;
}

void MonotonicPacer::sleep_until(std::int64_t instant) {
  const timespec t{instant / second, instant % second};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

Cycle::Cycle(MotionAxis& axis, Pacer& pacer, Mail& mail)
    : axis_(axis), pacer_(pacer), mail_(mail), start_(pacer.now()) {}

void Cycle::once() {
  const std::int64_t period = axis_.config().period;
  pacer_.sleep_until(start_ + next_ * period);
  const std::int64_t delay = pacer_.now() - (start_ + next_ * period);
  const std::int64_t missed = std::max<std::int64_t>(delay / period, 0);

  Command command;
  mail_.commands.pop(command);
  const Tick tick = axis_.step(next_ + missed, command);
  post(command, tick);

  ++counts_.ticks;
  counts_.late += missed > 0;
  counts_.skipped += missed;
  counts_.latest_ns = std::max(counts_.latest_ns, delay);
  next_ = tick.tick + 1;
}

void Cycle::post(const Command& command, const Tick& tick) {
  if (!mail_.ticks.push(tick)) ++counts_.lost;
  if (command.id == 0 && !tick.handed_back.front()) return;
  [[maybe_unused]] const bool posted =
      mail_.answers.push({command.id, tick.refused, tick.handed_back});
  assert(posted);
}

std::string make_realtime(int priority) {
  touch_stack();
  const std::string fifo = ask_for_fifo(priority);
  return fifo + "; " + lock_memory();
}

}  // namespace jounce

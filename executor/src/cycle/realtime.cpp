// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/realtime.hpp"

#include <cerrno>
#include <cstddef>
#include <system_error>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

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
  // Under a limit on locked memory, locking future pages would make allocations fail.
  rlimit bound{};
  const bool unbounded = getrlimit(RLIMIT_MEMLOCK, &bound) == 0 && bound.rlim_cur == RLIM_INFINITY;
  if (mlockall(unbounded ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0) return "memory locked";
  return "memory not locked" + because(errno) + ": grant CAP_IPC_LOCK or a memlock limit";
}

std::string ask_for_cpu(int cpu) {
  const auto refused = [cpu](int error) {
    return "CPU " + std::to_string(cpu) + " is not available" + because(error) +
           ": the cycle runs on any CPU";
  };
  if (cpu >= CPU_SETSIZE) return refused(EINVAL);
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<std::size_t>(cpu), &only);
  const int error = pthread_setaffinity_np(pthread_self(), sizeof only, &only);
  if (error == 0) return "on CPU " + std::to_string(cpu);
  return refused(error);
}

void touch_stack() {
  volatile unsigned char pages[128 * 1024];
  for (std::size_t i = 0; i < sizeof pages; i += 1024) pages[i] = 0;
}

}  // namespace

void require_cpu(int cpu) {
  cpu_set_t usable;
  CPU_ZERO(&usable);
  if (cpu < 0 || sched_getaffinity(0, sizeof usable, &usable) != 0) return;
  if (cpu < CPU_SETSIZE && CPU_ISSET(static_cast<std::size_t>(cpu), &usable)) return;
  std::string all;
  for (int each = 0; each < CPU_SETSIZE; ++each)
    if (CPU_ISSET(static_cast<std::size_t>(each), &usable))
      all += (all.empty() ? "" : ", ") + std::to_string(each);
  throw InputError("cpu", std::to_string(cpu),
                   "must be one of the CPUs that this program may use: " + all);
}

std::string make_realtime(const Realtime& wanted) {
  touch_stack();
  prctl(PR_SET_TIMERSLACK, 1UL);
  std::string granted;
  const auto say = [&](const std::string& words) {
    granted += (granted.empty() ? "" : "; ") + words;
  };
  if (wanted.cpu >= 0) say(ask_for_cpu(wanted.cpu));
  if (wanted.priority > 0) {
    say(ask_for_fifo(wanted.priority));
    say(lock_memory());
  }
  return granted;
}

}  // namespace jounce

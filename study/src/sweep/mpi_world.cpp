// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/mpi_world.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <thread>
#include <utility>

#include <dlfcn.h>

#include "jounce/profiles/error.hpp"

#include "study/src/sweep/mpi_calls.hpp"

namespace jounce {
namespace {

using study_detail::MpiCalls;
using namespace std::chrono_literals;

/// The module stays loaded: MPI leaves handlers behind that run at the program's exit.
const MpiCalls* load() {
  std::error_code ignored;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* place : {"jounce_mpi.so", JOUNCE_MPI_INSTALLED}) {
    const auto path = here / place;
    if (!std::filesystem::exists(path, ignored)) continue;
    // Global: Open MPI's own plugins look for its symbols.
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr)
      throw InputError("mpirun", "", std::string("cannot load MPI: ") + dlerror());
    using Entry = const MpiCalls* (*)();
    const auto entry = reinterpret_cast<Entry>(dlsym(module, study_detail::mpi_entry));
    if (entry != nullptr) return entry();
  }
  throw InputError("mpirun", "", "needs a Jounce built with MPI: jounce_mpi.so is missing");
}

/// The number of cases that a worker may hold: enough that it never waits for the next order, but no more than
/// it makes within `held`, the time for which a stopped sweep continues.
class Ahead {
 public:
  void made_one() { ++made_; }

  [[nodiscard]] std::size_t wanted() const {
    constexpr double held = 0.02;  // s
    constexpr double most = 64;
    if (made_ == 0) return 1;
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begun_;
    const double each = gone.count() / static_cast<double>(made_);
    return 1 + static_cast<std::size_t>(each * most > held ? held / each : most);
  }

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::size_t made_ = 0;
};

/// The first rank: distributes cases to the others and takes their lines. A second thread makes cases, too.
class Handing {
 public:
  Handing(const MpiCalls& calls, int size, const std::vector<std::size_t>& numbers,
          const MakeLine& make, const TakeLine& take)
      : calls_(calls), numbers_(numbers), make_(make), take_(take), workers_(to_size(size)) {}

  void run(const std::string& identity) {
    {
      const std::jthread own([this] { work_here(); });
      try {
        serve(identity);
      } catch (...) {
        stop();
        throw;
      }
    }
    if (trouble_) std::rethrow_exception(trouble_);
  }

 private:
  struct Worker {
    bool greeted = false;
    std::deque<std::size_t> holds = {};  ///< in the order in which their lines come
    Ahead ahead = {};
  };

  static std::size_t to_size(int size) { return static_cast<std::size_t>(size); }

  void stop() {
    const std::lock_guard lock(mutex_);
    next_ = numbers_.size();
  }

  /// The next cases, at most `most`: towards the end fewer, so that all end together.
  std::vector<std::size_t> next(std::size_t most) {
    const std::lock_guard lock(mutex_);
    const std::size_t left = numbers_.size() - next_;
    const std::size_t share = std::max<std::size_t>(1, left / (2 * workers_.size()));
    const std::size_t count = std::min({most, left, share});
    const auto from = numbers_.begin() + static_cast<std::ptrdiff_t>(next_);
    next_ += count;
    return {from, from + static_cast<std::ptrdiff_t>(count)};
  }

  void taken(std::size_t number, const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (!take_(number, line)) next_ = numbers_.size();
  }

  void work_here() {
    try {
      for (auto one = next(1); !one.empty(); one = next(1)) taken(one[0], make_(one[0]));
    } catch (...) {
      trouble_ = std::current_exception();
      stop();
    }
  }

  void serve(const std::string& identity) {
    std::string message;
    for (std::size_t left = workers_.size() - 1; left > 0;) {
      const int rank = calls_.receive(message);
      Worker& worker = workers_[to_size(rank)];
      if (worker.greeted) {
        std::istringstream lines(message);
        for (std::string line; std::getline(lines, line);) {
          taken(worker.holds.front(), line);
          worker.holds.pop_front();
          worker.ahead.made_one();
        }
      } else if (message != identity) {
        throw InputError("mpirun", "",
                         "rank " + std::to_string(rank) +
                             " reads another sweep, spec or version of Jounce than rank 0");
      }
      worker.greeted = true;
      if (!hand_out(rank, worker)) --left;
    }
  }

  /// Sends a worker that holds few cases some more, in one message; false: it has none, and there are none.
  bool hand_out(int rank, Worker& worker) {
    const std::size_t wanted = worker.ahead.wanted();
    if (2 * worker.holds.size() > wanted) return true;
    std::string order;
    for (const std::size_t number : next(wanted - worker.holds.size())) {
      worker.holds.push_back(number);
      order += std::to_string(number) + ' ';
    }
    if (!order.empty() || worker.holds.empty()) calls_.send(rank, order);
    return !worker.holds.empty();
  }

  const MpiCalls& calls_;
  const std::vector<std::size_t>& numbers_;
  const MakeLine& make_;
  const TakeLine& take_;
  std::vector<Worker> workers_;  ///< by rank
  std::mutex mutex_;             ///< guards next_ and take_
  std::size_t next_ = 0;
  std::exception_ptr trouble_;
};

/// Another rank: makes what it is ordered to, and sends the lines of 5 ms together, each ended by '\n'.
void work(const MpiCalls& calls, const std::string& identity, const MakeLine& make) {
  calls.send(0, identity);
  for (std::string order;;) {
    calls.receive(order);
    if (order.empty()) return;
    std::istringstream numbers(order);
    std::string lines;
    auto sent = std::chrono::steady_clock::now();
    for (std::size_t number = 0; numbers >> number;) {
      lines += make(number) + '\n';
      if (const auto now = std::chrono::steady_clock::now(); now - sent > 5ms) {
        calls.send(0, lines);
        lines.clear();
        sent = now;
      }
    }
    if (!lines.empty()) calls.send(0, lines);
  }
}

const char* environment(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* value = std::getenv(name)) return value;
  return nullptr;
}

}  // namespace

MpiPlace mpi_place() {
  MpiPlace place;
  place.started = environment({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) != nullptr;
  if (const char* rank = environment({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}))
    place.rank = std::atoi(rank);
  return place;
}

Farm farm_over(const MpiCalls& calls, int rank, int size, std::string identity) {
  if (size == 1) return on_threads();
  return [&calls, rank, size, identity = std::move(identity)](
             const std::vector<std::size_t>& numbers, const MakeLine& make, const TakeLine& take) {
    if (rank == 0)
      Handing(calls, size, numbers, make, take).run(identity);
    else
      work(calls, identity, make);
  };
}

MpiWorld::MpiWorld() : calls_(load()) {
  calls_->start(rank_, size_);
}

MpiWorld::~MpiWorld() {
  calls_->end();
}

Farm MpiWorld::farm(std::string identity) const {
  return farm_over(*calls_, rank_, size_, std::move(identity));
}

void MpiWorld::abort(int status) const {
  calls_->abort(status);
}

}  // namespace jounce

#include "jounce/study/mpi_world.hpp"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include <dlfcn.h>

#include "jounce/profiles/error.hpp"
#include "jounce/study/detail/mpi_calls.hpp"

namespace jounce {
namespace {

using detail::MpiCalls;

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
    const auto entry = reinterpret_cast<Entry>(dlsym(module, detail::mpi_entry));
    if (entry != nullptr) return entry();
  }
  throw InputError("mpirun", "",
                   "needs a Jounce that was built with MPI: jounce_mpi.so is missing");
}

void hand_out(const MpiCalls& calls, int size, const std::string& identity,
              const std::vector<std::size_t>& numbers, const TakeLine& take) {
  constexpr auto nothing = static_cast<std::size_t>(-1);
  std::vector<std::size_t> at_work(static_cast<std::size_t>(size), nothing);
  std::size_t next = 0;
  std::string line;
  for (int workers = size - 1; workers > 0;) {
    const int rank = calls.receive(line);
    std::size_t& theirs = at_work[static_cast<std::size_t>(rank)];
    if (theirs == nothing) {
      if (line != identity)
        throw InputError("mpirun", "",
                         "rank " + std::to_string(rank) +
                             " reads another sweep, spec or version of Jounce than rank 0");
    } else if (!take(theirs, line)) {
      next = numbers.size();
    }
    if (next < numbers.size()) {
      theirs = numbers[next++];
      calls.send(rank, std::to_string(theirs));
    } else {
      calls.send(rank, "");
      --workers;
    }
  }
}

void work(const MpiCalls& calls, const std::string& identity, const MakeLine& make) {
  std::string order;
  for (std::string said = identity;; said = make(std::stoull(order))) {
    calls.send(0, said);
    calls.receive(order);
    if (order.empty()) return;
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
      hand_out(calls, size, identity, numbers, take);
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

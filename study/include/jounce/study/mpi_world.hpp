// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/study/sweep.hpp"

namespace jounce::study_detail {
struct MpiCalls;
}

namespace jounce {

/// True if mpirun (Open MPI, or another launcher that speaks PMI) has started this process, and the
/// rank and the number of processes: from the environment, without MPI.
struct MpiPlace {
  bool started = false;
  int rank = 0;
};
MpiPlace mpi_place();

/// The processes that mpirun has started, during the lifetime of this object.
///
///     MpiWorld world;
///     SweepResult result = run_sweep(spec, {.farm = world.farm(hex(spec.identity()))});
///     if (world.rank() != 0) return;               // only the first has all rows
///
/// MPI is loaded from the module jounce_mpi.so, which is beside the program, or in ../lib/jounce
/// beside its folder. Throws InputError if there is none: a build without MPI.
class MpiWorld {
 public:
  MpiWorld();
  ~MpiWorld();
  MpiWorld(const MpiWorld&) = delete;
  MpiWorld& operator=(const MpiWorld&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// Rank 0 distributes cases in batches of at most 20 ms of work, and collects the lines; one of
  /// its threads makes cases, too. The other ranks only make cases. Rank 0 throws InputError if the
  /// `identity` of a rank differs from its own: that rank reads other files. A world of one process
  /// works on its own threads.
  [[nodiscard]] Farm farm(std::string identity) const;

  /// Ends all processes at once.
  void abort(int status) const;

 private:
  const study_detail::MpiCalls* calls_;
  int rank_ = 0;
  int size_ = 1;
};

/// farm() of a rank over any such calls.
Farm farm_over(const study_detail::MpiCalls& calls, int rank, int size, std::string identity);

}  // namespace jounce

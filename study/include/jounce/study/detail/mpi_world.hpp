// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/study/detail/sweep.hpp"

namespace jounce::study_detail {
struct MpiCalls;
}

namespace jounce {

/// The place of this process among the processes that mpirun has started (Open MPI, or another
/// launcher with PMI). The place is read from the environment, without MPI.
struct MpiPlace {
  bool started = false;  ///< true if mpirun has started this process
  int rank = 0;          ///< number of this process, from 0
};
/// Returns the place of this process.
MpiPlace mpi_place();

/// The processes that mpirun has started. MPI is in use while this object exists.
///
///     MpiWorld world;
///     SweepResult result = run_sweep(spec, {.farm = world.farm(hex(spec.identity()))});
///     if (world.rank() != 0) return;               // only rank 0 has all rows
///
/// MPI is loaded from the module jounce_mpi.so, which is next to the program or in ../lib/jounce
/// relative to its folder. Throws InputError if the module does not exist, in a build without MPI.
class MpiWorld {
 public:
  MpiWorld();
  ~MpiWorld();
  MpiWorld(const MpiWorld&) = delete;
  MpiWorld& operator=(const MpiWorld&) = delete;

  /// Number of this process, from 0.
  [[nodiscard]] int rank() const { return rank_; }
  /// Number of processes.
  [[nodiscard]] int size() const { return size_; }

  /// Returns a Farm over all processes. Rank 0 distributes the cases in batches of at most 20 ms of
  /// work and collects the lines; one of its threads also computes cases. The other ranks only
  /// compute cases. `identity` identifies the input: rank 0 throws InputError if the `identity` of
  /// another rank differs, because that rank reads other files. If the world has one process, its
  /// threads compute the cases.
  [[nodiscard]] Farm farm(std::string identity) const;

  /// Ends all processes at once, with this exit status.
  void abort(int status) const;

 private:
  const study_detail::MpiCalls* calls_;
  int rank_ = 0;
  int size_ = 1;
};

/// Returns the farm of a rank over any implementation of the MPI calls.
Farm farm_over(const study_detail::MpiCalls& calls, int rank, int size, std::string identity);

}  // namespace jounce

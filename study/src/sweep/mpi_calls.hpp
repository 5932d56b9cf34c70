// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::detail {

/// What Jounce needs of MPI, as the module jounce_mpi.so offers it: loaded only where mpirun has started
/// the program, so that MPI burdens nobody else.
struct MpiCalls {
  void (*start)(int& rank, int& size);
  void (*send)(int to, const std::string& bytes);
  int (*receive)(std::string& bytes);  ///< waits for anybody's; answers whose
  void (*end)();
  void (*abort)(int status);  ///< of all processes
};

/// The name under which the module exports its `const MpiCalls*()`.
constexpr const char* mpi_entry = "jounce_mpi_calls";

}  // namespace jounce::detail

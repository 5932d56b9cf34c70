// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::study_detail {

/// The MPI functions that Jounce uses, exported by the module jounce_mpi.so. The module is loaded
/// only if mpirun has started the program. Other runs do not need MPI.
struct MpiCalls {
  /// Starts MPI; sets the number of this process and of all processes.
  void (*start)(int& rank, int& size);
  void (*send)(int to, const std::string& bytes);  ///< sends a message to a process
  int (*receive)(std::string& bytes);  ///< waits for a message of any process; returns its sender
  void (*end)();                       ///< ends MPI
  void (*abort)(int status);           ///< ends all processes with this exit status
};

/// Name under which the module exports its function `const MpiCalls*()`.
constexpr const char* mpi_entry = "jounce_mpi_calls";

}  // namespace jounce::study_detail

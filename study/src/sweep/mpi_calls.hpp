// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::study_detail {

/// The MPI functions that Jounce uses, exported by the module jounce_mpi.so. The module is loaded only where
/// mpirun has started the program, so other runs do not need MPI.
struct MpiCalls {
  void (*start)(int& rank, int& size);
  void (*send)(int to, const std::string& bytes);
  int (*receive)(std::string& bytes);  ///< waits for a message of any process; returns its sender
  void (*end)();
  void (*abort)(int status);  ///< number of all processes
};

/// The name under which the module exports its `const MpiCalls*()`.
constexpr const char* mpi_entry = "jounce_mpi_calls";

}  // namespace jounce::study_detail

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <thread>

#include <mpi.h>

#include "study/src/sweep/mpi_calls.hpp"

// The one file that sees MPI. An MPI function that fails ends all processes (MPI_ERRORS_ARE_FATAL, the
// default), so no result is looked at.

namespace {

constexpr int tag = 1;

void start(int& rank, int& size) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
}

void send(int to, const std::string& bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD);
}

/// Polls and sleeps: the blocking wait of MPI would use a whole core. Workers have cases for longer than one
/// sleep.
int receive(std::string& bytes) {
  MPI_Status status;
  int there = 0;
  for (auto nap = std::chrono::microseconds(50);;
       nap = std::min(2 * nap, std::chrono::microseconds(1000))) {
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &there, &status);
    if (there != 0) break;
    std::this_thread::sleep_for(nap);
  }
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  bytes.resize(static_cast<std::size_t>(size));
  MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return status.MPI_SOURCE;
}

void end() {
  MPI_Finalize();
}

void abort_all(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
}

}  // namespace

extern "C" const jounce::study_detail::MpiCalls* jounce_mpi_calls() {
  static const jounce::study_detail::MpiCalls calls{start, send, receive, end, abort_all};
  return &calls;
}

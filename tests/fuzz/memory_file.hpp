// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {

/// A file that is in memory alone, its owner's to read and write, for what reads files by their path.
class MemoryFile {
 public:
  explicit MemoryFile(Input content) : file_(memfd_create("fuzz", MFD_CLOEXEC)) {
    fchmod(file_, 0600);
    require(write(file_, content.data(), content.size()) == static_cast<ssize_t>(content.size()),
            "there is memory");
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

}  // namespace jounce::fuzz

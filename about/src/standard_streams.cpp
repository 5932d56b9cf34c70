// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/standard_streams.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace jounce {

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) std::abort();
}

std::string flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return "";
  return errno == EPIPE ? "" : std::generic_category().message(errno);
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/notice.hpp"

#include <cstdio>

#include <poll.h>
#include <unistd.h>

#include "jounce/base/detail/printable.hpp"

namespace jounce {

void print_notice(const std::string& notice) {
  pollfd out{STDERR_FILENO, POLLOUT, 0};
  if (poll(&out, 1, 0) != 1 || (out.revents & POLLOUT) == 0) return;
  std::fputs((printable(notice) + "\n").c_str(), stderr);  // unlike fmt::print() it does not throw
}

}  // namespace jounce

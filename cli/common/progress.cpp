// SPDX-License-Identifier: Apache-2.0
#include "cli/common/progress.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace jounce::cli {

using namespace std::chrono_literals;

Progress::Progress(std::string what)
    : what_(std::move(what)),
      begun_(std::chrono::steady_clock::now()),
      shown_(begun_),
      terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(double share, const std::string& now) {
  const auto time = std::chrono::steady_clock::now();
  if (!terminal_ || time - begun_ < 1s || time - shown_ < 100ms) return;
  shown_ = time;
  visible_ = true;
  const int filled = static_cast<int>(24 * std::clamp(share, 0.0, 1.0));
  fmt::print(stderr, "\r\x1b[K{} [{:#<{}}{:.<{}}] {:3.0f} % {}", what_, "", filled, "", 24 - filled,
             100 * share, now);
  std::fflush(stderr);
}

}  // namespace jounce::cli

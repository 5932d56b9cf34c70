// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/progress_line.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace jounce {

using namespace std::chrono_literals;

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)),
      begun_(std::chrono::steady_clock::now()),
      shown_(begun_),
      terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (visible_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(double share, const std::string& now) {
  const auto time = std::chrono::steady_clock::now();
  if (!terminal_ || time - begun_ < 1s || time - shown_ < 100ms) return;
  shown_ = time;
  visible_ = true;
  constexpr std::size_t width = 24;
  const auto filled = static_cast<std::size_t>(width * std::clamp(share, 0.0, 1.0));
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r\x1b[K%s [%s] %3.0f %% %s", what_.c_str(), bar.c_str(), 100 * share,
               now.c_str());
  std::fflush(stderr);
}

}  // namespace jounce

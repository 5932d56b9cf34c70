// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace jounce::cli {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM ask for an end instead of making one: what was found so far is
/// kept. The second of the same kind ends the program as usual.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool asked() const;

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
};

}  // namespace jounce::cli

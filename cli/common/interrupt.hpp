// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace jounce::cli {

/// While an object exists, the first Ctrl-C (SIGINT) or SIGTERM only sets asked(), so that the program can keep its
/// best result. The second signal of the same kind ends the program as usual.
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

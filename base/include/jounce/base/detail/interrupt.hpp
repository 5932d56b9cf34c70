// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace jounce {

/// While an object exists, the first Ctrl-C (SIGINT) or SIGTERM only sets asked(), so that the
/// program can keep its best result. The second signal of the same kind ends the program as usual.
/// At most one object exists at a time.
///
///     const Interrupt interrupt;
///     run_sweep(spec, {.keep_going = [&](std::size_t, std::size_t) { return !interrupt.asked(); }});
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// True after the first signal.
  [[nodiscard]] bool asked() const;

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
};

}  // namespace jounce

#pragma once

#include <csignal>

namespace jounce::cli {

/// While it lives, Ctrl-C asks for an end instead of making one: what was found so far is kept. A
/// second one ends the program as usual.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool asked() const;

 private:
  struct sigaction before_ {};
};

}  // namespace jounce::cli

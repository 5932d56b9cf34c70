#pragma once

namespace jounce::cli {

/// While it lives, the first Ctrl-C only asks long work to stop with what it has; the second ends the
/// program as usual.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool requested() const;

 private:
  void (*before_)(int);
};

}  // namespace jounce::cli

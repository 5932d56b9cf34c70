#include "interrupt.hpp"

#include <csignal>

namespace jounce::cli {
namespace {

volatile std::sig_atomic_t asked = 0;

void ask(int signal) {
  asked = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
  asked = 0;
  before_ = std::signal(SIGINT, ask);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, before_);
}

bool Interrupt::requested() const {
  return asked != 0;
}

}  // namespace jounce::cli

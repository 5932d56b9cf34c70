#include "jounce/pvt/googol_pt.hpp"

#include <cmath>

namespace jounce::googol {

int return_code(Refusal refusal) {
  if (refusal == Refusal::none) return 0;
  return refusal == Refusal::bad_argument ? 7 : 1;
}

const char* explain(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return "done";
    case Refusal::bad_argument:
      return "an argument is out of range, or the segment does not end after the one before";
    case Refusal::wrong_mode:
      return "the axis is in another mode: set this one first, at rest";
    case Refusal::moving:
      return "the axis is moving, or waits for its event: stop it first";
    case Refusal::not_moving:
      return "the axis is not moving: start it first";
    case Refusal::in_use:
      return "the FIFO is being played: take the other one, or stop the axis";
    case Refusal::full:
      return "the FIFO is full: wait until it has space";
    case Refusal::empty:
      return "the FIFO is empty: fill it first";
    case Refusal::no_master:
      return "the axis has no master: set it first";
  }
  return "";
}

namespace {

constexpr std::size_t large = 1024;

bool is_fifo(int fifo) {
  return fifo == 0 || fifo == 1;
}

}  // namespace

PtFifos::PtFifos() : fifos_(large) {
  reset();
}

void PtFifos::reset() {
  fifos_.reset({.each = each_, .total = 2 * each_, .stream = mode_ == PtMode::dynamic});
}

Refusal PtFifos::prf_pt(PtMode mode) {
  if (fifos_.moving()) return Refusal::moving;
  pt_ = true;
  mode_ = mode;
  reset();
  return Refusal::none;
}

Refusal PtFifos::set_pt_memory(int memory) {
  if (!pt_) return Refusal::wrong_mode;
  if (fifos_.moving()) return Refusal::moving;
  if (memory != 0 && memory != 1) return Refusal::bad_argument;
  each_ = memory == 0 ? 32 : large;
  reset();
  return Refusal::none;
}

Refusal PtFifos::set_pt_loop(std::int64_t loops) {
  if (!pt_) return Refusal::wrong_mode;
  if (loops < 0) return Refusal::bad_argument;
  fifos_.set_loops(loops);
  return Refusal::none;
}

std::size_t PtFifos::pt_space(int fifo) const {
  return pt_ && is_fifo(fifo) ? fifos_.space(fifo) : 0;
}

Refusal PtFifos::pt_data(const PtPoint& point, int fifo) {
  if (!pt_) return Refusal::wrong_mode;
  if (!is_fifo(fifo) || point.type == PtType::continued) return Refusal::bad_argument;
  if (fifos_.space(fifo) == 0) return Refusal::full;
  if (!fifos_.follows_on(fifo, point)) return Refusal::bad_argument;
  fifos_.push(fifo, point);
  return Refusal::none;
}

Refusal PtFifos::pt_clear(int fifo) {
  if (!pt_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (fifos_.in_use(fifo)) return Refusal::in_use;
  fifos_.clear(fifo);
  return Refusal::none;
}

Refusal PtFifos::pt_start(int fifo, double time, double position) {
  if (!pt_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (fifos_.moving()) return Refusal::moving;
  const std::size_t segments =
      fifos_.stream() ? fifos_.size(0) + fifos_.size(1) : fifos_.size(fifo);
  if (segments == 0) return Refusal::empty;
  if (!std::isfinite(time) || !std::isfinite(position)) return Refusal::bad_argument;
  fifos_.start(fifo, time, position);
  return Refusal::none;
}

}  // namespace jounce::googol

// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol_pt.hpp"

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
      return "an argument is out of range, or the segment does not end after the segment before";
    case Refusal::wrong_mode:
      return "the axis is in another mode: set this one first, at rest";
    case Refusal::moving:
      return "the axis is moving, or waits for its event: stop it first";
    case Refusal::not_moving:
      return "the axis is not moving: start it first";
    case Refusal::in_use:
      return "the FIFO is being played: use the other one, or stop the axis";
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

}  // namespace

RowRule push(SegmentFifos& fifos, int fifo, const PtPoint& point) {
  const bool first = fifos.stream() ? fifos.size(0) + fifos.size(1) == 0 && !fifos.moving()
                                    : fifos.size(fifo) == 0;
  return fifos.push(fifo, row_of(point, first));
}

Refusal refusal_of(RowRule rule) {
  if (rule == RowRule::none) return Refusal::none;
  if (rule == RowRule::full) return Refusal::full;
  return rule == RowRule::in_use ? Refusal::in_use : Refusal::bad_argument;
}

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
  return refusal_of(push(fifos_, fifo, point));
}

Refusal PtFifos::pt_clear(int fifo) {
  if (!pt_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  return fifos_.clear(fifo) ? Refusal::none : Refusal::in_use;
}

Refusal PtFifos::pt_start(int fifo, double time, double position) {
  if (!pt_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (fifos_.moving()) return Refusal::moving;
  if (fifos_.size(fifos_.stream() ? 0 : fifo) == 0) return Refusal::empty;
  if (!std::isfinite(time) || !std::isfinite(position)) return Refusal::bad_argument;
  fifos_.start(fifo, time, position);
  return Refusal::none;
}

Jet PtFifos::at(double time) {
  const bool moved = fifos_.moving();
  const Jet now = fifos_.at(time);
  if (moved && !fifos_.moving() && fifos_.stream()) fifos_.clear(0);  // the next one begins anew
  return now;
}

}  // namespace jounce::googol

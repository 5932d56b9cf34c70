// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan_progress.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jounce {
namespace {

/// The q from which on the velocity only falls; a rest at the end is left out.
double braking_from(const TimingLaw& law) {
  const LawStretches& stretches = law.stretches();
  const LawInterval last = stretches.back();
  double from = last.start + last.length;
  bool moves = false;
  for (std::size_t i = stretches.size(); i-- > 0;) {
    const LawInterval s = stretches[i];
    if (s.pieces == 0 && moves) break;
    moves = moves || s.pieces > 0;
    std::array<LawPhase, 7> phase;
    for (std::size_t k = s.pieces == 0 ? 0 : phases(s, phase); k-- > 0;) {
      const double mean = phase[k].acceleration + phase[k].jerk * phase[k].duration / 2;
      if (mean >= 0) return from;
      from = s.start + phase[k].position;
    }
  }
  return from;
}

}  // namespace

PlanProgress::PlanProgress(std::shared_ptr<const Plan> plan)
    : plan_(std::move(plan)), brakes_(braking_from(plan_->law())) {
  const auto pieces = plan_->drawn().pieces();
  left_.resize(pieces.size());
  std::uint32_t left = 0;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    if (k + 1 == pieces.size() || pieces[k].line != pieces[k + 1].line) ++left;
    left_[k] = left;
  }
}

PlanPlace PlanProgress::at(double t) const {
  const double now = std::clamp(t, 0.0, plan_->duration());
  PlanPlace place{.position = plan_->law().at(now).position, .remaining = plan_->duration() - now};
  place.look_ahead = std::max(0.0, brakes_ - place.position);
  const auto pieces = plan_->drawn().pieces();
  const auto after = std::upper_bound(pieces.begin() + 1, pieces.end(), place.position,
                                      [](double q, const PathPiece& p) { return q < p.start; });
  const auto here = static_cast<std::size_t>(after - pieces.begin()) - 1;
  place.line = pieces[here].line;
  place.commands = left_[here];
  return place;
}

}  // namespace jounce

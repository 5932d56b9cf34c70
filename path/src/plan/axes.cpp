// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "jounce/path/axes_by_stretch.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/detail/compensated_sum.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/timing/box.hpp"
#include "path/src/timing/stretch.hpp"

// A stretch of the law within one piece of the path is composed in its own coordinates, from 0 to
// the length of the piece, so no digits are lost far from the start of the path. At constant
// velocity, the segment of the path is the motion, over another length. On a line, the law times
// the direction is the motion.

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::rounded_input;
using profiles_detail::rounded_root;
using profiles_detail::rounded_sum;

constexpr double fit_rounding = 2e-14;  ///< share of the positions
using Cut = AxesByStretch::Cut;

/// The s in [from, 1] at which an ascending segment has the value y.
double place_of(const Segment& f, double y, double from) {
  double low = from;
  double high = 1;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (value(f, middle) < y ? low : high) = middle;
  }
  return low;
}

/// Returns the number of cuts at the beginning of `out`; the memory of the others is used again.
/// `offset`: place of the start of the stretch on its first piece; then that of its end on the last.
std::size_t cut_at_pieces(const Path& path, const LawInterval& stretch, double& offset,
                          std::vector<Cut>& out) {
  std::array<LawPhase, 7> phase;
  const std::size_t count = phases(stretch, phase);
  std::size_t used = 0;
  const auto begin_piece = [&](std::size_t number) {
    if (used == out.size()) out.emplace_back();
    out[used].piece = number;
    out[used++].law.clear();
  };
  // Each part is computed from its whole phase, and each place from the lengths of the pieces: a phase
  // may extend over many thousands of pieces, in which rounding would add up.
  std::size_t piece = stretch.piece;
  profiles_detail::CompensatedSum ends;  // the end of this piece, from the start of the first one
  ends.add(path.pieces()[piece].length);
  double begin = -offset;  // of this piece, from the start of the stretch
  begin_piece(piece);
  for (std::size_t i = 0; i < count; ++i) {
    const Segment phase_of = segment_of(phase[i]);
    double from = 0;
    const auto add_to = [&](double s) {
      if (!(s > from)) return;
      const Segment law = from > 0 || s < 1 ? part(phase_of, from, s) : phase_of;
      if (law.length > 0) out[used - 1].law.push_back(scaled(law, 1, -begin));
      from = s;
    };
    while (piece + 1 < stretch.piece + stretch.pieces) {
      const double end = ends.value() - offset;
      if (value(phase_of, 1) < end) break;
      add_to(place_of(phase_of, end, from));
      begin_piece(++piece);
      ends.add(path.pieces()[piece].length);
      begin = end;
      if (!(from < 1)) break;
    }
    add_to(1);
  }
  offset = stretch.length - begin;
  return used;
}

/// Removes the phases that cutting left by rounding: without distance and of constant velocity.
void drop_slivers(Cut& cut, double length) {
  std::erase_if(cut.law, [&](const Segment& f) {
    const auto [x0, v0, a0, j0] = evaluate(f, 0);
    const double v1 = evaluate(f, 1)[1];
    const double change = std::max(std::abs(v1 - v0), std::abs(a0) * f.length);
    return value(f, 1) - x0 <= rounded_sum * length && change <= rounded_input * std::max(v0, v1);
  });
}

/// True if the velocity is constant over the whole piece.
bool is_constant(const std::vector<Segment>& law, const PathPiece& piece) {
  // A short piece far from the start of the path: its ends are rounded to a digit of that distance.
  const double rounding = std::max(rounded_root * piece.length, rounded_digit * piece.start);
  return law.size() == 1 && law.front().degree <= 1 && std::abs(law.front().c[0]) <= rounding &&
         std::abs(value(law.front(), 1) - piece.length) <= rounding;
}

/// Half of the difference between each limit and its peak in the plan, on a piece that is not a
/// line; the other half is for rounding.
Jet allowed_error(const Limits& limits, double tolerance) {
  const auto share = [](const std::optional<double>& limit) {
    return limit ? fit_share / 2 * *limit : PathSettings::none;
  };
  return {tolerance, share(limits.velocity), share(limits.acceleration), share(limits.jerk)};
}

/// The limits of an axis, each lowered to the lowest one of the commands.
Limits lowest_limits(const Plan::Given& given, std::size_t axis) {
  Limits limits = given.limits.axes[axis];
  const auto lower = [](std::optional<double>& limit, double by) {
    if (by < PathSettings::none) limit = std::min(limit.value_or(by), by);
  };
  for (const PathSettings& settings : given.settings) {
    if (axis >= settings.axes.size()) continue;
    lower(limits.velocity, settings.axes[axis].velocity);
    lower(limits.acceleration, settings.axes[axis].acceleration);
    lower(limits.jerk, settings.axes[axis].jerk);
  }
  return limits;
}

/// The composition, with an error within `allowed`, or within rounding if that is greater.
Fitted<OverTime> composed_within(const Curve<OverLength>& outer, const Segment& phase,
                                 const Jet& allowed, double rounding) {
  double tolerance = std::max(allowed[0], rounding);
  while (true) {
    Fitted<OverTime> fit = composed_within(outer, Trajectory({phase}), tolerance);
    bool kept = true;
    for (std::size_t k = 1; k < allowed.size(); ++k) kept = kept && fit.error[k] <= allowed[k];
    if (kept || tolerance <= rounding) return fit;
    tolerance = std::max(tolerance / 256, rounding);
  }
}

/// Appends one axis over one cut to `out`, and increases `error` if necessary. `end`: the end of a fit
/// that this cut continues; then the end of the last fit, or nullopt.
void compose(const Path& path, const Cut& cut, std::size_t axis, const Jet& allowed,
             std::vector<Segment>& pieces, std::vector<Segment>& out, Jet& error,
             std::optional<double>& end) {
  if (cut.law.empty()) return;
  const std::optional<double> before = std::exchange(end, std::nullopt);
  pieces.clear();
  path.segments(cut.piece, axis, pieces);
  const bool line = pieces.size() == 1 && pieces.front().degree <= 1 && pieces.front().sines == 0;
  const double length = path.pieces()[cut.piece].length;
  if (line) {
    const double start = pieces.front().c[0];
    const double slope = pieces.front().c[1] / length;
    for (const Segment& f : cut.law) out.push_back(scaled(f, slope, start));
    return;
  }
  if (is_constant(cut.law, path.pieces()[cut.piece])) {
    const double velocity = cut.law.front().c[1] / cut.law.front().length;
    for (Segment f : pieces) {
      f.length /= velocity;
      out.push_back(f);
    }
    return;
  }
  // By rounding, the law may exceed the ends of the piece a little; the formula continues there.
  constexpr double over = 1.0 / 64;
  const double begin = -over * pieces.front().length;
  pieces.front() = part(pieces.front(), -over, 1);
  pieces.back() = part(pieces.back(), 0, 1 + over);
  // Each phase is relative to its own start: the values of a short phase are then small, and so is
  // their rounding. On an arc of a large radius, a position has the rounding of the radius, which would
  // be a step: there, a phase begins where the previous fit ends.
  constexpr double large = 1e3;  // lengths of the piece
  double farthest = 0;
  for (const Segment& f : pieces) farthest = std::max(farthest, magnitude(f));
  const bool chained = farthest > large * length;
  if (chained) end = before;
  std::vector<Segment> relative(pieces.size());
  const Curve<OverLength> whole(pieces, begin, Extrapolation::hold);
  for (const Segment& phase : cut.law) {
    const double origin = whole.at(value(phase, 0)).position;
    std::transform(pieces.begin(), pieces.end(), relative.begin(),
                   [&](const Segment& f) { return scaled(f, 1, -origin); });
    double scale = 0;
    for (const Segment& f : relative) scale = std::max(scale, magnitude(f));
    const Fitted<OverTime> fit =
        composed_within(Curve<OverLength>(relative, begin, Extrapolation::hold), phase, allowed,
                        fit_rounding * scale);
    const double start = end ? *end - value(fit.curve.segments().front(), 0) : origin;
    for (const Segment& f : fit.curve.segments()) out.push_back(scaled(f, 1, start));
    if (chained) end = value(out.back(), 1);
    for (std::size_t k = 0; k < error.size(); ++k) error[k] = std::max(error[k], fit.error[k]);
  }
}

}  // namespace

AxesByStretch::AxesByStretch(const Plan& plan, double tolerance)
    : plan_(plan), next_(plan.law().stretches().begin()) {
  require_positive("tolerance", tolerance);
  for (std::size_t i = 0; i < plan.given().limits.axes.size(); ++i)
    allowed_.push_back(allowed_error(lowest_limits(plan.given(), i), tolerance));
  segments_.resize(plan.path().axes());
  piece_of_.resize(plan.path().axes());
  error_.resize(plan.path().axes());
  ends_.resize(plan.path().axes());
}

/// The place of the start of a stretch on its first piece. Far from the start of the path, q has few
/// digits, so the place is 0 or the end of the previous stretch, if it is that to rounding.
double AxesByStretch::offset_of(const LawInterval& stretch) const {
  const double place = stretch.start - plan_.path().pieces()[stretch.piece].start;
  const double rounding = rounded_sum * stretch.start;
  if (stretch.piece == last_.piece && std::abs(place - last_.offset) <= rounding)
    return last_.offset;
  return std::abs(place) <= rounding ? 0 : place;
}

bool AxesByStretch::next() {
  if (next_ == plan_.law().stretches().end()) return false;
  const LawInterval stretch = *next_++;
  for (std::vector<Segment>& segments : segments_) segments.clear();
  for (std::vector<std::size_t>& pieces : piece_of_) pieces.clear();
  const Path& path = plan_.path();
  if (stretch.pieces == 0) {
    const PathPiece& piece = path.pieces()[stretch.piece];
    const Point at =
        path.point(stretch.piece, std::clamp(stretch.start - piece.start, 0.0, piece.length));
    for (std::size_t i = 0; i < segments_.size(); ++i)
      segments_[i].push_back(line(stretch.duration, at[i], at[i]));
    for (std::vector<std::size_t>& pieces : piece_of_) pieces.push_back(stretch.piece);
    return true;
  }
  double offset = offset_of(stretch);
  const bool continues = stretch.piece == last_.piece && offset == last_.offset;
  if (!continues) ends_.assign(ends_.size(), std::nullopt);
  const std::size_t cuts = cut_at_pieces(path, stretch, offset, cuts_);
  last_ = {cuts_[cuts - 1].piece, offset};
  for (Cut& cut : std::span(cuts_).first(cuts)) {
    if (&cut != cuts_.data()) ends_.assign(ends_.size(), std::nullopt);
    drop_slivers(cut, path.pieces()[cut.piece].length);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      compose(path, cut, i, allowed_[i], pieces_, segments_[i], error_[i], ends_[i]);
      piece_of_[i].resize(segments_[i].size(), cut.piece);
    }
  }
  return true;
}

PlanAxes to_axes(const Plan& plan, double tolerance) {
  std::vector<std::vector<Segment>> axes(plan.path().axes());
  AxesByStretch motion(plan, tolerance);
  while (motion.next())
    for (std::size_t i = 0; i < axes.size(); ++i)
      axes[i].insert(axes[i].end(), motion.segments(i).begin(), motion.segments(i).end());
  PlanAxes result{.curves = {}, .error = {motion.error().begin(), motion.error().end()}};
  for (std::vector<Segment>& segments : axes)
    result.curves.emplace_back(std::move(segments), 0, Extrapolation::hold);
  return result;
}

}  // namespace jounce

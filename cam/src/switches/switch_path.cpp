// SPDX-License-Identifier: Apache-2.0
#include "cam/src/switches/switch_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/curve/roots.hpp"

namespace jounce::detail {
namespace {

/// More than a piece of degree 3 has: 2 turns, and 2 of y between any two of them.
constexpr std::size_t room = 32;

/// y = x - c x'.                                                                             (1)
Segment compensated(const TurningPiece& piece, double c) {
  if (c == 0) return piece.x;
  const auto y = sum(piece.x, scaled(piece.velocity, -c));
  assert(y);  // the sines of x' are those of x
  return *y;
}

/// Where a parabola changes sign within (0, 1), ascending. Without cancellation: one root by the
/// larger numerator, the other by their product c / a.                                       (2)
void find_changes(const Segment& parabola, std::vector<double>& out) {
  const double a = parabola.c[2];
  const double b = parabola.c[1];
  const double c = parabola.c[0];
  const double d = b * b - 4 * a * c;
  if (!(d > 0)) return;  // a touch is no change
  const double q = -(b + std::copysign(std::sqrt(d), b)) / 2;
  for (const double s : {q / a, c / q})
    if (s > 0 && s < 1) out.push_back(s);
  std::sort(out.begin(), out.end());
}

/// Where f turns round within (0, 1). A parabola in closed form, for the cycle's sake: roots() may
/// answer many points where a derivative is about as large as its rounding.
void find_turns(const Segment& f, const Segment& derivative, std::vector<double>& out) {
  out.clear();
  if (derivative.sines == 0 && derivative.degree <= 2) return find_changes(derivative, out);
  roots(derivative, 2e-16 * magnitude(f) / f.length, out);
}

}  // namespace

TurningPiece::TurningPiece() {
  turns.reserve(room);
}

void TurningPiece::set(const Segment& motion) {
  x = motion;
  velocity = derivative(motion);
  find_turns(x, velocity, turns);
  turns.insert(turns.begin(), 0);
  turns.push_back(1);
}

SwitchPath::SwitchPath(double forwards, double backwards)
    : forwards_(forwards), backwards_(backwards) {
  stretches_.reserve(room);
  turns_.reserve(room);
}

void SwitchPath::place(double x, double velocity) {
  last_ = x - (velocity > 0 ? forwards_ : backwards_) * velocity;
}

void SwitchPath::begin(const TurningPiece& piece) {
  stretches_.clear();
  if (forwards_ != 0 || backwards_ != 0) {
    ahead_ = compensated(piece, forwards_);
    back_ = compensated(piece, backwards_);
  } else {
    ahead_ = back_ = piece.x;
  }
  for (std::size_t i = 1; i < piece.turns.size(); ++i)
    add(piece, piece.turns[i - 1], piece.turns[i]);
  last_ = stretches_.back().to;
}

/// The stretches of one way, whose y may itself turn round: a lead under hard braking.
void SwitchPath::add(const TurningPiece& piece, double begin, double end) {
  const bool forwards = value(piece.velocity, (begin + end) / 2) >= 0;
  const Segment& y = forwards ? ahead_ : back_;
  turns_.clear();
  if ((forwards ? forwards_ : backwards_) != 0) find_turns(y, derivative(y), turns_);
  const double from = value(y, begin);
  // Where the velocity jumps, y does: the boundaries in between are passed at that instant.
  if (from != last_) stretches_.push_back({begin, begin, last_, from, forwards});
  MonotonePart next{begin, begin, from, from, forwards};
  const auto close = [&](double s) {
    next = {next.end, s, next.to, value(y, s), forwards};
    stretches_.push_back(next);
  };
  for (const double s : turns_)
    if (s > begin && s < end) close(s);
  close(end);
  last_ = next.to;
}

/// Newton's method, kept within a bracket: y - target changes sign once over the stretch.
double SwitchPath::time(const MonotonePart& stretch, double target) const {
  const Segment& y = stretch.forwards ? ahead_ : back_;
  double a = stretch.begin;
  double b = stretch.end;
  if (a == b) return a * y.length;
  const bool rising = stretch.to > stretch.from;
  double s =
      a + (b - a) * std::clamp((target - stretch.from) / (stretch.to - stretch.from), 0., 1.);
  for (int i = 0; i < 100; ++i) {
    const Jet f = evaluate(y, s);
    const double miss = f[0] - target;
    if (miss == 0) break;
    ((miss > 0) == rising ? b : a) = s;
    const double newton = s - miss / (f[1] * y.length);
    const double next = newton > a && newton < b ? newton : a + (b - a) / 2;
    if (next == s || b - a <= 2e-16) break;
    s = next;
  }
  return s * y.length;
}

}  // namespace jounce::detail

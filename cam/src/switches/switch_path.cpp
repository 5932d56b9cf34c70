// SPDX-License-Identifier: Apache-2.0
#include "cam/src/switches/switch_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/curve/roots.hpp"

namespace jounce::cam_detail {
namespace {

/// More than the maximum for a piece of degree 3: 2 reversals of the axis, and 2 of y between any
/// two of them.
constexpr std::size_t room = 32;

/// Equation (1): y = x - c x'.
Segment compensated(const TurningPiece& piece, double c) {
  if (c == 0) return piece.x;
  const auto y = sum(piece.x, scaled(piece.velocity, -c));
  assert(y);  // the sines of x' are those of x
  return *y;
}

/// Finds the sign changes of a parabola within (0, 1), ascending. To avoid cancellation, one root
/// comes from the larger numerator, the other from their product c / a. (2)
void find_changes(const Segment& parabola, std::vector<double>& out) {
  const double a = parabola.c[2];
  const double b = parabola.c[1];
  const double c = parabola.c[0];
  const double d = b * b - 4 * a * c;
  if (!(d > 0)) return;  // a double root is not a sign change
  const double q = -(b + std::copysign(std::sqrt(d), b)) / 2;
  for (const double s : {q / a, c / q})
    if (s > 0 && s < 1) out.push_back(s);
  std::sort(out.begin(), out.end());
}

/// Finds the reversals of f within (0, 1). Solves a parabola in closed form, for a bounded cycle
/// time: roots() may return many points if a derivative is about as large as its rounding.
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
  parts_.reserve(room);
  turns_.reserve(room);
}

void SwitchPath::place(double x, double velocity) {
  last_ = x - (velocity > 0 ? forwards_ : backwards_) * velocity;
}

void SwitchPath::begin(const TurningPiece& piece) {
  parts_.clear();
  if (forwards_ != 0 || backwards_ != 0) {
    ahead_ = compensated(piece, forwards_);
    back_ = compensated(piece, backwards_);
  } else {
    ahead_ = back_ = piece.x;
  }
  for (std::size_t i = 1; i < piece.turns.size(); ++i)
    add(piece, piece.turns[i - 1], piece.turns[i]);
  last_ = parts_.back().to;
}

/// Adds the intervals of one direction. y itself may reverse in them, for example by a lead during
/// hard braking.
void SwitchPath::add(const TurningPiece& piece, double begin, double end) {
  const bool forwards = value(piece.velocity, (begin + end) / 2) >= 0;
  const Segment& y = forwards ? ahead_ : back_;
  turns_.clear();
  if ((forwards ? forwards_ : backwards_) != 0) find_turns(y, derivative(y), turns_);
  const double from = value(y, begin);
  // A jump of the velocity is a jump of y: it passes the boundaries in between at that instant.
  if (from != last_) parts_.push_back({begin, begin, last_, from, forwards});
  MonotonePart next{begin, begin, from, from, forwards};
  const auto close = [&](double s) {
    next = {next.end, s, next.to, value(y, s), forwards};
    parts_.push_back(next);
  };
  for (const double s : turns_)
    if (s > begin && s < end) close(s);
  close(end);
  last_ = next.to;
}

/// Newton's method inside a bracket: y - target changes sign once over the interval.
double SwitchPath::time(const MonotonePart& part, double target) const {
  const Segment& y = part.forwards ? ahead_ : back_;
  double a = part.begin;
  double b = part.end;
  if (a == b) return a * y.length;
  const bool rising = part.to > part.from;
  double s = a + (b - a) * std::clamp((target - part.from) / (part.to - part.from), 0., 1.);
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

}  // namespace jounce::cam_detail

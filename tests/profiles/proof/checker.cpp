// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "profiles/proof/envelope.hpp"

namespace jounce::proof {
namespace {

using Real = long double;

struct State {
  Real p = 0, v = 0, a = 0, j = 0;
};

/// A stretch of constant jerk.
struct Piece {
  State begin;
  Real length = 0;

  [[nodiscard]] State at(Real t) const {
    const auto& [p, v, a, j] = begin;
    return {p + v * t + a * t * t / 2 + j * t * t * t / 6, v + a * t + j * t * t / 2, a + j * t, j};
  }
};

/// The motion as pieces, where a profile of lower order steps in velocity or acceleration.
std::vector<Piece> integrated(const Profile& f) {
  State s{f.start().position, f.start().velocity, f.start().acceleration, 0};
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < f.phases(); ++i) {
    const Profile::Phase phase = f.phase(i);
    if (f.order() == 3) s.j = phase.value;
    if (f.order() == 2) s.a = phase.value;
    if (f.order() == 1) s = {s.p, phase.value, 0, 0};
    pieces.push_back({s, phase.duration});
    s = pieces.back().at(phase.duration);
  }
  return pieces;
}

constexpr Real bound_ulps = 4 * 0x1p-53L;  ///< tolerance of a bound
constexpr Real floor_ulps =
    16 * 0x1p-53L / tolerance;  ///< tolerance of the sums with nothing cancelled

/// The same terms with nothing cancelled, at the end of each piece.
std::vector<State> uncancelled(const std::vector<Piece>& pieces, const MotionState& from) {
  const auto size = [](const State& s) {
    return State{std::abs(s.p), std::abs(s.v), std::abs(s.a), std::abs(s.j)};
  };
  State s = size({from.position, from.velocity, from.acceleration, 0});
  std::vector<State> ends;
  for (const Piece& piece : pieces) {
    const State begin = size(piece.begin);  // the value to which a lower order steps
    s = {s.p, std::max(s.v, begin.v), std::max(s.a, begin.a), begin.j};
    s = Piece{s, 0}.at(piece.length);
    ends.push_back(s);
  }
  return ends;
}

Scale sums(const std::vector<Piece>& pieces, const Case& c) {
  const auto both = [](double a, double b) { return std::abs(Real{a}) + std::abs(Real{b}); };
  const Real J = std::max(c.bounds.jerk_max, -c.bounds.jerk_min);
  Scale s{both(c.from.position, c.to.position), both(c.from.velocity, c.to.velocity),
          both(c.from.acceleration, c.to.acceleration)};
  for (const Real a : {std::abs(Real{c.from.acceleration}), std::abs(Real{c.to.acceleration})}) {
    s.velocity += a * a / (2 * J);
    s.position += a * a * a / (6 * J * J);
  }
  for (const Piece& piece : pieces) {
    const Real t = piece.length;
    const Real v = std::abs(piece.begin.v);
    const Real a = std::abs(piece.begin.a);
    const Real j = std::abs(piece.begin.j);
    s.acceleration += j * t;
    s.velocity += a * t + j * t * t / 2;
    s.position += v * t + a * t * t / 2 + j * t * t * t / 6;
  }
  return s;
}

/// Absolute resolution.
Scale floor_of(const std::vector<State>& ends, const Bounds& b) {
  const auto resolved = [](double min, double max) {
    const double least = std::min(-min, max);
    return std::isfinite(least) ? least * bound_ulps : 0;
  };
  const State sum = ends.empty() ? State{} : ends.back();
  constexpr Real ulps = floor_ulps * tolerance;
  return {sum.p * ulps, std::max(sum.v * ulps, resolved(b.velocity_min, b.velocity_max)),
          std::max(sum.a * ulps, resolved(b.acceleration_min, b.acceleration_max))};
}

Scale scale_of(const Scale& s, const Scale& floor) {
  return {std::max(s.position, floor.position / tolerance),
          std::max(s.velocity, floor.velocity / tolerance),
          std::max(s.acceleration, floor.acceleration / tolerance)};
}

/// The times in (0, length) at which c0 + c1 t + c2 t^2 vanishes.
std::vector<Real> zeros(Real c0, Real c1, Real c2, Real length) {
  std::vector<Real> t;
  const Real d = c1 * c1 - 4 * c2 * c0;
  if (c2 == 0) {
    if (c1 != 0) t.push_back(-c0 / c1);
  } else if (d >= 0) {
    const Real h = -(c1 + std::copysign(std::sqrt(d), c1)) / 2;
    if (h != 0) t.push_back(c0 / h);
    t.push_back(h / c2);
  }
  std::erase_if(t, [length](Real x) { return !(x > 0 && x < length); });
  std::sort(t.begin(), t.end());
  return t;
}

/// One side of the problem: everything negated for the other.
State signed_by(const State& s, Real sign) {
  return {sign * s.p, sign * s.v, sign * s.a, sign * s.j};
}

class Check {
 public:
  Check(const Profile& f, const Case& c, const Bounds& b, Real hold)
      : f_(f),
        c_(c),
        b_(b),
        hold_(hold),
        pieces_(integrated(f)),
        sizes_(uncancelled(pieces_, c.from)) {
    verdict_.floor = floor_of(sizes_, c.bounds);
    verdict_.scale = scale_of(sums(pieces_, c), verdict_.floor);
    for (const Piece& piece : pieces_) verdict_.duration += piece.length;
  }

  Verdict run() {
    exact();
    if (!verdict_.ok()) return verdict_;
    end();
    limits(1, upper(b_));
    limits(-1, lower(b_));
    return verdict_;
  }

 private:
  void fail(const std::string& text) {
    if (verdict_.ok()) verdict_.fault = text;
  }
  void exact();
  [[nodiscard]] Real instant() const;
  void end();
  void limits(Real sign, const Side& side);
  void acceleration(Real sign, const Side& side);
  void velocity(Real sign, const Side& side);
  [[nodiscard]] Real start_peak() const;  ///< unavoidable peak of the velocity, in magnitude
  void position(Real sign);
  /// Notes how far x lies above a bound; false where that is too far.
  bool below(Real x, Real bound, Real scale, const char* what);

  const Profile& f_;
  const Case& c_;
  Bounds b_;       ///< in force
  Real hold_;      ///< s that the start's acceleration is held
  Real sign_ = 1;  ///< sign of the checked side
  std::vector<Piece> pieces_;
  std::vector<State> sizes_;  ///< see uncancelled
  Verdict verdict_;
};

std::string six_digits(Real x) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6Lg", x);
  return buffer.data();
}

/// Compares the state of a motion of that order: its control may step, so it is no part of the
/// state.
bool equal(const MotionState& x, const MotionState& y, int order) {
  return x.position == y.position && (order < 2 || x.velocity == y.velocity) &&
         (order < 3 || x.acceleration == y.acceleration);
}

void Check::exact() {
  const Bounds& b = c_.bounds;
  const int order = std::isfinite(b.jerk_max) ? 3 : (std::isfinite(b.acceleration_max) ? 2 : 1);
  if (f_.order() != order) fail("the order does not follow from the bounds");
  if (!equal(f_.start(), c_.from, order)) fail("start() is not the state asked for");
  if (!equal(f_.end(), c_.to, order)) fail("end() is not the state asked for");
  for (std::size_t i = 0; i < f_.phases(); ++i)
    if (!(f_.phase(i).duration > 0) || !std::isfinite(f_.phase(i).duration) ||
        !std::isfinite(f_.phase(i).value))
      fail("phase " + std::to_string(i + 1) + " is not finite or not longer than 0");
  const Real T = verdict_.duration;
  if (!(std::abs(f_.duration() - T) <= 1e-15L * T)) fail("duration() is not the sum of the phases");
  verdict_.instant = instant();
  if (c_.duration && !(std::abs(T - Real{*c_.duration}) <= verdict_.instant))
    fail("lasts " + six_digits(*c_.duration) + " and " + six_digits(T - Real{*c_.duration}) +
         ", not the duration asked for");
}

/// Resolution of a duration: `tolerance` of it and of the time in which the bound of the control
/// builds up the next lower bound (a_max/j_max; order 2: v_max/a_max), the axis' own measure of
/// time.
Real Check::instant() const {
  const auto least = [](double min, double max) { return std::min(-min, max); };
  const Bounds& b = c_.bounds;
  const Real a = least(b.acceleration_min, b.acceleration_max);
  const Real rise = f_.order() == 3 ? a / least(b.jerk_min, b.jerk_max)
                                    : least(b.velocity_min, b.velocity_max) / a;
  return tolerance * (c_.duration.value_or(static_cast<double>(verdict_.duration)) +
                      (f_.order() > 1 && std::isfinite(rise) ? rise : 0));
}

void Check::end() {
  const MotionState start = f_.start();
  const State s = pieces_.empty() ? State{start.position, start.velocity, start.acceleration, 0}
                                  : pieces_.back().at(pieces_.back().length);
  const auto compare = [this](Real is, double wanted, Real scale, const char* what) {
    const Real error = is == wanted ? 0 : std::abs(is - wanted) / scale;
    verdict_.end_error = std::max(verdict_.end_error, static_cast<double>(error));
    if (!(error <= tolerance))
      fail(std::string("ends off in ") + what + " by " + six_digits(error) + " of its scale");
  };
  compare(s.p, f_.end().position, verdict_.scale.position, "position");
  if (f_.order() > 1) compare(s.v, f_.end().velocity, verdict_.scale.velocity, "velocity");
  if (f_.order() > 2)
    compare(s.a, f_.end().acceleration, verdict_.scale.acceleration, "acceleration");
}

bool Check::below(Real x, Real bound, Real scale, const char* what) {
  if (x <= bound) return true;
  const Real excess = (x - bound) / scale;
  verdict_.excess = std::max(verdict_.excess, static_cast<double>(excess));
  if (excess <= tolerance) return true;
  fail(std::string(what) + (sign_ > 0 ? "_max" : "_min") + " exceeds its bound by " +
       six_digits(excess) + " of its scale");
  return false;
}

/// The larger of the finite ones, and of the start.
Real magnitude(double min, double max, Real start) {
  Real m = std::abs(start);
  for (const double x : {min, max})
    if (std::isfinite(x)) m = std::max(m, std::abs(Real{x}));
  return m;
}

void Check::limits(Real sign, const Side& side) {
  sign_ = sign;
  const auto control = [&](Real x, Real bound, double least, double most, const char* what) {
    below(x, bound, magnitude(least, most, 0), what);
  };
  const Bounds& b = b_;
  for (const Piece& piece : pieces_) {
    const State s = signed_by(piece.begin, sign);
    if (f_.order() == 3) control(s.j, side.rise, b.jerk_min, b.jerk_max, "jerk");
    if (f_.order() == 2)
      control(s.a, side.a_max, b.acceleration_min, b.acceleration_max, "acceleration");
    if (f_.order() == 1) control(s.v, side.top, b.velocity_min, b.velocity_max, "velocity");
  }
  if (f_.order() == 3) acceleration(sign, side);
  if (f_.order() > 1) velocity(sign, side);
  position(sign);
}

/// Outside, it returns at full jerk.
///
/// Where the start's acceleration is held first, the return may begin within the last digits of that hold:
/// a phase is a double, and the hold h may be thousands of times the return that follows, r = (a0 - a)/j.
/// Half an ulp of h at full jerk is 2^-53 h/r of the change: of h/r = 2e4 on, more than `tolerance`, so
/// that no double is within both sides of the exact envelope. The instant is therefore resolved as a
/// bound is. Without a hold, nothing is added.
void Check::acceleration(Real sign, const Side& side) {
  const Real start = sign * c_.from.acceleration;
  const Real bound = magnitude(b_.acceleration_min, b_.acceleration_max, start);
  const Real instant = bound_ulps * hold_;
  const Real held = hold_ - instant;
  const auto envelope = [&](Real t) {
    return t < held ? start : std::max(side.a_max, start - side.fall * (t - hold_ - instant));
  };
  const Real inside = hold_ + (start - side.a_max) / side.fall;
  Real begin = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Real scale = std::max(bound, sizes_[i].a * floor_ulps);
    const auto compare = [&](Real t) {
      below(sign * pieces_[i].at(t).a, envelope(begin + t), scale, "acceleration");
    };
    const Real length = pieces_[i].length;
    if (inside > begin && inside < begin + length) compare(inside - begin);
    if (held > begin && held <= begin + length)
      below(sign * pieces_[i].at(held - begin).a, start, scale, "acceleration");
    compare(length);
    begin += length;
  }
}

/// The instants of a piece at which its velocity can pass another most: where their accelerations are
/// equal, where the other's jerk steps, and the end. From the piece's own begin: that of a late
/// piece has lost digits.
std::vector<Real> instants(const Piece& piece, Real begin, const Envelope& envelope, Real sign) {
  std::vector<Real> times{piece.length};
  for (std::size_t i = 0; i < envelope.arcs.size(); ++i) {
    const Arc& arc = envelope.arcs[i];
    const Real from = std::max<Real>(arc.begin - begin, 0);
    const Real to = i + 1 < envelope.arcs.size()
                        ? std::min(envelope.arcs[i + 1].begin - begin, piece.length)
                        : piece.length;
    if (from >= to) continue;
    if (from > 0) times.push_back(from);
    const State at = signed_by(piece.at(from), sign);
    const Real other = arc.acceleration(std::max(arc.begin, begin));
    for (const Real t : zeros(at.a - other, at.j - arc.j, 0, to - from)) times.push_back(from + t);
  }
  return times;
}

void Check::velocity(Real sign, const Side& side) {
  const Real v = c_.from.velocity + hold_ * c_.from.acceleration;
  const Envelope limit = envelope(sign * v, sign * c_.from.acceleration, side);
  const Real bound =
      std::max(magnitude(b_.velocity_min, b_.velocity_max, c_.from.velocity), start_peak());
  Real begin = -hold_;  // before that the acceleration is given
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Real scale = std::max(bound, sizes_[i].v * floor_ulps);
    for (const Real t : instants(pieces_[i], begin, limit, sign))
      if (begin + t >= 0)
        below(sign * pieces_[i].at(t).v, limit.velocity(begin + t), scale, "velocity");
    begin += pieces_[i].length;
  }
}

Real Check::start_peak() const {
  if (f_.order() != 3) return 0;
  const Real a = c_.from.acceleration;
  const Real brake = a > 0 ? -Real{c_.bounds.jerk_min} : Real{c_.bounds.jerk_max};
  return std::abs(c_.from.velocity + a * std::abs(a) / (2 * brake));
}

void Check::position(Real sign) {
  const Real top = sign > 0 ? c_.bounds.position_max : -c_.bounds.position_min;
  for (const Piece& piece : pieces_) {
    std::vector<Real> times = zeros(piece.begin.v, piece.begin.a, piece.begin.j / 2, piece.length);
    times.push_back(piece.length);
    for (const Real t : times)
      below(sign * piece.at(t).p, top, verdict_.scale.position, "position");
  }
}

std::string hex(double x) {
  if (std::isinf(x)) return x > 0 ? "Bounds::none" : "-Bounds::none";
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%a", x);
  return buffer.data();
}

std::string state(const MotionState& s) {
  return "{" + hex(s.position) + ", " + hex(s.velocity) + ", " + hex(s.acceleration) + "}";
}

}  // namespace

Verdict check(const Profile& profile, const Case& c) {
  if (c.by_velocity) return Check(profile, c, c.bounds, 0).run();
  const Force force = in_force(c.from, c.to, c.bounds);
  const Verdict shortest = Check(profile, c, force.bounds, force.hold).run();
  if (shortest.ok() || !c.duration || force.longer == force.bounds) return shortest;
  return Check(profile, c, force.longer, force.hold).run();
}

std::string reproducer(const Case& c) {
  const Bounds& b = c.bounds;
  std::string text = "move_to(" + state(c.from) + ", " + state(c.to) + ", {";
  for (const double x : {b.velocity_min, b.velocity_max, b.acceleration_min, b.acceleration_max,
                         b.jerk_min, b.jerk_max, b.position_min, b.position_max})
    text += hex(x) + ", ";
  text.resize(text.size() - 2);
  text += "}";
  if (c.duration) text += ", " + hex(*c.duration);
  return text + ");";
}

}  // namespace jounce::proof

// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/sample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/check.hpp"

#include "pvt/src/sample/knot_rounding.hpp"
#include "pvt/src/sample/longest.hpp"
#include "pvt/src/sample/within_limits.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;
using profiles_detail::two_roundings;
/// Sets the last values of a periodic table exactly to the first ones, if they differ only by
/// rounding.
void close_period(std::vector<double>& column) {
  if (column.empty()) return;
  double scale = 0;
  for (const double value : column) scale = std::max(scale, std::abs(value));
  if (std::abs(column.back() - column.front()) <= rounded_sum * scale)
    column.back() = column.front();
}

template <class Over>
Columns columns_at(const Curve<Over>& f, Interpolation rule, std::vector<double> knots) {
  Columns columns;
  for (const double x : knots) {
    const Jet jet = f.jet(x, x == f.end() ? Side::left : Side::right);
    columns.p.push_back(jet[0]);
    if (rule != Interpolation::linear) columns.v.push_back(jet[1]);
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(jet[2]);
  }
  columns.x = std::move(knots);
  return columns;
}

/// The knots, and more where the table exceeds a limit that the curve keeps.
template <class Over>
std::vector<double> within_limits(const Curve<Over>& f, Interpolation rule, const Limits& limits,
                                  const RampedLimits& ramped, const std::vector<double>& knots) {
  std::vector<pvt_detail::Knot> all;
  for (const double x : knots)
    all.push_back(pvt_detail::knot_at(f, x, x == f.end() ? Side::left : Side::right));
  std::vector<double> places;
  for (const pvt_detail::Knot& knot : pvt_detail::knots_within_limits(f, rule, limits, ramped, all))
    places.push_back(knot.x);
  return places;
}

/// The exact error of the table: the difference is a curve of the same kind (a Hermite piece minus
/// a segment keeps the segment's sines), so its extrema are exact too.
template <class Over>
SampleError error_of(const Curve<Over>& f, const Table& table) {
  const Curve<Over> opposite =
      f.outside() == table.outside() ? scaled(f, -1) : scaled(with(f, table.outside()), -1);
  const auto difference = sum(table.curve<Over>(), opposite);
  const Ranges ranges = extrema(difference);
  return {std::abs(ranges[0].peak().value), ranges[0].peak().where,
          std::abs(ranges[1].peak().value)};
}

std::vector<double> equal_parts(double from, double to, std::size_t intervals) {
  std::vector<double> knots;
  for (std::size_t i = 0; i < intervals; ++i)
    knots.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(intervals));
  return knots;
}

/// A knot has one velocity and one acceleration. If those of the curve step, the table has the
/// right limits. In the interval before the step, it deviates (greatest values of the Hermite
/// shapes) by at most
///
///     (1)  cubic:   4/27 |dv| d;      quintic:   0.2 |dv| d + 0.01728 |da| d^2
///
/// over an interval of length d. So this interval is made so short that it uses an eighth of
/// `wanted`. At its end, a curve that repeats has the values of its start.
template <class Over>
std::vector<double> shortened_before_steps(const Curve<Over>& f, Interpolation rule, double wanted,
                                           const std::vector<double>& knots) {
  std::vector<double> all{knots.front()};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double x = knots[i];
    if (rule != Interpolation::linear && (x != f.end() || repeats(f.outside()))) {
      const Jet left = f.jet(x, Side::left);
      const Jet right = f.jet(x == f.end() ? f.start() : x, Side::right);
      const double dv = std::abs(right[1] - left[1]);
      const double da = rule == Interpolation::quintic_hermite ? std::abs(right[2] - left[2]) : 0;
      double d = x - all.back();
      const auto stray = [&] { return 0.2 * dv * d + 0.01728 * da * d * d; };
      while (stray() > wanted / 8 && x - d / 2 < x) d /= 2;
      if (d < x - all.back()) all.push_back(x - d);
    }
    all.push_back(x);
  }
  return all;
}

/// An error e of the position of a knot adds to the third derivative, in an interval of length L, up to
///
///     (2)  120 e / L^3   (quintic),   24 e / L^3   (cubic)
///
/// This is `share` of the curve's third derivative at the length that this function returns.
template <class Over>
double noisy_length(const Curve<Over>& f, Interpolation rule, double e, double share) {
  const double jerk = std::abs(extrema(f, 3).peak().value);
  if (rule == Interpolation::linear || !(jerk > 0)) return 0;
  return std::cbrt((rule == Interpolation::quintic_hermite ? 120 : 24) * e / (share * jerk));
}

/// The rounding of a position alone.
template <class Over>
double position_rounding(const Curve<Over>& f) {
  return std::numeric_limits<double>::epsilon() * std::abs(extrema(f, 0).peak().value);
}

constexpr double visible_noise = 1e-3;  ///< share of the jerk that makes an interval too short
constexpr double settled_noise =
    0.25 * rounded_input;  ///< a quarter of the excess that an executor permits

/// The greatest magnitudes of the derivatives of a table's interval or of a curve.
std::array<double, 4> peaks_of(const Ranges& ranges) {
  std::array<double, 4> peaks{};
  for (std::size_t k = 0; k < peaks.size(); ++k) peaks[k] = std::abs(ranges[k].peak().value);
  return peaks;
}

/// Removes knots whose neighbors are so near that the rounding of their positions is visible in the
/// jerk, or moves them apart, if the tolerance permits it and no derivative exceeds the greatest
/// one of the curve.
template <class Over>
class Spread {
 public:
  Spread(const Curve<Over>& f, Interpolation rule, double wanted)
      : f_(f),
        rule_(rule),
        allowed_{wanted, profiles_detail::inf},
        rounding_(position_rounding(f)),
        least_(noisy_length(f, rule, rounding_, visible_noise)),
        peaks_(peaks_of(extrema(f))) {}

  [[nodiscard]] std::vector<double> run(std::vector<double> knots) const {
    for (std::size_t i = 0; i + 1 < knots.size();) {
      if (knots[i + 1] - knots[i] >= least_ || !parted(knots, i)) ++i;
    }
    return knots;
  }

 private:
  [[nodiscard]] bool fits(double a, double b) const {
    const pvt_detail::Knot from = pvt_detail::knot_at(f_, a, Side::right);
    const pvt_detail::Knot to =
        pvt_detail::knot_at(f_, b, b == f_.end() ? Side::left : Side::right);
    return pvt_detail::share(f_, rule_, from, to, allowed_) <= 1 && keeps_peaks(a, b);
  }

  /// Rounding in this interval may add (2) to the jerk, and d^2 / 12 times (2) to the velocity.
  [[nodiscard]] bool keeps_peaks(double a, double b) const {
    constexpr Domain axis = std::is_same_v<Over, OverTime> ? Domain::time : Domain::master;
    const Table table(axis, rule_, Extrapolation::refuse, columns_at(f_, rule_, {a, b}));
    const std::array<double, 4> here = peaks_of(extrema(table));
    const double length = b - a;
    const double noise = 24 * rounding_;
    const std::array factors{0.0, length * length / 12, length / 6, 1.0};
    for (std::size_t k = 1; k < here.size(); ++k)
      if (here[k] >
          peaks_[k] * (1 + rounded_sum) + factors[k] * noise / profiles_detail::cube(length))
        return false;
    return true;
  }

  /// Moves knot k to x, or removes it (no x); returns false if the tolerance does not permit this.
  bool replaced(std::vector<double>& knots, std::size_t k, std::optional<double> x) const {
    if (k == 0 || k + 1 >= knots.size()) return false;
    const double before = knots[k - 1];
    const double after = knots[k + 1];
    if (!x) {
      if (!fits(before, after)) return false;
      knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    }
    if (*x - before < least_ || after - *x < least_ || !fits(before, *x) || !fits(*x, after))
      return false;
    knots[k] = *x;
    return true;
  }

  /// Makes the interval after knot i longer; returns true if this was possible.
  bool parted(std::vector<double>& knots, std::size_t i) const {
    return replaced(knots, i + 1, {}) || replaced(knots, i, {}) ||
           replaced(knots, i + 1, knots[i] + 2 * least_) ||
           replaced(knots, i, knots[i + 1] - 2 * least_);
  }

  const Curve<Over>& f_;
  Interpolation rule_;
  pvt_detail::Tolerances allowed_;
  double rounding_;
  double least_;
  std::array<double, 4> peaks_;
};

/// True if (3) is the rise of the segment.
bool has_short_rise(const Segment& f) {
  constexpr int greatest = 6;
  return f.degree <= greatest && f.sines == 0;
}

/// f(1) - f(0) of any segment without the rounding of either: the coefficients beyond the constant
/// one, and for each sine 2 amplitude cos(phase + angle / 2) sin(angle / 2).
double rise(const Segment& f) {
  double sum = 0;
  for (auto k = static_cast<std::size_t>(f.degree); k > 0; --k) sum += f.c[k];
  for (std::size_t k = 0; k < static_cast<std::size_t>(f.sines); ++k) {
    const auto& [amplitude, angle, phase] = f.sine[k];
    sum += 2 * amplitude * std::cos(phase + angle / 2) * std::sin(angle / 2);
  }
  return sum;
}

/// f(b) - f(a) without the rounding of either: the sum over the stretches between breaks. With the
/// length h and up to the sixth power, a stretch rises by
///
///     (3)  h (v0 + v1) / 2 + h^2 (a0 - a1) / 10 + h^3 (j0 + j1) / 120
///
/// Successive calls have one common end, and the other ends differ by a few doubles. So the stretch and the
/// jets of the last call are used again.
template <class Over>
class CurveRise {
 public:
  explicit CurveRise(const Curve<Over>& f) : f_(f) {}

  double operator()(double a, double b) {
    const auto breaks = f_.breaks();
    double sum = 0;
    while (a < b) {
      seek(a);
      const double end = a < breaks.back() ? std::min(b, breaks[stretch_ + 1]) : b;
      if (const Segment& piece = f_.segments()[stretch_]; has_short_rise(piece)) {
        const Jet& from = from_.at(f_, a, Side::right);
        const Jet& to = to_.at(f_, end, Side::left);
        const double h = end - a;
        sum += h *
               ((from[1] + to[1]) / 2 + h * ((from[2] - to[2]) / 10 + h * (from[3] + to[3]) / 120));
      } else {
        const auto place = [&](double x) {
          return std::clamp((x - breaks[stretch_]) / piece.length, 0.0, 1.0);
        };
        if (place(a) < place(end)) sum += rise(part(piece, place(a), place(end)));
      }
      a = end;
    }
    return sum;
  }

 private:
  /// The jet of the curve at the last place.
  struct LastJet {
    double x = std::numeric_limits<double>::quiet_NaN();
    Jet jet{};

    const Jet& at(const Curve<Over>& f, double place, Side side) {
      if (place != x) jet = f.jet(x = place, side);
      return jet;
    }
  };

  /// Finds the stretch from a on. A place outside the curve belongs to the first or the last one.
  void seek(double a) {
    const auto breaks = f_.breaks();
    if (breaks[stretch_] <= a && a < breaks[stretch_ + 1]) return;
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, a);
    stretch_ = static_cast<std::size_t>(above - breaks.begin()) - 1;
  }

  const Curve<Over>& f_;
  std::size_t stretch_ = 0;
  LastJet from_, to_;
};

/// Knots that are near each other, such as those of a short phase. Over the length d between them, the
/// rounding e of the rise causes a jerk of 60 e / d^3. So the position of the next knot is that of
/// this one plus the rise, and the next knot moves to a nearby double for which e is small. Where
/// this is not enough, and both adjacent intervals are long, both velocities take the rest of e, as
/// e / d: the interval then has the curve's derivatives, and the adjacent ones change by much less.
///
/// Knots at the velocity 0 stay where they are. From both of them, the knots settle towards the
/// longest interval between them. The sum of the rounding and of the steps of the curve, which is
/// there then, is spread over the long intervals: a part e of it changes the jerk by 60 e / d^3, so
/// each takes a part in proportion to d^3, and the change is the same in all.
template <class Over>
class ShortIntervals {
 public:
  ShortIntervals(const Curve<Over>& f, Interpolation rule)
      : f_(f),
        rule_(rule),
        short_(noisy_length(f, rule, position_rounding(f), visible_noise)),
        noisy_(noisy_length(f, rule, pvt_detail::knot_rounding(f), settled_noise)),
        velocity_(std::abs(extrema(f, 1).peak().value)),
        jerk_(std::abs(extrema(f, 3).peak().value)) {}

  [[nodiscard]] Columns columns(std::vector<double> knots) const {
    Columns all = columns_at(f_, rule_, std::move(knots));
    if (noisy_ == 0) return all;
    const std::size_t last = all.x.size() - 1;
    for (std::size_t rest = 0; rest < last;) {
      std::size_t next = rest + 1;
      while (next < last && !rests(all, next)) ++next;
      settle_between(all, rest, next);
      rest = next;
    }
    return all;
  }

 private:
  /// A position x for a knot. In the interval to another knot, the rise equals that of the curve
  /// except for `error`.
  struct Place {
    double x = 0;
    double position = 0;
    double error = 0;
  };

  static double length(const Columns& all, std::size_t i) { return all.x[i + 1] - all.x[i]; }
  /// At a velocity near 0, another place would not change the position.
  [[nodiscard]] bool rests(const Columns& all, std::size_t k) const {
    return std::abs(all.v[k]) <= rounded_input * velocity_;
  }
  [[nodiscard]] bool is_short(const Columns& all, std::size_t i) const {
    return i + 1 < all.x.size() && length(all, i) < short_;
  }

  /// Settles the knots between two that stay.
  void settle_between(Columns& all, std::size_t from, std::size_t to) const {
    std::size_t longest = from;
    for (std::size_t i = from; i < to; ++i)
      if (length(all, i) > length(all, longest)) longest = i;
    for (std::size_t i = from; i < longest; ++i)
      if (length(all, i) < noisy_) settle(all, i, i + 1);
    for (std::size_t i = to - 1; i > longest; --i)
      if (length(all, i) < noisy_) settle(all, i, i);
    spread(all, from, to, longest);
  }

  /// Spreads the error of the rise in the longest interval over all intervals in which the spacing of
  /// the doubles is not visible. A position moves by a multiple of this spacing, so the differences
  /// in the other intervals stay as they are.
  void spread(Columns& all, std::size_t from, std::size_t to, std::size_t longest) const {
    const auto off = [&](std::size_t k, Side side) { return all.p[k] - f_.jet(all.x[k], side)[0]; };
    const double error = off(longest + 1, Side::left) - off(longest, Side::right);
    if (!(jerk_change(error, length(all, longest)) > settled_noise * jerk_)) return;
    double farthest = 0;
    for (std::size_t i = from; i <= to; ++i) farthest = std::max(farthest, std::abs(all.p[i]));
    const double spacing = std::nextafter(farthest, profiles_detail::inf) - farthest;
    const auto share = [&](std::size_t i) {
      const double d = length(all, i);
      return jerk_change(spacing, d) > settled_noise * jerk_
                 ? 0
                 : profiles_detail::cube(d / length(all, longest));
    };
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += share(i);
    if (!(sum > 1)) return;
    double before = 0;
    for (std::size_t k = from + 1; k < to; ++k) {
      before += share(k - 1);
      const double part = before / sum - (k > longest ? 1 : 0);
      all.p[k] += spacing * std::round(error * part / spacing);
    }
  }

  /// Settles interval i by its knot `moved`.
  void settle(Columns& all, std::size_t i, std::size_t moved) const {
    const bool forward = moved > i;
    const std::size_t other = forward ? i : i + 1;
    CurveRise<Over> rise_between(f_);
    const auto at = [&](double x) {
      const double wanted =
          forward ? rise_between(all.x[other], x) : -rise_between(x, all.x[other]);
      const double position = all.p[other] + wanted;
      return Place{x, position, position - all.p[other] - wanted};
    };
    const Place place = best(all.x[moved], all.x[forward ? i + 2 : i - 1], length(all, i), at);
    const Jet jet = f_.jet(place.x, Side::right);
    all.x[moved] = place.x;
    all.p[moved] = place.position;
    all.v[moved] = jet[1];
    if (!all.a.empty()) all.a[moved] = jet[2];
    if (!is_short(all, i) || i == 0 || i + 2 == all.x.size() || is_short(all, i - 1) ||
        is_short(all, i + 1))
      return;
    const double more = (forward ? place.error : -place.error) / length(all, i);
    all.v[i] += more;
    all.v[i + 1] += more;
  }

  /// The greatest change of the jerk by an error of the rise over the length d, with its own rounding.
  static double jerk_change(double error, double d) {
    return 120 * std::abs(error) / profiles_detail::cube(d);
  }

  /// The place among the doubles from x towards `limit` with the least change of the jerk, or the
  /// first one with an invisible change. An error e of the rise over the length d changes the jerk
  /// by up to 120 e / d^3. Beside a step of the jerk, a moved knot changes it by up to twice the
  /// greatest jerk times the share of d by which the knot moves.
  template <class At>
  Place best(double x, double limit, double d, At at) const {
    const auto change = [&](double error) { return jerk_change(error, d); };
    const double from = x;
    Place found = at(x);
    double least = change(found.error);
    constexpr int most = 1 << 16;
    for (int i = 0; i < most && least > rounded_sum * jerk_; ++i) {
      x = std::nextafter(x, limit);
      const double moved = 2 * jerk_ * std::abs(x - from) / d;
      if (x == limit || moved >= least) break;
      const Place here = at(x);
      if (change(here.error) + moved >= least) continue;
      found = here;
      least = change(here.error) + moved;
    }
    return found;
  }

  const Curve<Over>& f_;
  Interpolation rule_;
  double short_;     ///< the rounding in a shorter interval is visible
  double noisy_;     ///< a shorter interval must settle
  double velocity_;  ///< the greatest of the curve
  double jerk_;      ///< the greatest of the curve
};

}  // namespace

template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, const std::vector<double>& knots) {
  if (knots.size() < 2)
    throw InputError("knots", std::to_string(knots.size()), "must be at least 2");
  if (knots.front() != f.start() || knots.back() != f.end())
    throw InputError("knots", number(knots.front()) + " to " + number(knots.back()),
                     "must span the curve, " + number(f.start()) + " to " + number(f.end()));
  return certified(f, rule, columns_at(f, rule, knots));
}

template <class Over>
Sampled certified(const Curve<Over>& f, Interpolation rule, Columns columns) {
  if (f.outside() == Extrapolation::wrap) close_period(columns.p);
  if (repeats(f.outside()))
    for (auto* column : {&columns.v, &columns.a}) close_period(*column);
  constexpr Domain axis = std::is_same_v<Over, OverTime> ? Domain::time : Domain::master;
  Table table(axis, rule, f.outside(), std::move(columns));
  const SampleError error = error_of(f, table);
  return {std::move(table), error, {}};
}

const char* name(Binding binding) {
  switch (binding) {
    case Binding::none:
      return "none";
    case Binding::tolerance:
      return "tolerance";
    case Binding::velocity_tolerance:
      return "velocity_tolerance";
    case Binding::most:
      break;
  }
  return "most";
}

template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, std::size_t intervals) {
  if (intervals < 1) throw InputError("intervals", 0.0, "must be at least 1");
  auto knots = equal_parts(f.start(), f.end(), intervals);
  knots.push_back(f.end());
  return sample(f, rule, knots);
}

template <class Over>
void require_certifiable(const Curve<Over>& f, const char* key, double tolerance) {
  double largest = 0;
  for (const Segment& segment : f.segments()) largest = std::max(largest, magnitude(segment));
  const double least =
      std::max(rounded_value * std::abs(extrema(f, 0).peak().value), rounded_digit * largest);
  if (tolerance < least)
    throw InputError(
        key, tolerance,
        "must be at least " + six_digits_up(least) + ": rounding hides smaller errors");
}

template <class Over>
Sampled sample_within(const Curve<Over>& f, Interpolation rule, double tolerance,
                      const Limits& limits, std::size_t most, const RampedLimits& ramped) {
  require_positive("tolerance", tolerance);
  // A tolerance below the rounding of the values cannot be kept.
  const double wanted = std::max(tolerance, two_roundings * std::abs(extrema(f, 0).peak().value));
  std::vector<double> knots;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    const Curve<Over> piece({f.segments()[i]});  // from 0: far from 0, short pieces have few digits
    const auto fits = [&](std::size_t n) {
      return sample(piece, rule, n).error.position <= wanted;
    };
    std::size_t enough = 1;
    while (!fits(enough)) {
      enough *= 2;
      if (knots.size() + enough > most)
        throw InputError("tolerance", tolerance,
                         "needs more than " + std::to_string(most) + " knots with a " + name(rule) +
                             " table: give a greater tolerance");
    }
    std::size_t too_few = enough / 2;
    while (enough - too_few > 1) {
      const std::size_t middle = (enough + too_few) / 2;
      (fits(middle) ? enough : too_few) = middle;
    }
    const auto inner = equal_parts(f.breaks()[i], f.breaks()[i + 1], enough);
    knots.insert(knots.end(), inner.begin(), inner.end());
  }
  knots.push_back(f.end());
  knots = shortened_before_steps(f, rule, wanted, knots);
  knots = Spread<Over>(f, rule, wanted).run(std::move(knots));
  const ShortIntervals<Over> with(f, rule);
  Sampled sampled = certified(f, rule, with.columns(knots));
  if (ramped.ramp > 0 || !check(sampled.table, limits).ok()) {
    knots = within_limits(f, rule, limits, ramped, knots);
    sampled = certified(f, rule, with.columns(knots));
  }
  // An interval that kept the tolerance because of its symmetry may exceed it when it is shorter.
  for (int i = 0; i < 20 && sampled.error.position > wanted; ++i) {
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, sampled.error.where);
    knots.insert(above, (*(above - 1) + *above) / 2);
    sampled = certified(f, rule, with.columns(knots));
  }
  return sampled;
}

#define JOUNCE_INSTANTIATE(Over)                                                           \
  template Sampled sample(const Curve<Over>&, Interpolation, const std::vector<double>&);  \
  template Sampled sample(const Curve<Over>&, Interpolation, std::size_t);                 \
  template Sampled certified(const Curve<Over>&, Interpolation, Columns);                  \
  template void require_certifiable(const Curve<Over>&, const char*, double);              \
  template Sampled sample_within(const Curve<Over>&, Interpolation, double, const Limits&, \
                                 std::size_t, const RampedLimits&);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce

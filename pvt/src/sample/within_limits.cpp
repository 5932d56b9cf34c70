// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/within_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"

#include "pvt/src/sample/interval.hpp"
#include "pvt/src/sample/knot_rounding.hpp"
#include "pvt/src/sample/longest.hpp"

// Between its knots, a table differs from the curve. So it may exceed a limit that the curve just keeps. On an interval
// of length h, its k-th derivative differs by
//
//   (1)  C h^(n - k) M,     n = 4 (cubic), 6 (quintic), M the greatest n-th derivative of the curve
//
// so halves of the interval exceed the limit by less, if at all. Where the curve has a peak below its limit, it falls
// with the square of the distance from the peak. So only the few intervals next to the peak must be halved.
//
// If a break of the curve is inside an interval, the interval is divided there, because both parts then have the
// derivatives of one segment.
//
// Halves do not help where a derivative of the curve steps that the table cannot step in: there, a shorter interval
// has a greater third derivative. Such an interval stays as it is. The rounding e of a position changes the k-th
// derivative by c e / h^k; the rounding d of a place has the effect of v d of the position. No interval is so short
// that this is more than a thousandth of a limit.
//
// A slave over time, whose master runs and accelerates, limits sums of two derivatives (RampedLimits).
namespace jounce::pvt_detail {
namespace {

constexpr double rounding_share = 1e-3;
constexpr double limit_rounding = 1e-12;  ///< share of a limit that counts as rounding

template <class Over>
class WithinLimits {
 public:
  WithinLimits(const Curve<Over>& f, Interpolation rule, const Limits& limits,
               const RampedLimits& ramped, double spacing)
      : f_(f), rule_(rule), spacing_(spacing), rounding_(knot_rounding(f)) {
    const Ranges taken = extrema(f);
    const std::array rates{limits.velocity, limits.acceleration, limits.jerk};
    permit({0}, limits.position_min, limits.position_max, taken[0]);
    for (std::size_t k = 0; k < rates.size(); ++k)
      permit_rate({static_cast<int>(k) + 1}, rates[k], taken[k + 1]);
    if (ramped.ramp == 0) return;
    for (const double ramp : {ramped.ramp, -ramped.ramp})
      for (const auto& [quantity, limit] :
           {std::pair{Quantity{2, ramp}, ramped.limits.acceleration},
            std::pair{Quantity{3, 3 * ramp}, ramped.limits.jerk}})
        if (limit) permit_rate(quantity, limit, range_on_curve(quantity));
  }

  [[nodiscard]] std::vector<Knot> run(const std::vector<Knot>& knots) const {
    std::vector<Knot> all{knots.front()};
    for (std::size_t i = 1; i < knots.size(); ++i) {
      halve(knots[i - 1], knots[i], all);
      all.push_back(knots[i]);
    }
    return all;
  }

 private:
  /// A derivative, and `lower` times the one below it.
  struct Quantity {
    int order = 0;
    double lower = 0;
  };

  /// Values of a quantity that the table may take: up to the limit, or up to the curve's own where it exceeds it.
  struct Permitted {
    Quantity quantity;
    double least = -profiles_detail::inf;
    double most = profiles_detail::inf;
    double scale = 0;  ///< the greatest magnitude
  };

  void permit(const Quantity& quantity, std::optional<double> least, std::optional<double> most,
              const Range& taken) {
    if (!least && !most) return;
    Permitted p{quantity};
    if (least) p.least = std::min(*least, taken.min.value);
    if (most) p.most = std::max(*most, taken.max.value);
    p.scale = std::max(
        {least ? std::abs(p.least) : 0, most ? std::abs(p.most) : 0, std::abs(taken.peak().value)});
    permitted_.push_back(p);
  }
  void permit_rate(const Quantity& quantity, std::optional<double> limit, const Range& taken) {
    permit(quantity, limit ? std::optional(-*limit) : std::nullopt, limit, taken);
  }

  static Range range_of(const Segment& f, double start, double end, const Quantity& quantity) {
    if (quantity.lower == 0) return segment_range(f, start, end, quantity.order);
    Segment below = f;
    for (int k = 1; k < quantity.order; ++k) below = derivative(below);
    // Always fits: a derivative has the sines of its function.
    return segment_range(*sum(derivative(below), scaled(below, quantity.lower)), start, end, 0);
  }

  [[nodiscard]] Range range_on_curve(const Quantity& quantity) const {
    const auto of_segment = [&](std::size_t i) {
      return range_of(f_.segments()[i], f_.breaks()[i], f_.breaks()[i + 1], quantity);
    };
    Range all = of_segment(0);
    for (std::size_t i = 1; i < f_.segments().size(); ++i) {
      const Range next = of_segment(i);
      if (next.min.value < all.min.value) all.min = next.min;
      if (next.max.value > all.max.value) all.max = next.max;
    }
    return all;
  }

  /// The change of a quantity in an interval by the rounding of its knots.
  [[nodiscard]] double rounding(const Quantity& quantity, double length) const {
    constexpr std::array factors{2.0, 4.0, 12.0, 120.0};
    const auto of_order = [&](int k) {
      return factors[static_cast<std::size_t>(k)] * rounding_ / std::pow(length, k);
    };
    const double lower = quantity.lower == 0 ? 0 : of_order(quantity.order - 1);
    return of_order(quantity.order) + std::abs(quantity.lower) * lower;
  }

  [[nodiscard]] bool is_too_short(double length) const {
    return length < spacing_ ||
           std::any_of(permitted_.begin(), permitted_.end(), [&](const Permitted& p) {
             return p.scale > 0 && rounding(p.quantity, length) > rounding_share * p.scale;
           });
  }

  /// The greatest share of a limit by which the interval exceeds it, beyond the rounding of its knots; 0: none.
  [[nodiscard]] double excess(const Knot& a, const Knot& b) const {
    const Segment table = between(rule_, a, b);
    double worst = 0;
    for (const Permitted& p : permitted_) {
      if (p.scale == 0) continue;
      const Range range = range_of(table, a.x, b.x, p.quantity);
      const double over = std::max(range.max.value - p.most, p.least - range.min.value);
      const double beyond = over - rounding(p.quantity, b.x - a.x) - limit_rounding * p.scale;
      worst = std::max(worst, beyond / p.scale);
    }
    return worst;
  }

  /// The place at which to divide an interval: the break of the curve nearest to its middle, because
  /// no interval with a break inside has the derivatives of the curve; without breaks, the middle.
  [[nodiscard]] double split(double a, double b) const {
    const double middle = a + (b - a) / 2;
    const auto breaks = f_.breaks();
    const auto first = std::upper_bound(breaks.begin(), breaks.end(), a);
    const auto last = std::lower_bound(first, breaks.end(), b);
    if (first == last) return middle;
    const auto above = std::lower_bound(first, last, middle);
    if (above == first) return *above;
    if (above == last || middle - *(above - 1) < *above - middle) return *(above - 1);
    return *above;
  }

  /// Appends the knots between a and b with which the table exceeds the limits least; returns the rest of the excess.
  double halve(const Knot& a, const Knot& b, std::vector<Knot>& knots) const {
    const double whole = excess(a, b);
    if (whole == 0) return whole;
    const Knot middle = knot_at(f_, split(a.x, b.x), Side::right);
    if (is_too_short(std::min(middle.x - a.x, b.x - middle.x))) return whole;
    const std::size_t before = knots.size();
    const double left = halve(a, middle, knots);
    knots.push_back(middle);
    const double halves = std::max(left, halve(middle, b, knots));
    if (halves < whole) return halves;
    knots.resize(before);
    return whole;
  }

  const Curve<Over>& f_;
  Interpolation rule_;
  double spacing_;
  double rounding_;  ///< greatest error of the position of a knot
  std::vector<Permitted> permitted_;
};

}  // namespace

template <class Over>
std::vector<Knot> knots_within_limits(const Curve<Over>& f, Interpolation rule,
                                      const Limits& limits, const RampedLimits& ramped,
                                      const std::vector<Knot>& knots, double spacing) {
  return WithinLimits<Over>(f, rule, limits, ramped, spacing).run(knots);
}

template std::vector<Knot> knots_within_limits(const Curve<OverTime>&, Interpolation, const Limits&,
                                               const RampedLimits&, const std::vector<Knot>&,
                                               double);
template std::vector<Knot> knots_within_limits(const Curve<OverMaster>&, Interpolation,
                                               const Limits&, const RampedLimits&,
                                               const std::vector<Knot>&, double);

}  // namespace jounce::pvt_detail

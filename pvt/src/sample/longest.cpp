// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/longest.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "jounce/profiles/detail/numeric.hpp"

#include "pvt/src/sample/halves.hpp"
#include "pvt/src/sample/whole_steps.hpp"

// The error of an interval of length h is proportional to h^k (Hermite interpolation: k = 2, 4, 6;
// two quadratic pieces: 3). So after a length that uses the share e of the tolerance, the next
// length to try is
//
//   (1)  h (0.99995 / e)^(1/k)
//
// and few lengths are tried. If the curve is less smooth, bisection is used instead. The search
// ends when the share is within 1e-4 of 1, or the length is exact to 1e-6.
//
// Rounded knots: if d is the distance of a rounded position from the curve, the error of the
// interval is at most the unrounded error plus d, and at least the unrounded error minus d. So no
// interval is longer than
//
//   (2)  the longest that keeps, unrounded, the tolerance plus p_step / 2
//
// and the knots within this length are tried from its end downwards.
//
// No interval crosses the next required knot, the limit. Before a dwell or a straight line that the
// curve enters with a step of a derivative, the last interval must be short:
//
//   (3)  an interval that ends just before the limit ends where the limit can be reached from.
namespace jounce::pvt_detail {

int order(const Target& target) {
  if (target.quadratic) return 3;
  return target.rule == Interpolation::linear          ? 2
         : target.rule == Interpolation::cubic_hermite ? 4
                                                       : 6;
}

template <class Over>
Knot knot_at(const Curve<Over>& f, double x, Side side) {
  const double within = std::clamp(x, f.start(), f.end());
  if (within == f.start()) side = Side::right;
  if (within == f.end()) side = Side::left;
  return {x, side, f.jet(within, side)};
}

template <class Over>
Knot held_at(const Curve<Over>& f, const Target& target, double x, Side side) {
  Knot knot = knot_at(f, x, side);
  knot.jet[0] = rounded_to(knot.jet[0], target.p_step);
  // A period ends at the rounded position of its first knot, plus the travel.
  if (target.p_step > 0 && repeats(f.outside()) && x == f.end()) {
    const double first = f.jet(f.start())[0];
    const double travel = f.jet(x, Side::left)[0] - first;
    if (is_whole(travel, target.p_step))
      knot.jet[0] = rounded_to(rounded_to(first, target.p_step) + travel, target.p_step);
  }
  knot.jet[1] = rounded_to(knot.jet[1], target.v_step);
  return knot;
}

namespace {

template <class Over>
class Search {
 public:
  /// Knots may be anywhere; the caller observes the target's steps and spacing.
  Search(const Curve<Over>& f, const Target& target, const Knot& a, const Knot& limit,
         const Tolerances& tolerances)
      : f_(f),
        target_{.rule = target.rule, .quadratic = target.quadratic},
        a_(a),
        limit_(limit),
        tolerances_(tolerances) {}

  std::optional<Knot> run(double guess) {
    double h = guess;
    for (int i = 0; i < 200 && h > 1e-13 * (std::abs(a_.x) + f_.length()); ++i) {
      const double x = a_.x + h < limit_.x ? a_.x + h : limit_.x;
      const double e = tried(x);
      if (x == limit_.x && e <= 1) return best_;
      if (e >= 1 - 1e-4 && e <= 1) break;
      if (hi_ < profiles_detail::inf && hi_ - lo() <= 1e-6 * (hi_ - a_.x)) break;
      h = next(x - a_.x, e, i);
    }
    return at_break();
  }

 private:
  [[nodiscard]] double lo() const { return best_ ? best_->x : a_.x; }

  /// The share of the tolerances up to x. x becomes the new end of the bracket on its side of a
  /// share of 1.
  double tried(double x) {
    const Knot b = knot_at(f_, x, x == limit_.x ? limit_.side : Side::right);
    const double e = share(f_, target_, a_, b, tolerances_);
    if (e <= 1)
      best_ = b;
    else
      hi_ = x;
    return e;
  }

  /// The next length by (1), within the bracket.
  [[nodiscard]] double next(double h, double e, int i) const {
    const double factor = std::pow(0.99995 / std::max(e, 1e-30), 1.0 / order(target_));
    if (hi_ == profiles_detail::inf) return h * std::clamp(factor, 1.01, 8.0);
    const double from = lo() - a_.x;
    const double to = hi_ - a_.x;
    const double length = h * factor;
    const bool inside = length > from + 1e-3 * (to - from) && length < to - 1e-3 * (to - from);
    if (inside && i % 3 != 2) return length;
    return from + (to - from) / (from > 0 ? 2 : 8);
  }

  /// A break of the curve is a better knot. At a break within the bracket a derivative of the curve
  /// steps, and the interval ends with the limits from the left. A break just after the bracket is
  /// as good, and spares the next interval the rest of that segment.
  std::optional<Knot> at_break() {
    const auto breaks = f_.breaks();
    const double last = hi_ == profiles_detail::inf ? lo() : hi_;
    const auto above = std::upper_bound(breaks.begin(), breaks.end(), last);
    if (above == breaks.begin()) return best_;
    const double x = *(above - 1);
    const bool near = x > lo() || lo() - x <= 1e-3 * (lo() - a_.x);
    if (!near || x <= a_.x || x == lo() || x == limit_.x) return best_;
    for (const Side side : {Side::right, Side::left}) {
      const Knot b = knot_at(f_, x, side);
      if (share(f_, target_, a_, b, tolerances_) <= 1) return b;
    }
    return best_;
  }

  const Curve<Over>& f_;
  Target target_;
  const Knot& a_;
  const Knot& limit_;
  const Tolerances& tolerances_;
  double hi_ = profiles_detail::inf;  ///< the least position that is known to be too far
  std::optional<Knot> best_;
};

/// True if the curve differs on the left and on the right of x.
template <class Over>
bool steps_at(const Curve<Over>& f, double x) {
  if (!std::binary_search(f.breaks().begin() + 1, f.breaks().end() - 1, x)) return false;
  const Jet left = f.jet(x, Side::left);
  return !std::equal(left.begin(), left.begin() + 3, f.jet(x, Side::right).begin());
}

/// True if a knot at x is permitted after one at a: checks the spacing to a and to the limit.
bool may_be(const Target& target, double a, double x, double limit) {
  const double least = target.spacing * (1 - 1e-12);
  return x > a && x - a >= least && (x == limit || limit - x >= least);
}

/// Permitted positions of the next knot: `reach` and positions before it, the farthest first; at
/// most some thousands.
std::vector<double> places(const Target& target, double a, double reach, double limit) {
  constexpr double many = 4096;
  std::vector<double> all;
  if (target.x_step > 0) {
    const double last = std::floor(reach / target.x_step * (1 + 4e-16) + 1e-9);
    const double first = std::round(a / target.x_step) + 1;
    const double stride = std::max(1.0, std::floor((last - first) / many));
    for (double k = last; k >= first; k -= stride) {
      const double x = steps(k, target.x_step);
      all.push_back(limit - x <= 1e-6 * target.x_step ? limit : x);
    }
  } else if (target.p_step > 0 || target.v_step > 0) {
    for (double i = 0; i < 512; ++i) all.push_back(reach - (reach - a) * i / 512);
  } else {
    all = {reach, std::min(reach, limit - target.spacing)};
  }
  std::erase_if(all, [&](double x) { return !may_be(target, a, x, limit); });
  return all;
}

/// The first stretch that ends after x; null if there is none.
const Straight* stretch_behind(const std::vector<Straight>& stretches, double x) {
  const auto at =
      std::upper_bound(stretches.begin(), stretches.end(), x,
                       [](double place, const Straight& each) { return place < each.end.x; });
  return at == stretches.end() ? nullptr : &*at;
}

/// The required knot that the intervals from x on must not pass.
template <class Over>
Knot limit_behind(const Curve<Over>& f, const Target& target, const Straight* stretch, double x) {
  if (stretch == nullptr) return held_at(f, target, f.end(), Side::left);
  return x < stretch->begin.x ? stretch->begin : stretch->end;
}

template <class Over>
class Followers {
 public:
  Followers(const Curve<Over>& f, const Target& target, const Knot& a, const Tolerances& tolerances,
            const Straight* stretch)
      : f_(f),
        target_(target),
        a_(a),
        limit_(limit_behind(f, target, stretch, a.x)),
        is_line_(stretch != nullptr && a.x >= stretch->begin.x),
        tolerances_(tolerances) {}

  std::vector<Knot> run(double guess) {
    if (is_line_ && share(f_, target_, a_, limit_, tolerances_) <= 1) return {limit_};
    const bool rounds = target_.p_step > 0 || target_.v_step > 0;
    const bool anywhere = !rounds && target_.x_step == 0 && target_.spacing == 0;
    const Knot from = rounds ? knot_at(f_, a_.x, a_.side) : a_;
    const Tolerances wide{tolerances_.position + target_.p_step / 2, tolerances_.velocity};  // (2)
    const auto reach = Search<Over>(f_, target_, from, limit_, wide).run(guess);
    if (!reach) return {};
    const double last = from_where_the_limit_is_reached(reach->x);
    if (!anywhere || last < reach->x) add_first_of(places(target_, a_.x, last, limit_.x));
    if (anywhere && all_.empty()) all_ = {reach->x == limit_.x ? limit_ : *reach};
    if (!all_.empty()) add_breaks_near(all_.front().x);
    return std::move(all_);
  }

 private:
  /// Applies (3): returns `reach`, or a lower position.
  [[nodiscard]] double from_where_the_limit_is_reached(double reach) const {
    const double whole = limit_.x - a_.x;
    if (reach == limit_.x || limit_.x - reach > 1e-3 * whole) return reach;
    for (double h = whole / 2; h > limit_.x - reach; h /= 2) {
      const Knot from = knot_at(f_, limit_.x - h, Side::right);
      if (share(f_, target_, from, limit_, tolerances_) <= 1) return from.x;
    }
    return reach;
  }

  /// The knot at x with the curve's numbers on the right or on the left, if it keeps the
  /// tolerances.
  std::optional<Knot> keeping(double x) {
    if (x == limit_.x)
      return share(f_, target_, a_, limit_, tolerances_) <= 1 ? std::optional(limit_)
                                                              : std::nullopt;
    for (const Side side : {Side::right, Side::left}) {
      if (side == Side::left && !steps_at(f_, x)) continue;
      const Knot b = held_at(f_, target_, x, side);
      if (share(f_, target_, a_, b, tolerances_) <= 1) return b;
    }
    return std::nullopt;
  }

  void add_first_of(const std::vector<double>& candidates) {
    for (const double x : candidates)
      if (const auto b = keeping(x)) return all_.push_back(*b);
  }

  /// Adds the last break before the farthest knot, and the first one after it.
  void add_breaks_near(double x) {
    const auto breaks = f_.breaks();
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), x);
    const auto before = std::lower_bound(breaks.begin(), next, x);
    if (next != breaks.end()) add_break(*next);
    if (before != breaks.begin()) add_break(*(before - 1));
  }

  void add_break(double x) {
    if (x > limit_.x || !may_be(target_, a_.x, x, limit_.x) ||
        (target_.x_step > 0 && !is_whole(x, target_.x_step)))
      return;
    if (const auto b = keeping(x)) all_.insert(x > all_.front().x ? all_.begin() : all_.end(), *b);
  }

  const Curve<Over>& f_;
  const Target& target_;
  const Knot& a_;
  Knot limit_;
  bool is_line_;  ///< true: the curve is a straight line up to the limit
  const Tolerances& tolerances_;
  std::vector<Knot> all_;
};

}  // namespace

template <class Over>
std::vector<Knot> followers(const Curve<Over>& f, const Target& target, const Knot& a,
                            const Tolerances& tolerances, const std::vector<Straight>& stretches,
                            double guess) {
  const Straight* stretch = stretch_behind(stretches, a.x);
  return Followers<Over>(f, target, a, tolerances, stretch).run(guess);
}

#define JOUNCE_INSTANTIATE(Over)                                                       \
  template Knot knot_at(const Curve<Over>&, double, Side);                             \
  template Knot held_at(const Curve<Over>&, const Target&, double, Side);              \
  template std::vector<Knot> followers(const Curve<Over>&, const Target&, const Knot&, \
                                       const Tolerances&, const std::vector<Straight>&, double);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce::pvt_detail

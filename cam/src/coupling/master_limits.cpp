// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/master_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/coupling/derivatives.hpp"

// Over all signs of the master's rates, the slave's greatest velocity, acceleration and jerk at a
// position z are, by (1) of the header,
//
//   (2)  |f'| w,   |f''| w^2 + |f'| a,   |f'''| w^3 + 3 |f''| w a + |f'| j
//
// Each is a sum of three terms, factor * x^power * |f^(k)|, in the unknown x (w or a). It increases
// with x and is convex in x. The result is the greatest x with
//
//   (3)  D(x) = max over z of the sum <= limit
//
// For a given x, D is exact: for a choice of signs of the three terms, the sum is a linear
// combination of f', f'', f'''. This is a segment again, whose extrema are isolated. If x is too
// large and z is its worst position,
//
//   (4)  x <- the x at which the sum at z is the limit
//
// is smaller than this x but never below the result, because (3) must hold at z as well. This is
// Dinkelbach's iteration: it converges faster than linearly, usually in three to six steps.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;
constexpr int most_steps = 100;

using Sizes = std::array<double, 3>;  // values for |f'|, |f''|, |f'''|, or their weights

struct MasterPlace {
  double where = 0;
  Sizes size{};
  double sum = -1;
};

/// A limit of the slave and its sum (2); the weight of term k is factor[k] * x^power[k].
struct Constraint {
  const char* quantity;
  double limit;
  Sizes factor;
  std::array<int, 3> power;

  [[nodiscard]] Sizes weights(double x) const {
    Sizes w{};
    for (std::size_t k = 0; k < w.size(); ++k) w[k] = factor[k] * std::pow(x, power[k]);
    return w;
  }
};

double weighted(const Sizes& weights, const Sizes& sizes) {
  return weights[0] * sizes[0] + weights[1] * sizes[1] + weights[2] * sizes[2];
}

/// A cam's derivatives, and the position of the greatest weighted sum of their magnitudes.
class Transfers {
 public:
  explicit Transfers(const Cam& cam) : cam_(cam) {
    for (std::size_t i = 0; i < cam.segments().size(); ++i) {
      segments_.emplace_back(cam.segments()[i]);
      const Ranges ranges = segment_extrema(cam, i);
      Sizes& peak = peaks_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        peak[k] = std::abs(ranges[k + 1].peak().value);
        most_[k] = std::max(most_[k], peak[k]);
      }
    }
  }

  /// The greatest magnitude of each derivative.
  [[nodiscard]] const Sizes& most() const { return most_; }

  [[nodiscard]] MasterPlace worst(const Sizes& weights) const {
    MasterPlace worst;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (weighted(weights, peaks_[i]) > worst.sum) search(i, weights, worst);
    return worst;
  }

 private:
  void search(std::size_t i, const Sizes& weights, MasterPlace& worst) const {
    for (const double s2 : {1.0, -1.0}) {
      if (s2 < 0 && weights[1] == 0) continue;
      for (const double s3 : {1.0, -1.0}) {
        if (s3 < 0 && weights[2] == 0) continue;
        const Segment combined =
            segments_[i].weighted({weights[0], s2 * weights[1], s3 * weights[2]});
        const Range range = extrema(Cam({combined}), 0);
        take(i, range.min.where, weights, worst);
        take(i, range.max.where, weights, worst);
      }
    }
  }

  void take(std::size_t i, double u, const Sizes& weights, MasterPlace& worst) const {
    const Segment& slope = segments_[i].first;
    const Jet jet = evaluate(slope, std::min(1.0, u / slope.length));
    const Sizes size{std::abs(jet[0]), std::abs(jet[1]), std::abs(jet[2])};
    const double sum = weighted(weights, size);
    if (sum > worst.sum) worst = {cam_.breaks()[i] + u, size, sum};
  }

  const Cam& cam_;
  std::vector<cam_detail::Derivatives> segments_;
  std::vector<Sizes> peaks_;
  Sizes most_{};
};

/// An upper bound of x: each term alone must keep the limit at its greatest value.
double upper_bound(const Constraint& c, const Sizes& most) {
  double x = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < most.size(); ++k)
    if (const double slope = c.factor[k] * most[k]; c.power[k] > 0 && slope > 0)
      x = std::min(x, std::pow(c.limit / slope, 1.0 / c.power[k]));
  return x;
}

/// Equation (4): Newton's method from above; for an increasing convex sum it never falls below the
/// result.
double at_limit(const Constraint& c, const Sizes& size, double x) {
  if (weighted(c.weights(0), size) >= c.limit) return 0;
  for (int i = 0; i < most_steps; ++i) {
    const double excess = weighted(c.weights(x), size) - c.limit;
    double slope = 0;
    for (std::size_t k = 0; k < size.size(); ++k)
      if (c.power[k] > 0) slope += c.power[k] * c.factor[k] * std::pow(x, c.power[k] - 1) * size[k];
    const double next = x - excess / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

MasterLimit greatest(const Transfers& f, const Constraint& c) {
  double x = upper_bound(c, f.most());
  const bool unlimited = std::isinf(x);
  if (unlimited) x = 0;  // no term depends on it
  for (int i = 0; i < most_steps; ++i) {
    const MasterPlace place = f.worst(c.weights(x));
    if (place.sum <= c.limit * (1 + rounded_value))
      return unlimited ? MasterLimit{} : MasterLimit{x, c.quantity, place.where};
    const double next = at_limit(c, place.size, x);
    if (!(next < x)) return {next, c.quantity, place.where};
    x = next;
  }
  return {x, c.quantity, f.worst(c.weights(x)).where};
}

/// A step of the nth derivative, so that the next one is infinite.
std::optional<Jump> step_of(const Cam& cam, int n, double peak) {
  const Jump jump = largest_jump(cam, n);
  if (std::abs(jump.step) <= rounded_input * peak) return std::nullopt;
  return jump;
}

/// Steps of the derivatives of a cam, and the limits that they set.
class Steps {
 public:
  /// `speed`: the speed of the master; nullopt if it is the result.
  Steps(const Cam& cam, const Transfers& f, double cycle, std::optional<double> speed)
      : cycle_(cycle), speed_(speed) {
    const Range travel = extrema(cam, 0);
    const std::array peaks{travel.max.value - travel.min.value, f.most()[0], f.most()[1]};
    for (std::size_t k = 0; k < steps_.size(); ++k)
      steps_[k] = step_of(cam, static_cast<int>(k), peaks[k]);
  }

  /// The limit that a step sets to a quantity; `limits_acceleration`: the acceleration is limited.
  [[nodiscard]] MasterLimit limit(const Constraint& c, bool limits_acceleration) const {
    const std::string quantity = c.quantity;
    if (steps_[0]) return {0, quantity, steps_[0]->where, true};
    if (steps_[1] && quantity == "acceleration") return within_a_cycle(c, 1);
    if (steps_[1] && quantity == "jerk" && !(cycle_ > 0 && limits_acceleration))
      return {0, quantity, steps_[1]->where, true};
    if (steps_[2] && quantity == "jerk") return within_a_cycle(c, 2);
    return {};
  }

 private:
  /// Equation (3) of master_limits.hpp.
  [[nodiscard]] MasterLimit within_a_cycle(const Constraint& c, std::size_t order) const {
    const double most = c.limit * cycle_ / std::abs(steps_[order]->step);
    const double speed = order == 1 ? most : std::sqrt(most);
    if (!speed_) return {speed, c.quantity, steps_[order]->where, true};
    if (most > 0 && *speed_ <= speed * (1 + rounded_value)) return {};
    return {0, c.quantity, steps_[order]->where, true};
  }

  double cycle_;
  std::optional<double> speed_;
  std::array<std::optional<Jump>, 3> steps_;
};

/// `speed`: as for Steps.
MasterLimit least(const Cam& cam, const std::vector<Constraint>& constraints, double cycle,
                  std::optional<double> speed) {
  const Transfers f(cam);
  const Steps steps(cam, f, cycle, speed);
  const bool limits_acceleration =
      std::any_of(constraints.begin(), constraints.end(),
                  [](const Constraint& c) { return std::string(c.quantity) == "acceleration"; });
  MasterLimit least;
  for (const Constraint& c : constraints) {
    const MasterLimit step = steps.limit(c, limits_acceleration);
    if (step.value == 0) return step;
    for (const MasterLimit& one : {step, greatest(f, c)})
      if (one.value < least.value) least = one;
  }
  return least;
}

}  // namespace

MasterLimit greatest_master_velocity(const Cam& cam, const Limits& slave,
                                     const MasterRates& rates) {
  require_valid(slave);
  require_not_negative("acceleration", rates.acceleration);
  require_not_negative("jerk", rates.jerk);
  require_not_negative("cycle", rates.cycle);
  const double a = rates.acceleration;
  std::vector<Constraint> all;  // Equation (2), x = w
  if (slave.velocity) all.push_back({"velocity", *slave.velocity, {1, 0, 0}, {1, 0, 0}});
  if (slave.acceleration)
    all.push_back({"acceleration", *slave.acceleration, {a, 1, 0}, {0, 2, 0}});
  if (slave.jerk) all.push_back({"jerk", *slave.jerk, {rates.jerk, 3 * a, 1}, {0, 1, 3}});
  return least(cam, all, rates.cycle, std::nullopt);
}

MasterLimit greatest_master_acceleration(const Cam& cam, const Limits& slave, double velocity,
                                         double jerk, double cycle) {
  require_valid(slave);
  require_not_negative("velocity", velocity);
  require_not_negative("cycle", cycle);
  require_not_negative("jerk", jerk);
  const double w = velocity;
  std::vector<Constraint> all;  // Equation (2), x = a
  if (slave.velocity) all.push_back({"velocity", *slave.velocity, {w, 0, 0}, {0, 0, 0}});
  if (slave.acceleration)
    all.push_back({"acceleration", *slave.acceleration, {1, w * w, 0}, {1, 0, 0}});
  if (slave.jerk) all.push_back({"jerk", *slave.jerk, {jerk, 3 * w, w * w * w}, {0, 1, 0}});
  return least(cam, all, cycle, w);
}

}  // namespace jounce

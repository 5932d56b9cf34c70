// SPDX-License-Identifier: Apache-2.0
// The figures of a run from its exact solution. Peaks, zeros and excursions are enclosed
// (enclosure.cpp). Work and squared torque are integrals in closed form (ladder.cpp, (7) to (9)).
// For work with a changing sign of the power, torque and speed are polynomials over an interval
// between two zeros of the power, and so is their product:
//
//     (1)  integral of (sum a_i s^i) (sum b_k s^k) over [p, q] = sum of a_i b_k (q^(i+k+1) - p^(i+k+1)) / (i+k+1)

#include "validate/src/exact/exact_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"

#include "validate/src/drive/drive_system.hpp"
#include "validate/src/drive/heat.hpp"
#include "validate/src/drive/peak.hpp"
#include "validate/src/drive/swings.hpp"
#include "validate/src/exact/exact_steps.hpp"
#include "validate/src/linear/periodic.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;

constexpr double equal = 1e-12;  // relative difference of two peaks, or of a power to all work
constexpr double fades_below =
    1e-3;  // share of the fastest swing below which swings are not watched

/// The zeros of f - level within the segment, as shares of it, with both ends.
std::vector<double> parts(Segment f, double level) {
  f.c[0] -= level;
  std::vector<double> zeros;
  roots(f, 4 * std::numeric_limits<double>::epsilon() * magnitude(f), zeros);
  return zeros;
}

std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all{0};
  all.insert(all.end(), a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  all.push_back(1);
  std::sort(all.begin(), all.end());
  return all;
}

/// The integral of a b, two polynomials, between two places: (1).
double product_between(const Segment& a, const Segment& b, double p, double q) {
  double sum = 0;
  double from = p;
  double to = q;
  for (int n = 0; n <= a.degree + b.degree; ++n) {
    double c = 0;
    for (int i = std::max(0, n - b.degree); i <= std::min(n, a.degree); ++i)
      c += a.c[static_cast<std::size_t>(i)] * b.c[static_cast<std::size_t>(n - i)];
    sum += c * (to - from) / (n + 1);
    to *= q;
    from *= p;
  }
  return a.length * sum;
}

class Figures {
 public:
  Figures(const Trajectory& reference, const Drive& drive, const DriveOptions& options)
      : reference_(reference),
        drive_(drive),
        options_(options),
        unit_(drive.position_per_rev / (2 * std::numbers::pi)),
        system_(balanced(watched_drive(drive))),
        path_(system_, reference, reference.length(),
              path_start(system_, reference, drive, options.periodic)),
        way_(path_),
        heat_(drive.motor) {
    for (const Interval& sync : options.sync) {
      cuts_.push_back(sync.from);
      cuts_.push_back(sync.to);
    }
    std::sort(cuts_.begin(), cuts_.end());
  }

  std::optional<DriveResult> result() {
    const auto breaks = reference_.breaks();
    path_.begin();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (!follow(i, breaks[i], breaks[i + 1])) return std::nullopt;
      way_.leave();
    }
    found_.rms_torque = std::sqrt(std::max(0.0, squared_) / reference_.length());
    found_.end_following_error = -unit_ * last_(motor_row);
    rests_ = !options_.periodic;
    const double end = reference_.end();
    if (settle() > 0 && !follow(breaks.size() - 1, end, end + settle())) return std::nullopt;
    return finish();
  }

 private:
  [[nodiscard]] double settle() const { return options_.periodic ? 0 : options_.settle; }

  /// None where the torque exceeds its limit.
  bool follow(std::size_t i, double begin, double end) {
    way_.enter(i, begin);
    ++found_.integration.restarts;
    auto cut = std::upper_bound(cuts_.begin(), cuts_.end(), begin);
    for (double from = begin; from < end;) {
      const double to = cut == cuts_.end() ? end : std::min(end, *cut++);
      while (const Steps* steps = way_.next(to))
        if (!see(*steps, from, to)) return false;
      from = to;
    }
    return true;
  }

  bool see(const Steps& s, double from, double to) {
    found_.integration.steps += s.count();
    if (!within_limits(s)) return false;
    peak(s, torque_row, 1, found_.torque);
    peak(s, velocity_row, 1, found_.velocity);
    peak(s, motor_row, -unit_, found_.following_error);
    if (drive_.pendulum) peak(s, swing_row, unit_, found_.swing);
    for (const Interval& sync : options_.sync)
      if (from >= sync.from && to <= sync.to)
        peak(s, motor_row, -unit_, found_.sync_following_error);
    beyond(s);
    if (rests_) rest(s);
    for (Index i = 0; i < s.count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      squared_ += s.squared[at];
      raise(found_.i2t, heat_.after(s.length(i), s.squared[at]), s.begin(i + 1));
      power(s, i, s.work[at]);
    }
    last_ = s.y.col(s.count());
    return true;
  }

  /// (9) of drive_system.cpp.
  bool within_limits(const Steps& s) {
    const Motor& m = drive_.motor;
    peak(s, demand_row, 1, demand_);
    if (std::abs(demand_.value) > m.torque_limit) return false;
    const double slope = torque_slope(m);
    if (slope == 0) return true;
    peak(s, envelope_row, 1, envelope_);
    return std::abs(envelope_.value) <= slope * m.max_velocity;
  }

  void peak(const Steps& s, Index row, double factor, Peak& peak) {
    for (Index i = 0; i <= s.count(); ++i) raise(peak, factor * s.y(row, i), s.begin(i));
    const double size = std::abs(factor);
    const auto open = [&](const TrajectorySpan& part) {
      raise(peak, factor * part.begin(row), part.time);
      return size * (part.bounds(row).most - s.rounding(row)) > (1 + equal) * std::abs(peak.value);
    };
    const auto leaf = [&](const TrajectorySpan& part) {
      const Range range = segment_range(way_.enclosure().polynomial(part, row), part.time,
                                        part.time + part.length, 0);
      for (const Extremum& e : {range.min, range.max}) raise(peak, factor * e.value, e.where);
    };
    for (Index i = 0; i < s.count(); ++i)
      if (size * (s.bounds(i, row).most - s.rounding(row)) > (1 + equal) * std::abs(peak.value))
        way_.enclosure().search(
            s.span(i), open, [](const TrajectorySpan&) {}, leaf);
  }

  /// Calls `visit(from, to, outside)` for all parts, with whether |output| is over a limit there.
  template <class Visit>
  void excursions(const Steps& s, Index row, double limit, const Visit& visit) {
    const auto either = [&](const Magnitude& b) { return b.most > limit && !(b.least > limit); };
    const auto open = [&](const TrajectorySpan& part) { return either(part.bounds(row)); };
    const auto done = [&](const TrajectorySpan& part) {
      visit(part.time, part.time + part.length, part.bounds(row).least > limit);
    };
    const auto leaf = [&](const TrajectorySpan& part) {
      const Segment f = way_.enclosure().polynomial(part, row);
      const std::vector<double> ends = merged(parts(f, limit), parts(f, -limit));
      for (std::size_t k = 1; k < ends.size(); ++k)
        visit(part.time + ends[k - 1] * part.length, part.time + ends[k] * part.length,
              std::abs(value(f, (ends[k - 1] + ends[k]) / 2)) > limit);
    };
    for (Index i = 0; i < s.count(); ++i)
      if (const Magnitude b = s.bounds(i, row); either(b))
        way_.enclosure().search(s.span(i), open, done, leaf);
      else
        visit(s.begin(i), s.begin(i + 1), b.least > limit);
  }

  void beyond(const Steps& s) {
    if (!options_.limits.following_error) return;
    auto& found = found_.beyond_following_error;
    excursions(s, motor_row, *options_.limits.following_error / unit_,
               [&](double from, double to, bool outside) {
                 if (outside && !beyond_) found.push_back({from, from});
                 if (outside) found.back().to = to;
                 beyond_ = outside;
               });
  }

  void rest(const Steps& s) {
    peak(s, load_row, unit_, found_.residual);
    swings(s);
    if (!options_.limits.settling_band) return;
    excursions(s, load_row, *options_.limits.settling_band / unit_,
               [&](double from, double, bool outside) {
                 if (outside)
                   inside_.reset();
                 else if (!inside_)
                   inside_ = from - reference_.end();
               });
  }

  void swings(const Steps& s) {
    const auto open = [](const TrajectorySpan& part) {
      return part.bounds(load_velocity_row).least == 0;
    };
    const auto done = [&](const TrajectorySpan& part) { swings_.see(part.end(load_velocity_row)); };
    const auto leaf = [&](const TrajectorySpan& part) {
      swings_.see(part.begin(load_velocity_row));
      for (const double at : parts(way_.enclosure().polynomial(part, load_velocity_row), 0))
        swings_.zero(part.time + at * part.length);
      done(part);
    };
    for (Index i = 0; i < s.count() && !faded_; ++i) {
      const Magnitude b = s.bounds(i, load_velocity_row);
      faded_ = b.most <= std::max(fades_below * swings_.fastest(), s.rounding(load_velocity_row));
      if (!faded_) way_.enclosure().search(s.span(i), open, done, leaf);
    }
  }

  void add_work(double work) {
    (work > 0 ? found_.energy.driving : found_.energy.regenerated) += std::abs(work);
  }

  /// The work of step i, divided where the power changes its sign.
  void power(const Steps& s, Index i, double work) {
    const double all = found_.energy.driving + found_.energy.regenerated;
    const auto turns = [&](const Magnitude& torque, const Magnitude& speed, double length) {
      if (torque.least > 0 && speed.least > 0) return false;
      if (speed.most <= s.rounding(velocity_row)) return false;
      return torque.most * speed.most * length > equal * all;
    };
    const auto open = [&](const TrajectorySpan& part) {
      return turns(part.bounds(torque_row), part.bounds(velocity_row), part.length);
    };
    if (!turns(s.bounds(i, torque_row), s.bounds(i, velocity_row), s.length(i)))
      return add_work(work);
    const auto done = [&](const TrajectorySpan& part) {
      std::array product{ProductIntegral{torque_row, velocity_row, 0}};
      Eigen::VectorXd z = part.z;
      path_.ladder().advance(z, part.length, product);
      add_work(product[0].sum);
    };
    const auto leaf = [&](const TrajectorySpan& part) {
      const Segment torque = way_.enclosure().polynomial(part, torque_row);
      const Segment speed = way_.enclosure().polynomial(part, velocity_row);
      const std::vector<double> ends = merged(parts(torque, 0), parts(speed, 0));
      for (std::size_t k = 1; k < ends.size(); ++k)
        add_work(product_between(torque, speed, ends[k - 1], ends[k]));
    };
    way_.enclosure().search(s.span(i), open, done, leaf);
  }

  DriveResult finish() {
    found_.residual_frequency =
        swings_.frequency(options_.tolerance * std::abs(found_.velocity.value));
    if (rests_ && options_.limits.settling_band) found_.settling_time = inside_;
    found_.integration.reached = reference_.end() + settle();
    add_current(found_, drive_.motor, squared_);
    return std::move(found_);
  }

  const Trajectory& reference_;
  const Drive& drive_;
  const DriveOptions& options_;
  double unit_;  // u/rad
  LinearSystem system_;
  ExactPath path_;
  ExactSteps way_;
  Heat heat_;
  std::vector<double> cuts_ = {};
  DriveResult found_ = {};
  Peak demand_ = {};
  Peak envelope_ = {};
  Swings swings_ = {};
  Eigen::VectorXd last_ = {};  // outputs at the end of the last step
  double squared_ = 0;
  bool rests_ = false;
  bool beyond_ = false;
  bool faded_ = false;
  std::optional<double> inside_ = 0;
};

}  // namespace

std::optional<DriveResult> exact_figures(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options) {
  return Figures(reference, drive, options).result();
}

}  // namespace jounce::validate_detail

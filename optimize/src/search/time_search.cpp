// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/time_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <span>

#include "optimize/src/search/joint_spline.hpp"
#include "optimize/src/solvers/local_solver.hpp"

// If all intervals are multiplied by s, velocity, acceleration and jerk are multiplied by 1/s,
// 1/s^2 and 1/s^3. For any intervals, the shortest ones with the same ratios are therefore known:
//
//   (1)  s = max over joints and places of  |v| / V,  sqrt(|a| / A),  cbrt(|jerk| / J)
//
// Every quantity of (1) is a peak of a piece in closed form: |v| at the knots and between them
// where a = 0, |a| at the knots, and |jerk|, which is constant. The maximum is not smooth, but its
// epigraph is. In the logarithms y of the intervals h:
//
//   (2)  shortest           minimize log sum h  subject to  +- quantity / limit <= 1, each one
//   (3)  least_peak_jerk    the same with the jerk alone and limit 1: T^3 max |jerk| is minimized
//   (4)  least_square_jerk  minimize log(sum of the integrals) + 5 log sum h, without limits
//
// SLSQP gets gradients by the complex step (W. Squire and G. Trapp, SIAM Review 40, 1998): the
// imaginary part of f(h + i e) is e f'(h), without cancellation, and with e = 1e-100 it is exact.
// The result of the solver need not be feasible: (1) makes it feasible. The search starts again there,
// until that improves nothing.

namespace jounce::optimize_detail {
namespace {

using Complex = std::complex<double>;

constexpr double no_gain = 1e-13;  ///< share of the value
constexpr double step = 1e-100;
constexpr double farthest = 1e4;  ///< greatest ratio by which an interval changes in one run

struct Peak {
  std::size_t order;  ///< 1: velocity ...
  Complex value;
  double limit;
};

std::array<std::optional<double>, 4> limits_of(const SplineTimesSpec& spec, std::size_t joint) {
  if (spec.objective != TimeObjective::shortest)
    return {std::nullopt, std::nullopt, std::nullopt, 1.0};
  const Limits& l = spec.limits[joint];
  return {std::nullopt, l.velocity, l.acceleration, l.jerk};
}

/// The velocity where the acceleration is 0 within interval i, or at the end that is nearer to it.
Complex turning_velocity(const JointSpline<Complex>& s, std::size_t i) {
  const Complex a0 = s.acceleration[i], a1 = s.acceleration[i + 1];
  if (a0.real() * a1.real() < 0) return s.velocity[i] - a0 * a0 / (2.0 * s.jerk[i]);
  return s.velocity[std::abs(a0.real()) < std::abs(a1.real()) ? i : i + 1];
}

class TimeProblem {
 public:
  explicit TimeProblem(const SplineTimesSpec& spec) : spec_(spec), joints_(spec.points[0].size()) {
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const auto& point : spec.points) joints_[j].push_back(point[j]);
  }

  [[nodiscard]] std::size_t rows(std::size_t n) const {
    return 2 * peaks(std::vector<Complex>(n, 1.0)).size();
  }

  /// (1), from exact peaks.
  [[nodiscard]] double scale(const std::vector<double>& h) const {
    double s = 0;
    for (const Peak& peak : peaks({h.begin(), h.end()}))
      s = std::max(s, std::pow(std::abs(peak.value.real()) / peak.limit,
                               1 / static_cast<double>(peak.order)));
    return s;
  }

  [[nodiscard]] Complex square_jerk(const std::vector<Complex>& h) const {
    Complex sum = 0;
    for (const auto& joint : joints_) {
      const auto s = joint_spline<Complex>(joint, h);
      for (std::size_t i = 0; i < h.size(); ++i) sum += s.jerk[i] * s.jerk[i] * h[i];
    }
    return sum;
  }

  /// The rows of (2), with gradients by y.
  void constraints(std::span<const double> y, std::span<double> result,
                   std::span<double> gradient) const {
    const std::size_t n = y.size();
    for (std::size_t k = 0; k < (gradient.empty() ? 1 : n); ++k) {
      const auto all = peaks(intervals(y, k));
      for (std::size_t row = 0; row < all.size(); ++row) {
        const Complex share = all[row].value / all[row].limit;
        result[2 * row] = share.real() - 1;
        result[2 * row + 1] = -share.real() - 1;
        if (gradient.empty()) continue;
        gradient[2 * row * n + k] = share.imag() / step;
        gradient[(2 * row + 1) * n + k] = -share.imag() / step;
      }
    }
  }

  double objective(std::span<const double> y, std::span<double> gradient) const {
    double value = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const auto h = intervals(y, k);
      Complex f = std::log(std::accumulate(h.begin(), h.end(), Complex(0)));
      if (spec_.objective == TimeObjective::least_square_jerk)
        f = std::log(square_jerk(h)) + 5.0 * f;
      value = f.real();
      if (gradient.empty()) break;
      gradient[k] = f.imag() / step;
    }
    return value;
  }

 private:
  /// exp(y), the k-th with a derivative.
  static std::vector<Complex> intervals(std::span<const double> y, std::size_t k) {
    std::vector<Complex> h;
    for (std::size_t i = 0; i < y.size(); ++i)
      h.push_back(std::exp(y[i]) * Complex(1, i == k ? step : 0));
    return h;
  }

  [[nodiscard]] std::vector<Peak> peaks(const std::vector<Complex>& h) const {
    std::vector<Peak> all;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const auto s = joint_spline<Complex>(joints_[j], h);
      const auto limits = limits_of(spec_, j);
      for (std::size_t i = 0; i < h.size(); ++i) {
        if (limits[1]) all.push_back({1, turning_velocity(s, i), *limits[1]});
        if (limits[1] && i > 0) all.push_back({1, s.velocity[i], *limits[1]});
        if (limits[2] && i > 0) all.push_back({2, s.acceleration[i], *limits[2]});
        if (limits[3]) all.push_back({3, s.jerk[i], *limits[3]});
      }
    }
    return all;
  }

  const SplineTimesSpec& spec_;
  std::vector<std::vector<double>> joints_;  ///< positions of each
};

/// One run of SLSQP from y, or y where the run ends in NaN.
std::vector<double> solve_times(const TimeProblem& problem, bool limited,
                                const std::vector<double>& y, int& evaluations) {
  LocalProblem local{
      .row_tolerance = 1e-13, .lower = y, .upper = y, .x_relative = 1e-14, .max_evaluations = 400};
  for (double& bound : local.lower) bound -= std::log(farthest);
  for (double& bound : local.upper) bound += std::log(farthest);
  local.objective = [&](std::span<const double> at, std::span<double> gradient) {
    ++evaluations;
    return problem.objective(at, gradient);
  };
  if (limited) {
    local.rows = problem.rows(y.size());
    local.constraints = [&](auto at, auto rows, auto gradient) {
      problem.constraints(at, rows, gradient);
    };
  }
  const std::vector<double> best = run_local_solver(local, y);
  const bool finite =
      std::all_of(best.begin(), best.end(), [](double b) { return std::isfinite(b); });
  return finite ? best : y;
}

std::vector<double> exponentials(std::vector<double> y) {
  for (double& each : y) each = std::exp(each);
  return y;
}

/// Makes the intervals as short as the limits allow, or as long as required. Returns the value of the
/// objective.
double settle(const SplineTimesSpec& spec, const TimeProblem& problem, std::vector<double>& h) {
  const double total = std::accumulate(h.begin(), h.end(), 0.0);
  const bool shortest = spec.objective == TimeObjective::shortest;
  const double factor = shortest ? problem.scale(h) : spec.duration / total;
  for (double& each : h) each *= factor;
  if (shortest) return total * factor;
  if (spec.objective == TimeObjective::least_peak_jerk) return std::pow(problem.scale(h), 3);
  return problem.square_jerk({h.begin(), h.end()}).real();
}

}  // namespace

TimeAttempt improve(const SplineTimesSpec& spec, std::vector<double> h) {
  const TimeProblem problem(spec);
  const bool limited = spec.objective != TimeObjective::least_square_jerk;
  TimeAttempt best{std::move(h), 0, 0};
  best.value = settle(spec, problem, best.intervals);
  for (int run = 0; run < 12; ++run) {
    std::vector<double> y = best.intervals;
    const double scale = limited ? problem.scale(y) : 1;
    for (double& each : y) each = std::log(each * scale);
    std::vector<double> next = exponentials(solve_times(problem, limited, y, best.evaluations));
    const double value = settle(spec, problem, next);
    if (!(value < best.value)) break;
    const bool enough = value > best.value * (1 - no_gain);
    best.intervals = std::move(next);
    best.value = value;
    if (enough) break;
  }
  return best;
}

}  // namespace jounce::optimize_detail

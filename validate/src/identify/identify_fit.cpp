// SPDX-License-Identifier: Apache-2.0 Identification by weighted least squares over all recorded
// outputs. With x_j = log p_j, q_k(t_i; x) quantity k of the model at sample i and d_ki the
// recorded value,
//
//     (1)  r_ki = (q_k(t_i; x) - d_ki) / sigma_k,        J = dr/dx from forward sensitivities
//     (2)  minimize |r|^2                                Levenberg and Marquardt
//     (3)  sigma_k^2 = sum_i (q_k - d_k)^2 / (m_k - n m_k / m)
//
// (2) and (3) alternate until no sigma_k changes by 1 %: together they are the maximum likelihood
// for Gaussian noise of unknown size on each quantity. Then (J^T J)^-1 is the covariance of x, and
// the parameters are within
//
//     (4)  log p_j in x_j +- t_95(m - n) sqrt((J^T J)^-1_jj)
//
// G. A. F. Seber, C. J. Wild, Nonlinear Regression, Wiley 1989, ch. 2 and 5.

#include "validate/src/identify/identify_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "validate/src/drive/drive_response.hpp"
#include "validate/src/identify/identify_rules.hpp"
#include "validate/src/identify/stepped_response.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int weightings = 8;     // greatest number of repetitions of (2) and (3)
constexpr double settled = 0.01;  // relative change of a sigma
constexpr double flat_gain =
    1e-3;  // relative gain of |r|^2: a step of some hundredths of a standard deviation

/// The response of a controller with encoder counts does not depend smoothly on its numbers: the counts
/// step. The fit is without them.
Drive without_counts(Drive drive) {
  drive.controller.encoder_counts = 0;
  return drive;
}

/// In place of a sampled controller that cannot be stepped, the fit uses a continuous controller with the
/// same delay: hold and difference quotient cost half a cycle each.
Drive continuous(Drive drive) {
  Controller& c = drive.controller;
  c.delay += c.cycle;
  c.cycle = c.encoder_counts = 0;
  return drive;
}

/// Logarithms, but linear in the numbers themselves, p (1 + step): if only a sum of two numbers is determined
/// (friction of motor and load), its valley is then straight.
VectorXd advanced(const VectorXd& x, const VectorXd& step) {
  return x.array() + step.array().log1p();
}

class Fit {
 public:
  Fit(const Recording& recording, const Commanded& command, const IdentifySpec& spec,
      std::vector<std::string> keys, const IdentifyProgress& keep_going)
      : recording_(recording), command_(command), spec_(spec), keep_going_(keep_going) {
    fit_.keys = std::move(keys);
    base_ = without_counts(spec.drive);
    Drive copy = spec.drive;
    for (const std::string& key : fit_.keys) first_.push_back(*numbered(copy, key).value);
    grid_ = grid_of(command, response_spec(base_, first_));
    fit_.sampled = grid_.has_value() && base_.controller.cycle > 0;
    if (!grid_) base_ = continuous(base_);
    for (std::size_t k = 0; k < outputs; ++k)
      if (!recorded(recording, k).empty()) fit_.used.push_back(k);
    commanded_.reserve(recording.time.size());
    for (const double t : recording.time) commanded_.push_back(value_of(command.motion, t));
  }

  Fitted run() {
    search();
    if (fit_.found.status != LeastSquares::Status::not_computable) {
      fit_.values = values(fit_.found.x);
      if (command_.coarse != nullptr) compare_with(*command_.coarse);
      if (fit_.sampled && spec_.drive.controller.encoder_counts > 0) compare_with_counts();
    }
    return std::move(fit_);
  }

 private:
  [[nodiscard]] static double value_of(const SignalView& motion, double t) {
    return motion.jet(std::clamp(t, motion.start(), motion.end()),
                      t >= motion.end() ? Side::left : Side::right)[0];
  }
  [[nodiscard]] static bool is_deviation(std::size_t output) {
    return output == position || output == load;
  }
  [[nodiscard]] ResponseSpec response_spec(const Drive& base,
                                           const std::vector<double>& now) const {
    return {&base, fit_.keys, now, recording_.time, spec_.tolerance};
  }
  [[nodiscard]] DriveResponse response(const Commanded& command,
                                       const std::vector<double>& now) const {
    const ResponseSpec spec = response_spec(base_, now);
    return grid_ ? stepped_response(command, *grid_, spec) : respond(command.motion, spec);
  }

  [[nodiscard]] std::vector<double> values(const VectorXd& x) const {
    std::vector<double> all = first_;
    for (std::size_t j = 0; j < all.size(); ++j) all[j] *= std::exp(x[static_cast<Index>(j)]);
    return all;
  }

  /// The response of the model minus the recorded values.
  [[nodiscard]] Linearized compared(const DriveResponse& r) const {
    const auto m = static_cast<Index>(recording_.time.size());
    const auto n = static_cast<Index>(first_.size());
    Linearized all{VectorXd(m * blocks()), Eigen::MatrixXd(m * blocks(), n)};
    for (Index b = 0; b < blocks(); ++b) {
      const std::size_t k = fit_.used[static_cast<std::size_t>(b)];
      for (Index i = 0; i < m; ++i) {
        const auto s = static_cast<std::size_t>(i);
        const double measured = recorded(recording_, k)[s] - (is_deviation(k) ? commanded_[s] : 0);
        all.residual[b * m + i] = r.value[k][s] - measured;
      }
      all.jacobian.middleRows(b * m, m) = Eigen::Map<const Eigen::MatrixXd>(r.by[k].data(), m, n);
    }
    return all;
  }

  /// (1) without the weights.
  std::optional<Linearized> deviations(const VectorXd& x) {
    const std::vector<double> now = values(x);
    DriveResponse r;
    try {  // two valid numbers may contradict each other
      jounce::require_valid(with_numbers(base_, fit_.keys, now));
      r = response(command_, now);
    } catch (const InputError& error) {
      fit_.failure = error.what();
      return std::nullopt;
    }
    if (!r.integration.ok()) {
      fit_.failure = r.integration.reason;
      return std::nullopt;
    }
    Linearized all = compared(r);
    // A model that diverges with finite numbers would count as noise of any size.
    if (!std::isfinite(all.residual.squaredNorm() + all.jacobian.squaredNorm())) {
      fit_.failure = "its response overflows";
      return std::nullopt;
    }
    return all;
  }

  /// Compares the fitted model with its response to the coarse command.
  void compare_with(const Trajectory& coarse) {
    const DriveResponse fine = response(command_, fit_.values);
    const DriveResponse r = response({coarse}, fit_.values);
    if (!fine.integration.ok() || !r.integration.ok()) return;
    const Index m = fit_.samples();
    fit_.interpolation.resize(m * blocks());
    for (Index b = 0; b < blocks(); ++b) {
      const std::size_t k = fit_.used[static_cast<std::size_t>(b)];
      for (Index i = 0; i < m; ++i) {
        const auto s = static_cast<std::size_t>(i);
        const double commands =
            is_deviation(k) ? value_of(coarse, recording_.time[s]) - commanded_[s] : 0;
        fit_.interpolation[b * m + i] = r.value[k][s] - fine.value[k][s] + commands;
      }
    }
  }

  /// Compares the fitted model with its response with the encoder's counts.
  void compare_with_counts() {
    const ResponseSpec smooth{&base_, fit_.keys, fit_.values, recording_.time, spec_.tolerance};
    const DriveResponse without = stepped_values(command_, *grid_, smooth);
    Drive counting = base_;
    counting.controller.encoder_counts = spec_.drive.controller.encoder_counts;
    ResponseSpec rough = smooth;
    rough.start = &counting;
    const DriveResponse with = stepped_values(command_, *grid_, rough);
    const Index m = fit_.samples();
    fit_.counts.resize(m * blocks());
    for (Index b = 0; b < blocks(); ++b) {
      const std::size_t k = fit_.used[static_cast<std::size_t>(b)];
      for (Index i = 0; i < m; ++i)
        fit_.counts[b * m + i] = with.value[k][static_cast<std::size_t>(i)] -
                                 without.value[k][static_cast<std::size_t>(i)];
    }
  }

  [[nodiscard]] Index blocks() const { return static_cast<Index>(fit_.used.size()); }

  /// (3), but not below the accuracy of the integrator.
  [[nodiscard]] VectorXd standard_deviations(const VectorXd& r) const {
    VectorXd sigma(blocks());
    const double free =
        std::max(1 - static_cast<double>(first_.size()) / static_cast<double>(r.size()), 0.1);
    for (Index b = 0; b < blocks(); ++b) {
      const std::vector<double>& d = recorded(recording_, fit_.used[static_cast<std::size_t>(b)]);
      const auto [low, high] = std::minmax_element(d.begin(), d.end());
      const double least = 30 * spec_.tolerance * (*high - *low);
      sigma[b] = std::max({rms(fit_.block(r, b)) / std::sqrt(free), least, least_divisor});
    }
    return sigma;
  }

  void weigh(Linearized& at, const VectorXd& sigma) const {
    for (Index b = 0; b < blocks(); ++b) {
      at.residual.segment(b * fit_.samples(), fit_.samples()) /= sigma[b];
      at.jacobian.middleRows(b * fit_.samples(), fit_.samples()) /= sigma[b];
    }
  }

  /// Weighted residuals for the solver, which stops when the caller cancels.
  std::optional<Linearized> weighted(const VectorXd& x) {
    if (fit_.cancelled) return std::nullopt;
    auto r = deviations(x);
    if (!r) return r;
    const double share = r->residual.norm() / std::max(fit_.before.norm(), least_divisor);
    if (keep_going_ && !keep_going_(++runs_, share)) fit_.cancelled = true;
    weigh(*r, fit_.sigma);
    return r;
  }

  void search() {
    fit_.found.status = LeastSquares::Status::not_computable;
    VectorXd x = VectorXd::Zero(static_cast<Index>(first_.size()));
    const auto first = deviations(x);
    if (!first) return;
    fit_.before = first->residual;
    fit_.sigma = standard_deviations(fit_.before);
    double damping = 1e-3;
    for (int weighting = 0; weighting < weightings; ++weighting) {
      const int left = spec_.max_iterations - fit_.iterations;
      if (left <= 0) return;
      fit_.found = least_squares([this](const VectorXd& at) { return weighted(at); }, x,
                                 {.max_iterations = left,
                                  .damping = damping,
                                  .longest_step = 0.7,
                                  .advance = advanced,
                                  .flat = flat_gain});
      fit_.iterations += fit_.found.iterations;
      damping = fit_.found.damping;
      x = fit_.found.x;
      if (weigh_anew() || fit_.cancelled) return;
    }
  }

  /// Converts the result to the newest weights, for the covariance. Returns true if the weights are unchanged.
  bool weigh_anew() {
    VectorXd unweighted = fit_.found.at.residual;
    for (Index b = 0; b < blocks(); ++b)
      unweighted.segment(b * fit_.samples(), fit_.samples()) *= fit_.sigma[b];
    const VectorXd sigma = standard_deviations(unweighted);
    const bool same = ((sigma - fit_.sigma).array().abs() <= settled * sigma.array()).all();
    weigh(fit_.found.at, (sigma.array() / fit_.sigma.array()).matrix());
    fit_.sigma = sigma;
    return same;
  }

  const Recording& recording_;
  const Commanded& command_;
  const IdentifySpec& spec_;
  Drive base_;
  std::optional<Grid> grid_ = {};  // nullopt: an integration
  const IdentifyProgress& keep_going_;
  std::vector<double> first_;
  std::vector<double> commanded_;
  Fitted fit_;
  int runs_ = 0;
};

}  // namespace

double rms(const VectorXd& r) {
  return std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
}

Fitted fitted(const Recording& recording, const Commanded& command, const IdentifySpec& spec,
              std::vector<std::string> keys, const IdentifyProgress& keep_going) {
  return Fit(recording, command, spec, std::move(keys), keep_going).run();
}

}  // namespace jounce::validate_detail

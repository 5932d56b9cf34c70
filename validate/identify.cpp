// Weighted least squares over everything recorded. With x_j = log p_j, q_k(t_i; x) the model's
// quantity k at sample i and d_ki what was recorded,
//
//     (1)  r_ki = (q_k(t_i; x) - d_ki) / sigma_k,        J = dr/dx from forward sensitivities
//     (2)  minimise |r|^2                                Levenberg and Marquardt
//     (3)  sigma_k^2 = sum_i (q_k - d_k)^2 / (m_k - n m_k / m)
//
// (2) and (3) in turn until no sigma_k changes by 1 %: together they are the greatest likelihood for
// Gaussian noise of unknown size on each quantity. Then (J^T J)^-1 is the covariance of x, and
//
//     (4)  log p_j in x_j +- t_95(m - n) sqrt((J^T J)^-1_jj)
//
// G. A. F. Seber, C. J. Wild, Nonlinear Regression, Wiley 1989, ch. 2 and 5.

#include "jounce/validate/identify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Core>
#include <fmt/format.h>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"
#include "jounce/validate/detail/drive_response.hpp"
#include "jounce/validate/detail/identify_rules.hpp"
#include "jounce/validate/detail/least_squares.hpp"

namespace jounce {
namespace {

using detail::DriveResponse;
using detail::numbered;
using detail::quantities;
using detail::recorded;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double known = 1.0;      // a 95 % interval wider than a factor e either way: not known
constexpr double together = 0.95;  // correlation from which two numbers are named
constexpr double white = 0.3;      // autocorrelation from which intervals are clearly too narrow
constexpr int weightings = 8;      // (2), (3) at most as often
constexpr double settled = 0.01;   // of a sigma
constexpr double flat = 1e-3;      // of |r|^2: a step of some hundredths of a standard deviation

/// A sampled controller does not depend smoothly on anything: a count more or less steps. Fitted is
/// with a continuous one that is as late: hold and difference quotient cost half a cycle each.
Drive continuous(Drive drive) {
  Controller& c = drive.controller;
  c.delay += c.cycle;
  c.cycle = c.encoder_counts = 0;
  return drive;
}

double rms(const VectorXd& r) {
  return std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
}

double autocorrelation(const VectorXd& r) {
  const Index n = r.size() - 1;
  const double all = r.squaredNorm();
  return all > 0 ? r.head(n).dot(r.tail(n)) / all : 0;
}

/// Logarithms, but straight in the numbers themselves, p (1 + step): what only a sum of two numbers
/// decides (friction of motor and load) is a straight valley then.
VectorXd advanced(const VectorXd& x, const VectorXd& step) {
  return x.array() + step.array().log1p();
}

class Fit {
 public:
  Fit(const Recording& recording, const SignalView& reference, const IdentifySpec& spec,
      const IdentifyProgress& keep_going)
      : recording_(recording), reference_(reference), spec_(spec), keep_going_(keep_going) {
    base_ = continuous(spec.drive);
    Drive copy = spec.drive;
    for (const std::string& key : spec.fit) start_.push_back(numbered(copy, key));
    for (const DriveNumber& number : start_) first_.push_back(*number.value);
    for (std::size_t k = 0; k < detail::outputs; ++k)
      if (!recorded(recording, k).empty()) used_.push_back(k);
    commanded_.reserve(recording.time.size());
    for (const double t : recording.time) commanded_.push_back(command(t));
  }

  Identification result() {
    Identification answer;
    answer.drive = spec_.drive;
    auto found = search(answer);
    if (found.status == detail::LeastSquares::Status::not_computable) {
      answer.status = Identification::Status::failed;
      answer.reason = "the model cannot be integrated with the start's numbers: " + failure_;
      return answer;
    }
    tell(found, answer);
    return answer;
  }

 private:
  using Status = Identification::Status;

  [[nodiscard]] double command(double t) const {
    return reference_.jet(std::clamp(t, reference_.start(), reference_.end()),
                          t >= reference_.end() ? Side::left : Side::right)[0];
  }

  [[nodiscard]] std::vector<double> values(const VectorXd& x) const {
    std::vector<double> all = first_;
    for (std::size_t j = 0; j < all.size(); ++j) all[j] *= std::exp(x[static_cast<Index>(j)]);
    return all;
  }

  /// (1) without the weights.
  std::optional<detail::Linearised> deviations(const VectorXd& x) {
    const std::vector<double> now = values(x);
    const auto m = static_cast<Index>(recording_.time.size());
    const auto n = static_cast<Index>(now.size());
    try {  // two numbers may not fit together, each right in itself
      jounce::require_valid(detail::with_numbers(base_, spec_.fit, now));
    } catch (const InputError& error) {
      failure_ = error.what();
      return std::nullopt;
    }
    const DriveResponse r =
        detail::respond(reference_, {&base_, spec_.fit, now, recording_.time, spec_.tolerance});
    if (!r.integration.ok()) {
      failure_ = r.integration.reason;
      return std::nullopt;
    }
    detail::Linearised all{VectorXd(m * blocks()), Eigen::MatrixXd(m * blocks(), n)};
    for (Index b = 0; b < blocks(); ++b) {
      const std::size_t k = used_[static_cast<std::size_t>(b)];
      const bool deviation = k == detail::position || k == detail::load;
      for (Index i = 0; i < m; ++i) {
        const auto s = static_cast<std::size_t>(i);
        const double measured = recorded(recording_, k)[s] - (deviation ? commanded_[s] : 0);
        all.residual[b * m + i] = r.value[k][s] - measured;
      }
      all.jacobian.middleRows(b * m, m) = Eigen::Map<const Eigen::MatrixXd>(r.by[k].data(), m, n);
    }
    // A model that runs away, every number of it finite, would weigh as noise beyond all bounds.
    if (!std::isfinite(all.residual.squaredNorm() + all.jacobian.squaredNorm())) {
      failure_ = "its response overflows";
      return std::nullopt;
    }
    return all;
  }

  [[nodiscard]] Index blocks() const { return static_cast<Index>(used_.size()); }
  [[nodiscard]] Index samples() const { return static_cast<Index>(recording_.time.size()); }

  [[nodiscard]] VectorXd block(const VectorXd& r, Index b) const {
    return r.segment(b * samples(), samples());
  }

  /// (3), but not below what the integrator leaves.
  [[nodiscard]] VectorXd noise(const VectorXd& r) const {
    VectorXd sigma(blocks());
    const double free =
        std::max(1 - static_cast<double>(start_.size()) / static_cast<double>(r.size()), 0.1);
    for (Index b = 0; b < blocks(); ++b) {
      const std::vector<double>& d = recorded(recording_, used_[static_cast<std::size_t>(b)]);
      const auto [low, high] = std::minmax_element(d.begin(), d.end());
      const double least = 30 * spec_.tolerance * (*high - *low);
      sigma[b] = std::max({rms(block(r, b)) / std::sqrt(free), least, 1e-300});
    }
    return sigma;
  }

  void weigh(detail::Linearised& at, const VectorXd& sigma) const {
    for (Index b = 0; b < blocks(); ++b) {
      at.residual.segment(b * samples(), samples()) /= sigma[b];
      at.jacobian.middleRows(b * samples(), samples()) /= sigma[b];
    }
  }

  detail::LeastSquares search(Identification& answer) {
    detail::LeastSquares found;
    found.status = detail::LeastSquares::Status::not_computable;
    VectorXd x = VectorXd::Zero(static_cast<Index>(start_.size()));
    const auto first = deviations(x);
    if (!first) return found;
    before_ = first->residual;
    sigma_ = noise(before_);
    double damping = 1e-3;
    for (int weighting = 0; weighting < weightings; ++weighting) {
      const auto weighted = [&](const VectorXd& at) -> std::optional<detail::Linearised> {
        if (cancelled_) return std::nullopt;
        auto r = deviations(at);
        if (r) {
          if (keep_going_ &&
              !keep_going_(++runs_, r->residual.norm() / std::max(before_.norm(), 1e-300)))
            cancelled_ = true;
          weigh(*r, sigma_);
        }
        return r;
      };
      const int left = spec_.max_iterations - answer.iterations;
      if (left <= 0) break;
      found = detail::least_squares(weighted, x,
                                    {.max_iterations = left,
                                     .damping = damping,
                                     .longest_step = 0.7,
                                     .advance = advanced,
                                     .flat = flat});
      answer.iterations += found.iterations;
      damping = found.damping;
      x = found.x;
      VectorXd unweighted = found.at.residual;
      for (Index b = 0; b < blocks(); ++b)
        unweighted.segment(b * samples(), samples()) *= sigma_[b];
      const VectorXd sigma = noise(unweighted);
      const bool same = ((sigma - sigma_).array().abs() <= settled * sigma.array()).all();
      // to the newest weights, for the covariance
      weigh(found.at, (sigma.array() / sigma_.array()).matrix());
      sigma_ = sigma;
      if (same || cancelled_) break;
    }
    return found;
  }

  void tell(const detail::LeastSquares& found, Identification& answer) {
    const std::vector<double> now = values(found.x);
    answer.drive = detail::with_numbers(spec_.drive, spec_.fit, now);
    const detail::Covariance c = detail::covariance(found.at.jacobian);
    const double t = detail::student_95(static_cast<double>(found.at.residual.size()) -
                                        static_cast<double>(now.size()));
    std::string unknown;
    for (std::size_t j = 0; j < now.size(); ++j) {
      const double half = t * c.deviation[static_cast<Index>(j)];  // (4)
      const double a = now[j] * std::exp(-half), b = now[j] * std::exp(half);
      answer.numbers.push_back(
          {start_[j].key, start_[j].unit, first_[j], now[j], std::min(a, b), std::max(a, b)});
      if (!(half <= known)) unknown += (unknown.empty() ? "" : ", ") + start_[j].key;
    }
    entangle(c, answer);
    explain(found, answer);
    conclude(found, unknown, answer);
  }

  static void entangle(const detail::Covariance& c, Identification& answer) {
    for (Index i = 0; i < c.correlation.rows(); ++i)
      for (Index j = i + 1; j < c.correlation.cols(); ++j)
        if (std::abs(c.correlation(i, j)) > together)
          answer.entangled.push_back({answer.numbers[static_cast<std::size_t>(i)].key,
                                      answer.numbers[static_cast<std::size_t>(j)].key,
                                      c.correlation(i, j)});
    std::sort(answer.entangled.begin(), answer.entangled.end(),
              [](const Entangled& a, const Entangled& b) {
                return std::abs(a.correlation) > std::abs(b.correlation);
              });
  }

  void explain(const detail::LeastSquares& found, Identification& answer) const {
    for (Index b = 0; b < blocks(); ++b) {
      const std::size_t k = used_[static_cast<std::size_t>(b)];
      const VectorXd r = block(found.at.residual, b) * sigma_[b];
      Explained e{quantities[k], rms(block(before_, b)), rms(r), autocorrelation(r)};
      e.model.resize(recording_.time.size());
      for (std::size_t i = 0; i < e.model.size(); ++i)
        e.model[i] = recorded(recording_, k)[i] + r[static_cast<Index>(i)];
      if (e.autocorrelation > white && e.after > significant(k))
        answer.notes.push_back(
            fmt::format("the residuals of {} are not white (autocorrelation {:.2f}): the model "
                        "misses something, "
                        "and the intervals are too narrow",
                        e.quantity, e.autocorrelation));
      answer.explained.push_back(std::move(e));
    }
    if (spec_.drive.controller.cycle > 0)
      answer.notes.push_back(
          "the sampled controller was taken for a continuous one that is a cycle later");
    const double before = spec_.drive.controller.torque_feed_forward;
    const double after = answer.drive.controller.torque_feed_forward;
    if (before != after)
      answer.notes.push_back(fmt::format(
          "controller.torque_feed_forward is {:.4g} of the fitted inertia: what the controller was "
          "set to, {:.4g} of {:.4g} kg m^2, has not changed",
          after, before, before == 0 ? 0 : inertia(spec_.drive)));
  }

  /// Below this residuals are the integrator's.
  [[nodiscard]] double significant(std::size_t k) const {
    const std::vector<double>& d = recorded(recording_, k);
    const auto [low, high] = std::minmax_element(d.begin(), d.end());
    return 1e3 * spec_.tolerance * (*high - *low);
  }

  static double inertia(const Drive& drive) {
    double all = drive.motor.inertia;
    for (const Mass& mass : drive.train) all += mass.inertia;
    return all;
  }

  void conclude(const detail::LeastSquares& found, const std::string& unknown,
                Identification& answer) const {
    if (cancelled_) {
      answer.status = Status::cancelled;
      answer.reason = "stopped on request; the numbers are the best so far";
    } else if (!unknown.empty()) {
      answer.status = Status::not_identifiable;
      answer.reason = "this recording does not tell " + unknown;
      if (!answer.entangled.empty())
        answer.reason += fmt::format(
            "; {} and {} cannot be told apart (correlation {:.4f})", answer.entangled.front().first,
            answer.entangled.front().second, answer.entangled.front().correlation);
    } else if (found.status != detail::LeastSquares::Status::converged) {
      answer.status = Status::stalled;
      answer.reason = fmt::format("no convergence within {} iterations: start nearer, or fit less",
                                  spec_.max_iterations);
    } else {
      answer.status = Status::converged;
      answer.reason = fmt::format("{} number{} fitted to {} samples in {} iterations",
                                  answer.numbers.size(), answer.numbers.size() == 1 ? "" : "s",
                                  recording_.time.size(), answer.iterations);
    }
  }

  const Recording& recording_;
  const SignalView& reference_;
  const IdentifySpec& spec_;
  Drive base_;
  const IdentifyProgress& keep_going_;
  std::vector<DriveNumber> start_;
  std::vector<double> first_;
  std::vector<double> commanded_;
  std::vector<std::size_t> used_;
  VectorXd before_;
  VectorXd sigma_;
  std::string failure_;
  bool cancelled_ = false;
  int runs_ = 0;
};

}  // namespace

const char* name(Identification::Status status) {
  switch (status) {
    case Identification::Status::converged:
      return "converged";
    case Identification::Status::not_identifiable:
      return "not identifiable";
    case Identification::Status::stalled:
      return "stalled";
    case Identification::Status::cancelled:
      return "cancelled";
    case Identification::Status::failed:
      break;
  }
  return "failed";
}

Trajectory commanded_motion(const Recording& recording) {
  detail::require_times(recording);
  FillSpec spec{.x = recording.time, .p = recording.command};
  spec.filling = Filling::clamped;
  return filled(spec).table.curve<OverTime>();
}

Identification identify(const Recording& recording, const SignalView& reference,
                        const IdentifySpec& spec, const IdentifyProgress& keep_going) {
  detail::require_valid(recording);
  detail::require_valid(spec);
  if (reference.over_master())
    throw InputError("axis", "master", "a drive follows a motion over time");
  if (recording.time.front() < reference.start())
    throw InputError("time[1]", recording.time.front(),
                     "must not be before the motion's start at " + number(reference.start()));
  return Fit(recording, reference, spec, keep_going).result();
}

}  // namespace jounce

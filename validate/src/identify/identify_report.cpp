// SPDX-License-Identifier: Apache-2.0
// The report of a fit: intervals, numbers that the recording cannot separate, properties of the residuals. (4)
// is that of identify_fit.cpp.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>

#include "validate/src/drive/drive_response.hpp"
#include "validate/src/identify/identify_fit.hpp"
#include "validate/src/identify/identify_rules.hpp"
#include "validate/src/identify/residual_tests.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Status = Identification::Status;

constexpr double known = 1.0;  // a 95 % interval wider than a factor e either way: not determined
constexpr double together = 0.95;  // correlation from which two numbers are named

double autocorrelation(const VectorXd& r) {
  const Index n = r.size() - 1;
  const double all = r.squaredNorm();
  return all > 0 ? r.head(n).dot(r.tail(n)) / all : 0;
}

double inertia(const Drive& drive) {
  double all = drive.motor.inertia;
  for (const Mass& mass : drive.train) all += mass.inertia;
  return all;
}

/// (4), and the numbers that it does not determine.
std::string add_numbers(const IdentifySpec& spec, const Fitted& fit, const Covariance& c,
                        Identification& answer) {
  const double t = student_95(static_cast<double>(fit.found.at.residual.size()) -
                              static_cast<double>(fit.values.size()));
  Drive first = spec.drive;
  std::string unknown;
  for (std::size_t j = 0; j < fit.values.size(); ++j) {
    const DriveNumber number = numbered(first, spec.fit[j]);
    const double half = t * c.deviation[static_cast<Index>(j)];  // (4)
    const double a = fit.values[j] * std::exp(-half), b = fit.values[j] * std::exp(half);
    answer.numbers.push_back(
        {number.key, number.unit, *number.value, fit.values[j], std::min(a, b), std::max(a, b)});
    if (!(half <= known)) unknown += (unknown.empty() ? "" : ", ") + number.key;
  }
  return unknown;
}

void entangle(const Covariance& c, Identification& answer) {
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

/// Residuals below this are errors of the integrator.
double significant(const std::vector<double>& d, double tolerance) {
  const auto [low, high] = std::minmax_element(d.begin(), d.end());
  return 1e3 * tolerance * (*high - *low);
}

void test_residuals(const VectorXd& before, const VectorXd& after, Explained& e) {
  const std::span<const double> r(after.data(), static_cast<std::size_t>(after.size()));
  e.white = whiteness(r);
  e.growth = growth(r);
  e.worsening = worsening({before.data(), r.size()}, r);
}

/// The objections of one test, in one sentence for all quantities; "": none.
std::string doubt(const std::vector<Explained>& all, ResidualTest Explained::*test,
                  const char* what, const char* statistic) {
  std::string quantities;
  const ResidualTest* worst = nullptr;
  for (const Explained& e : all) {
    const ResidualTest& own = e.*test;
    if (!own.failed()) continue;
    quantities += (quantities.empty() ? "" : ", ") + e.quantity;
    if (worst == nullptr || own.value / own.limit > worst->value / worst->limit) worst = &own;
  }
  if (worst == nullptr) return "";
  return fmt::format(
      "the differences between the recorded and the computed {} (the residuals) {} ({} {:.4g}, "
      "limit {:.4g}). The model lacks an effect of their size, and the intervals are too narrow: "
      "find the effect with --plot, then add it to the spec of the drive, or its number to --fit",
      quantities, what, statistic, worst->value, worst->limit);
}

/// The objections of the tests to the model.
std::vector<std::string> doubts(const std::vector<Explained>& all) {
  std::vector<std::string> texts{
      doubt(all, &Explained::white, "are correlated over time, which noise is not",
            "Ljung-Box test:"),
      doubt(all, &Explained::growth, "grow along the recording", "Goldfeld-Quandt test:"),
      doubt(all, &Explained::worsening, "are greater than with the given drive",
            "ratio of the variances")};
  std::erase(texts, "");
  return texts;
}

void explain(const Recording& recording, const IdentifySpec& spec, const Fitted& fit,
             Identification& answer) {
  for (std::size_t b = 0; b < fit.used.size(); ++b) {
    const auto at = static_cast<Index>(b);
    const std::vector<double>& d = recorded(recording, fit.used[b]);
    const VectorXd r = fit.block(fit.found.at.residual, at) * fit.sigma[at];
    Explained e{quantities[fit.used[b]], rms(fit.block(fit.before, at)), rms(r),
                autocorrelation(r)};
    e.model.resize(d.size());
    for (std::size_t i = 0; i < d.size(); ++i) e.model[i] = d[i] + r[static_cast<Index>(i)];
    const double interpolation =
        fit.interpolation.size() > 0 ? rms(fit.block(fit.interpolation, at)) : 0;
    if (e.after > std::max({significant(d, spec.tolerance), resolution(d) / 2, interpolation}))
      test_residuals(fit.block(fit.before, at), r, e);
    answer.explained.push_back(std::move(e));
  }
  answer.notes = doubts(answer.explained);
}

/// For a model that does not fit: the torque feed-forward may be that of another inertia.
std::string feed_forward_note(const IdentifySpec& spec) {
  const bool fits_inertia = std::any_of(spec.fit.begin(), spec.fit.end(),
                                        [](const auto& key) { return key.ends_with("inertia"); });
  const double factor = spec.drive.controller.torque_feed_forward;
  if (!fits_inertia || factor == 0) return "";
  const double given = inertia(spec.drive);
  return fmt::format(
      "the torque feed-forward of the controller uses {:.4g} kg m^2, {:.4g} times the given "
      "inertia. If the controller of the recorded drive used another inertia, divide it by {:.4g} "
      "kg m^2, the given one, and set controller.torque_feed_forward to the quotient",
      factor * given, factor, given);
}

/// A note on the change of the controller.
void note(const IdentifySpec& spec, Identification& answer) {
  const bool misfit = !doubts(answer.explained).empty();
  if (const std::string text = feed_forward_note(spec); misfit && !text.empty())
    answer.notes.push_back(text);
  if (spec.drive.controller.cycle > 0)
    answer.notes.emplace_back(
        "the model replaces the sampled controller by a continuous one, one cycle later");
  const double before = spec.drive.controller.torque_feed_forward;
  const double after = answer.drive.controller.torque_feed_forward;
  const std::string rounded = fmt::format("{:.4g}", after);
  if (rounded != fmt::format("{:.4g}", before))
    answer.notes.push_back(
        fmt::format("the torque feed-forward of the controller still uses {:.4g} times the given "
                    "inertia, {:.4g} kg m^2. To keep its torque with the fitted inertia, set "
                    "controller.torque_feed_forward = {}",
                    before, inertia(spec.drive), rounded));
}

std::string not_determined(const std::string& unknown, const Identification& answer) {
  const std::string reason = "this recording does not determine " + unknown;
  const auto is_open = [&](const std::string& key) {
    const auto& all = answer.numbers;
    return std::any_of(all.begin(), all.end(), [&](const FittedNumber& n) {
      return n.key == key && !(std::log(n.high / n.low) / 2 <= known);
    });
  };
  for (const Entangled& e : answer.entangled)
    if (is_open(e.first) || is_open(e.second))
      return fmt::format(
          "{}: in it, {} and {} cannot be distinguished (correlation {:.4f}). Fit only one of the "
          "two",
          reason, e.first, e.second, e.correlation);
  const std::string record =
      unknown.ends_with("torque_limit") && unknown.find(',') == std::string::npos
          ? "record a motion that reaches this limit"
          : std::string("record a motion that depends on ") +
                (unknown.find(',') == std::string::npos ? "it" : "them") +
                ", with acceleration and a change of direction";
  const bool fits_others =
      std::any_of(answer.numbers.begin(), answer.numbers.end(),
                  [&](const FittedNumber& n) { return std::log(n.high / n.low) / 2 <= known; });
  return reason + (fits_others ? ": remove " + unknown + " from --fit, or " : ": ") + record;
}

void conclude(const IdentifySpec& spec, const Fitted& fit, const std::string& unknown,
              std::size_t samples, Identification& answer) {
  const auto end = [&](Status status, std::string reason) {
    answer.status = status;
    answer.reason = std::move(reason);
  };
  if (fit.cancelled)
    return end(Status::cancelled, "stopped on request; the numbers are the best so far");
  if (!unknown.empty()) return end(Status::not_identifiable, not_determined(unknown, answer));
  if (fit.found.status != LeastSquares::Status::converged)
    return end(
        Status::stalled,
        fmt::format("no convergence within {} iterations: start closer, or fit fewer numbers",
                    spec.max_iterations));
  if (const auto all = doubts(answer.explained); !all.empty())
    return end(Status::misfit, all.front());
  end(Status::converged,
      fmt::format("{} number{} fitted to {} samples in {} iterations", answer.numbers.size(),
                  answer.numbers.size() == 1 ? "" : "s", samples, answer.iterations));
}

}  // namespace

Identification told(const Recording& recording, const IdentifySpec& spec, const Fitted& fit) {
  Identification answer;
  answer.drive = spec.drive;
  answer.iterations = fit.iterations;
  if (fit.found.status == LeastSquares::Status::not_computable) {
    answer.status = Status::failed;
    answer.reason = "the model cannot be integrated with the start's numbers: " + fit.failure;
    return answer;
  }
  answer.drive = with_numbers(spec.drive, spec.fit, fit.values);
  const Covariance c = covariance(fit.found.at.jacobian);
  const std::string unknown = add_numbers(spec, fit, c, answer);
  entangle(c, answer);
  explain(recording, spec, fit, answer);
  note(spec, answer);
  conclude(spec, fit, unknown, recording.time.size(), answer);
  return answer;
}

}  // namespace jounce::validate_detail

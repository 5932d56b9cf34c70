// SPDX-License-Identifier: Apache-2.0
// The report of a fit: intervals, numbers that the recording cannot separate, properties of the residuals. (4)
// is that of identify_fit.cpp.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>

#include "validate/src/drive/drive_response.hpp"
#include "validate/src/identify/correlated.hpp"
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
/// Greatest rms of residuals that are an effect of the encoder's counts, as a share of another such effect.
constexpr double like_counts = 1.5;
/// Name of the inertia that the feed-forward of the controller uses.
constexpr const char* feed_forward_inertia = "feed-forward inertia";

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

/// True if the feed-forward of the recorded controller was fitted.
bool has_feed_forward(const Fitted& fit) {
  return !fit.keys.empty() && fit.keys.back() == controller_share;
}

/// (4) of one number, whose values at the start and after the fit are known.
FittedNumber with_interval(FittedNumber number, double half) {
  const double a = number.value * std::exp(-half), b = number.value * std::exp(half);
  number.low = std::min(a, b);
  number.high = std::max(a, b);
  return number;
}

FittedNumber feed_forward(const IdentifySpec& spec, double share, double half) {
  const double given = inertia(spec.drive);
  const double start = spec.drive.controller.torque_feed_forward * given;
  return with_interval({feed_forward_inertia, "kg m^2", start, share * given}, half);
}

/// Numbers that the recording does not determine.
struct Undetermined {
  std::string keys = {};
  bool even_if_white = false;  ///< also if the residuals were not correlated

  void add(const std::string& key, double half, double half_if_white) {
    if (half <= known) return;
    keys += (keys.empty() ? "" : ", ") + key;
    even_if_white = even_if_white || !(half_if_white <= known);
  }
};

/// (4), and the numbers that it does not determine.
Undetermined add_numbers(const IdentifySpec& spec, const Fitted& fit, const Covariance& c,
                         Identification& answer) {
  const double t = student_95(static_cast<double>(fit.found.at.residual.size()) -
                              static_cast<double>(fit.values.size()));
  const Covariance white = covariance(fit.found.at.jacobian);
  Drive first = spec.drive;
  Undetermined unknown;
  for (std::size_t j = 0; j < spec.fit.size(); ++j) {
    const DriveNumber number = numbered(first, spec.fit[j]);
    const double half = t * c.deviation[static_cast<Index>(j)];  // (4)
    answer.numbers.push_back(
        with_interval({number.key, number.unit, *number.value, fit.values[j]}, half));
    unknown.add(number.key, half, t * white.deviation[static_cast<Index>(j)]);
  }
  if (!has_feed_forward(fit)) return unknown;
  const double half = t * c.deviation[c.deviation.size() - 1];
  answer.feed_forward = feed_forward(spec, fit.values.back(), half);
  unknown.add(feed_forward_inertia, half, t * white.deviation[white.deviation.size() - 1]);
  return unknown;
}

void entangle(const Fitted& fit, const Covariance& c, Identification& answer) {
  const auto key = [&](Index i) -> std::string {
    const std::string& own = fit.keys[static_cast<std::size_t>(i)];
    return own == controller_share ? feed_forward_inertia : own;
  };
  for (Index i = 0; i < c.correlation.rows(); ++i)
    for (Index j = i + 1; j < c.correlation.cols(); ++j)
      if (std::abs(c.correlation(i, j)) > together)
        answer.entangled.push_back({key(i), key(j), c.correlation(i, j)});
  std::sort(answer.entangled.begin(), answer.entangled.end(),
            [](const Entangled& a, const Entangled& b) {
              return std::abs(a.correlation) > std::abs(b.correlation);
            });
}

/// The covariance allows for residuals that are correlated over time.
Covariance covariance_of(const Fitted& fit) {
  const VectorXd& all = fit.found.at.residual;
  for (Index b = 0; b < static_cast<Index>(fit.used.size()); ++b) {
    const VectorXd r = fit.block(all, b);
    if (whiteness({r.data(), static_cast<std::size_t>(r.size())}).failed())
      return correlated_covariance(fit.found.at, fit.samples());
  }
  return covariance(fit.found.at.jacobian);
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
      "limit {:.4g}). The model lacks an effect of their size, so the true numbers can be "
      "outside of the intervals: find the effect with --plot, then add it to the spec of the "
      "drive, or its number to --fit",
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
    const auto size = [&](const VectorXd& effect) {
      return effect.size() > 0 ? rms(fit.block(effect, at)) : 0;
    };
    if (e.after > std::max({significant(d, spec.tolerance), resolution(d) / 2,
                            size(fit.interpolation), like_counts * size(fit.counts)}))
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

/// For a feed-forward of the recorded controller that is not the one of the spec with the fitted inertia.
std::string fitted_feed_forward_note(const IdentifySpec& spec, const Identification& answer) {
  const FittedNumber& used = *answer.feed_forward;
  const double factor = spec.drive.controller.torque_feed_forward;
  const double fitted = inertia(answer.drive);
  const std::string rounded = fmt::format("{:.4g}", answer.drive.controller.torque_feed_forward);
  if ((used.low <= factor * fitted && factor * fitted <= used.high) ||
      rounded == fmt::format("{:.4g}", factor))
    return "";
  return fmt::format(
      "the torque feed-forward of the recorded controller uses {:.4g} kg m^2. The spec has {:.4g} "
      "times the inertia; with the fitted inertia this is {:.4g} kg m^2. For the controller of the "
      "recording, set controller.torque_feed_forward = {}",
      used.value, factor, factor * fitted, rounded);
}

std::string kept_feed_forward_note(const IdentifySpec& spec, const Identification& answer) {
  const double before = spec.drive.controller.torque_feed_forward;
  const double after = answer.drive.controller.torque_feed_forward;
  const std::string rounded = fmt::format("{:.4g}", after);
  if (rounded == fmt::format("{:.4g}", before)) return "";
  return fmt::format(
      "the torque feed-forward of the controller still uses {:.4g} times the given "
      "inertia, {:.4g} kg m^2. To keep its torque with the fitted inertia, set "
      "controller.torque_feed_forward = {}",
      before, inertia(spec.drive), rounded);
}

/// Notes on the change of the controller.
void note(const IdentifySpec& spec, const Fitted& fit, Identification& answer) {
  const bool misfit = !doubts(answer.explained).empty();
  const auto add = [&](std::string text) {
    if (!text.empty()) answer.notes.push_back(std::move(text));
  };
  if (misfit && !answer.feed_forward) add(feed_forward_note(spec));
  if (spec.drive.controller.cycle > 0 && !fit.sampled)
    add("the model replaces the sampled controller by a continuous one, one cycle later");
  add(answer.feed_forward ? fitted_feed_forward_note(spec, answer)
                          : kept_feed_forward_note(spec, answer));
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

void conclude(const IdentifySpec& spec, const Fitted& fit, const Undetermined& unknown,
              std::size_t samples, Identification& answer) {
  const auto end = [&](Status status, std::string reason) {
    answer.status = status;
    answer.reason = std::move(reason);
  };
  if (fit.cancelled)
    return end(Status::cancelled, "stopped on request; the numbers are the best so far");
  const auto all = doubts(answer.explained);
  // A wrong model can be the reason of correlated residuals, and so of wide intervals.
  if (unknown.even_if_white || (!unknown.keys.empty() && all.empty()))
    return end(Status::not_identifiable, not_determined(unknown.keys, answer));
  if (fit.found.status != LeastSquares::Status::converged)
    return end(
        Status::stalled,
        fmt::format("no convergence within {} iterations: start closer, or fit fewer numbers",
                    spec.max_iterations));
  if (!all.empty()) return end(Status::misfit, all.front());
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
  answer.drive = with_numbers(spec.drive, fit.keys, fit.values);
  const Covariance c = covariance_of(fit);
  const Undetermined unknown = add_numbers(spec, fit, c, answer);
  entangle(fit, c, answer);
  explain(recording, spec, fit, answer);
  note(spec, fit, answer);
  conclude(spec, fit, unknown, recording.time.size(), answer);
  return answer;
}

}  // namespace jounce::validate_detail

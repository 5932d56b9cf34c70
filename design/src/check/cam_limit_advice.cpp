// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/cam_limit_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "jounce/design/detail/law_guide.hpp"

#include "design/src/check/master_check.hpp"
#include "design/src/check/stretch.hpp"

namespace jounce::design_detail {
namespace {

using Coefficients = std::array<double, 4>;  ///< for the derivatives of orders 1 to 3

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The advice for the broken limits of a cam, whose segments share its length.
class CamAdvice {
 public:
  explicit CamAdvice(const Input& input)
      : input_(input), cam_(std::get<Cam>(*input.curve)), words_{input.labels} {}

  void write(Report& report) {
    for (const Finding& f : report.findings) note(f);
    const std::string crowded = crowded_text();
    for (Finding& f : report.findings)
      if (const std::size_t order = order_of(f, OverMaster::names); order > 0)
        f.advice = text_of(f, order, crowded);
  }

 private:
  [[nodiscard]] Stretch stretch(const Finding& f, std::size_t order) const {
    return stretch_of(cam_, input_.labels, f, order);
  }

  /// Notes the least length of the segment of a finding.
  void note(const Finding& f) {
    const std::size_t order = order_of(f, OverMaster::names);
    if (order == 0) return;
    const Stretch s = stretch(f, order);
    if (!s.scales()) return;
    double& length = lengths_[input_.labels.segment_of(f)];
    length = std::max(length, least_length(f, order, s));
    limits_[order] = std::abs(f.limit);
  }

  /// The length of the cam that the other moving segments leave.
  [[nodiscard]] double room() const {
    double room = cam_.end() - cam_.start();
    const double peak = rest * std::abs(extrema(cam_, 1).peak().value);
    for (const SegmentGroup& group : groups(cam_.segments().size(), input_.labels)) {
      if (lengths_.contains(group.label)) continue;
      for (std::size_t i = group.first; i <= group.last; ++i) {
        const Range slope = extrema(Cam({cam_.segments()[i]}), 1);
        if (slope.max.value > peak || slope.min.value < -peak)
          room -= cam_.breaks()[i + 1] - cam_.breaks()[i];
      }
    }
    return room;
  }

  /// "the segments 1 rise and 3 return together need 363.5 deg ...": "" if each of them can be long
  /// enough, at the cost of the dwells.
  [[nodiscard]] std::string crowded_text() const {
    if (lengths_.size() < 2) return "";
    double needed = 0;
    std::string names;
    for (const auto& [name, length] : lengths_) {
      needed += length;
      names += (names.empty() ? "" : ", ") + name;
    }
    const double left = room();
    if (needed <= left * (1 + rest)) return "";
    return fmt::format(
        "together, the segments {} need {}, but the cam has only {} for them, dwells included: ",
        names, words_.at_least(needed), words_.x(left));
  }

  /// "raise the limit to at least 0.7332 mm/deg": first for the present knots, then for the best
  /// ones.
  [[nodiscard]] std::string raised_text(const Finding& f, std::size_t order) const {
    const std::string now =
        "raise the limit to at least " + words_.of(Words::rounded_up(std::abs(f.value)), order);
    if (limits_.size() != 1) return now;
    double needed = 0;
    for (const auto& [name, length] : lengths_) needed += length;
    const double least =
        limits_.begin()->second * std::pow(needed / room(), static_cast<double>(order));
    return now + ", or to " + words_.of(Words::rounded_up(least), order) +
           " with longer segments instead of dwells";
  }

  [[nodiscard]] std::string text_of(const Finding& f, std::size_t order,
                                    const std::string& crowded) const {
    const Stretch s = stretch(f, order);
    const std::string why = impossibility(f, order, s, words_, "the segment");
    const char* const verb = why.empty() ? "lengthen" : "Lengthen";
    const auto length = lengths_.find(input_.labels.segment_of(f));
    if (!s.scales() || length == lengths_.end())
      return why + verb + " the segment, or raise the limit";
    const std::string law = why.empty() ? law_text(f, order, s) : "";
    if (!crowded.empty()) return crowded + raised_text(f, order) + law;
    return fmt::format("{}{} the segment to at least {}{}", why, verb,
                       words_.at_least(length->second), law.empty() ? ", or raise the limit" : law);
  }

  /// The greatest coefficients of a law with which the segment keeps all limits.
  [[nodiscard]] Coefficients permitted(const Stretch& s) const {
    const Spec& spec = *input_.spec;
    const double speed = spec.master ? spec.master->velocity : 0;
    const auto of = [](const Limits& l) { return std::array{l.velocity, l.acceleration, l.jerk}; };
    Coefficients most{};
    for (std::size_t k = 1; k < most.size(); ++k) {
      const double power = static_cast<double>(k);
      const double scale = std::pow(s.length, power) / std::abs(s.stroke);
      most[k] = of(input_.limits)[k - 1].value_or(unlimited) * scale;
      if (speed > 0)
        most[k] = std::min(
            most[k], of(spec.slave)[k - 1].value_or(unlimited) / std::pow(speed, power) * scale);
    }
    return most;
  }

  /// ", or use law = ...": a law from rest to rest that keeps all limits; "" if there is none.
  [[nodiscard]] std::string law_text(const Finding& f, std::size_t order, const Stretch& s) const {
    const Spec& spec = *input_.spec;
    if (!std::holds_alternative<CamSpec>(spec.subject) || !spec.then.empty() || spec.polydyne)
      return "";
    const Coefficients most = permitted(s);
    std::optional<Law> best;
    double share = 1;  // greatest share of a permitted coefficient
    Coefficients of_best{};
    for (const Law law : rising_laws()) {
      if (info(law).ends != Ends::moving || law == Law::scca) continue;
      const Characteristics c = characteristics(law);
      const Coefficients own{0, c.cv.value, c.peak_acceleration(), c.cj.value};
      if (!std::isfinite(own[3])) continue;
      double used = 0;
      for (std::size_t k = 1; k < most.size(); ++k) used = std::max(used, own[k] / most[k]);
      if (used >= share) continue;
      best = law, share = used, of_best = own;
    }
    if (!best) return "";
    constexpr std::array symbols{"", "Cv", "Ca", "Cj"};
    const double power = static_cast<double>(order);
    return fmt::format(", or use law = \"{}\" ({} {:.4g} instead of {:.4g})", name(*best),
                       symbols[order], of_best[order],
                       std::abs(f.value) * std::pow(s.length, power) / std::abs(s.stroke));
  }

  const Input& input_;
  const Cam& cam_;
  Words words_;
  /// Least length of each segment that breaks a limit, with its present law, for all limits.
  std::map<std::string, double> lengths_ = {};
  std::map<std::size_t, double> limits_ = {};  ///< the broken limits, by their order
};

}  // namespace

void advise_on_cam(const Input& input, Report& report) {
  CamAdvice(input).write(report);
}

}  // namespace jounce::design_detail

// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/peaks.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/input.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

double peak_of(const Input& input, std::size_t order) {
  return std::visit(
      [&](const auto& curve) {
        return std::abs(extrema(curve, static_cast<int>(order)).peak().value);
      },
      *input.curve);
}

/// The inputs of the given spec; empty if it makes no curve, because an optimization may begin with
/// an impossible spec.
std::vector<Input> given_inputs(const Spec& spec) {
  try {
    return inputs_of(spec, spec.document.name);
  } catch (const InputError&) {
    return {};
  }
}

/// The change as text: "-12.5 %", or "13 times" the given value.
std::string change(const PeakChange& peak) {
  if (!peak.given || !(*peak.given > 0)) return "";
  const double ratio = peak.optimized / *peak.given;
  return ratio >= 2 ? fmt::format("{:.3g} times", ratio)
                    : fmt::format("{:+.1f} %", 100 * (ratio - 1));
}

}  // namespace

std::vector<PeakChange> peak_changes(const Spec& given_spec, const Spec& optimized_spec) {
  const std::vector<Input> given = given_inputs(given_spec);
  const std::vector<Input> optimized = inputs_of(optimized_spec, optimized_spec.document.name);
  std::vector<PeakChange> all;
  for (std::size_t i = 0; i < optimized.size(); ++i) {
    const Input& axis = optimized[i];
    const Limits& l = axis.limits;
    const std::optional<double> limits[] = {{}, l.velocity, l.acceleration, l.jerk};
    const auto& names = axis.labels.over_master ? OverMaster::names : OverTime::names;
    for (std::size_t k = 1; k < names.size(); ++k)
      all.push_back({(axis.axis.empty() ? "" : axis.axis + " ") + names[k],
                     axis.labels.unit_of(names[k]),
                     given.empty() ? std::nullopt : std::optional(peak_of(given[i], k)),
                     peak_of(axis, k), limits[k]});
  }
  return all;
}

std::string peaks_text(const std::vector<PeakChange>& peaks) {
  std::string text = fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}\n", "peaks", "given",
                                 "optimized", "change", "limit");
  for (const PeakChange& peak : peaks)
    text += fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", peak.name,
                        peak.given ? rounded(*peak.given) : "-", rounded(peak.optimized),
                        change(peak), peak.limit ? rounded(*peak.limit) : "not limited", peak.unit);
  return text;
}

std::string peaks_json(const std::vector<PeakChange>& peaks) {
  using Json = nlohmann::ordered_json;
  const auto or_null = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  Json all = Json::array();
  for (const PeakChange& peak : peaks)
    all.push_back({{"quantity", peak.name},
                   {"unit", peak.unit},
                   {"given", or_null(peak.given)},
                   {"optimised", peak.optimized},
                   {"limit", or_null(peak.limit)}});
  return all.dump();
}

}  // namespace jounce

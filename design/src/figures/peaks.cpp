// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/peaks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/design/input.hpp"
#include "jounce/design/key_figures.hpp"
#include "jounce/profiles/error.hpp"

#include "design/src/check/master_check.hpp"

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

std::string changes_text(const char* title, const char* no_limit,
                         const std::vector<PeakChange>& changes) {
  std::string text = fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}\n", title, "given",
                                 "optimized", "change", "limit");
  for (const PeakChange& each : changes)
    text += fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", each.name,
                        each.given ? rounded(*each.given) : "-", rounded(each.optimized),
                        change(each), each.limit ? rounded(*each.limit) : no_limit, each.unit);
  return text;
}

/// The figures of a spec, without the peaks of peak_changes(); none if it cannot be assessed.
std::vector<KeyFigure> figures_of(const Spec& spec) {
  std::vector<KeyFigure> all;
  try {
    all = assess(spec).figures;
  } catch (const InputError&) {
    return {};
  }
  const auto& names = spec.over_master() ? OverMaster::names : OverTime::names;
  std::erase_if(all, [&](const KeyFigure& f) {
    return std::any_of(names.begin() + 1, names.end(), [&](const char* name) {
      return f.name.ends_with(std::string("peak ") + name);
    });
  });
  return all;
}

bool differ(double a, double b) {
  return std::abs(a - b) > 1e-3 * std::max(std::abs(a), std::abs(b));
}

/// A unit, and its size in the unit of a figure.
struct FigureUnit {
  std::string name;
  double size = 1;
};

/// The unit in which a cam's spec gives the master's speed, or the limit of a rate over time.
FigureUnit unit_of(const KeyFigure& figure, const Spec& spec) {
  if (!spec.over_master()) return {figure.unit};
  if (figure.name == "fastest master" || figure.name == "master velocity") {
    const SpeedUnit speed = master_speed_unit(spec);
    return {speed.name, speed.size};
  }
  for (int order = 1; order < 4; ++order) {
    const std::string name = OverTime::names[static_cast<std::size_t>(order)];
    if (figure.name != "peak " + name && figure.name != "rms " + name) continue;
    const std::string unit = slave_rate_unit(spec, order);
    return {unit, conversion(unit, figure.unit)};
  }
  return {figure.unit};
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

std::vector<PeakChange> other_changes(const Spec& given_spec, const Spec& optimized_spec) {
  const auto given = figures_of(given_spec);
  const auto optimized = figures_of(optimized_spec);
  std::vector<PeakChange> all;
  for (const KeyFigure& figure : optimized) {
    const auto before = std::find_if(given.begin(), given.end(),
                                     [&](const KeyFigure& f) { return f.name == figure.name; });
    if (before == given.end() || !differ(before->value, figure.value)) continue;
    const FigureUnit unit = unit_of(figure, optimized_spec);
    std::optional<double> limit = figure.limit;
    if (limit) *limit /= unit.size;
    all.push_back(
        {figure.name, unit.name, before->value / unit.size, figure.value / unit.size, limit});
  }
  return all;
}

std::string peaks_text(const std::vector<PeakChange>& peaks) {
  return changes_text("peaks", "not limited", peaks);
}

std::string others_text(const std::vector<PeakChange>& others) {
  return others.empty() ? "" : changes_text("other figures", "", others);
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
                   {"optimized", peak.optimized},
                   {"limit", or_null(peak.limit)}});
  return all.dump();
}

}  // namespace jounce

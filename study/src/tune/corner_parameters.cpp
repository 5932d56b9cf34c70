// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"
#include "jounce/study/spec_numbers.hpp"
#include "jounce/study/tune.hpp"

namespace jounce {

namespace {

constexpr std::size_t most_corners = 20;

std::vector<SpecParameter> corner_numbers(const Spec& spec) {
  const SpecNumbers numbers(spec.document);
  std::vector<SpecParameter> all;
  for (const auto& [key, unit] : spec.document.units) {
    if (key.find("corner.") == std::string::npos) continue;
    const std::string written = numbers.unit(key);
    const double value = numbers.value(key) * (written.empty() ? 1 : conversion(written, unit));
    all.push_back({key, unit, value / 100, value});
  }
  return all;
}

}  // namespace

bool has_corner_parameters(const Spec& spec) {
  const std::size_t count = corner_numbers(spec).size();
  return count > 0 && count <= most_corners;
}

ParametersSpec corner_parameters(const Spec& spec) {
  ParametersSpec chosen;
  chosen.figure = "duration";
  chosen.parameters = corner_numbers(spec);
  if (chosen.parameters.empty())
    throw spec.document.located(
        InputError("path", "",
                   "has no corner with a number: give corner = { deviation = ... }, or "
                   "[[optimize.parameter]]"));
  if (chosen.parameters.size() > most_corners)
    throw spec.document.located(InputError("path", std::to_string(chosen.parameters.size()),
                                           "corners are too many to choose, at most " +
                                               std::to_string(most_corners) +
                                               ": name some with [[optimize.parameter]]"));
  return chosen;
}

}  // namespace jounce

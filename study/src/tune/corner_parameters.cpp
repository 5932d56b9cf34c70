// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"
#include "jounce/study/spec_numbers.hpp"
#include "jounce/study/tune.hpp"

namespace jounce {

ParametersSpec corner_parameters(const Spec& spec) {
  constexpr std::size_t most = 20;
  const SpecNumbers numbers(spec.document);
  ParametersSpec chosen;
  chosen.figure = "duration";
  for (const auto& [key, unit] : spec.document.units) {
    if (key.find("corner.") == std::string::npos) continue;
    const std::string written = numbers.unit(key);
    const double value = numbers.value(key) * (written.empty() ? 1 : conversion(written, unit));
    chosen.parameters.push_back({key, unit, value / 100, value});
  }
  if (chosen.parameters.empty())
    throw spec.document.located(
        InputError("path", "",
                   "has no corner with a number: give corner = { deviation = ... }, or "
                   "[[optimize.parameter]]"));
  if (chosen.parameters.size() > most)
    throw spec.document.located(InputError("path", std::to_string(chosen.parameters.size()),
                                           "corners are too many to choose, at most " +
                                               std::to_string(most) +
                                               ": name some with [[optimize.parameter]]"));
  return chosen;
}

}  // namespace jounce

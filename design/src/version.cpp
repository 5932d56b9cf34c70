// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/version.hpp"

#include <vector>

#include "jounce/base/printable.hpp"

namespace jounce {

Version version_of(const Input& input, const std::string& path) {
  Version version{printable(path) + (input.axis.empty() ? "" : " " + input.axis), *input.curve,
                  input.labels};
  const auto breaks = std::visit(
      [](const auto& curve) {
        return std::vector<double>(curve.breaks().begin(), curve.breaks().end());
      },
      *input.curve);
  version.knots.push_back(breaks.front());
  version.knot_names.emplace_back(input.labels.segments.empty() ? "" : "start");
  for (const auto& [label, first, last] : groups(breaks.size() - 1, input.labels)) {
    version.knots.push_back(breaks[last + 1]);
    version.knot_names.push_back(input.labels.segments.empty() ? "" : "end of " + label);
  }
  if (input.spec) version.limits = input.limits;
  return version;
}

}  // namespace jounce

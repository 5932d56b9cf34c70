// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/sync_zones.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {

std::vector<SyncZone> sync_zones(const Input& input) {
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr || !input.zones.empty()) return input.zones;
  const auto& names = input.labels.segments;
  std::vector<SyncZone> zones;
  for (std::size_t i = 0; i < cam->segments().size(); ++i) {
    const Range v = segment_extrema(*cam, i)[1];
    const double peak = std::abs(v.peak().value);
    if (peak == 0 || v.max.value - v.min.value > profiles_detail::rounded_input * peak) continue;
    const std::string label = names.empty() ? "" : names[i];
    zones.push_back({cam->breaks()[i], cam->breaks()[i + 1],
                     label.substr(std::min(label.size(), label.find(' ') + 1))});
  }
  return zones;
}

}  // namespace jounce

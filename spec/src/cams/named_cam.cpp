// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/named_cam.hpp"

#include <utility>

#include "jounce/cam/design/boundaries.hpp"
#include "jounce/optimize/least_peak.hpp"

namespace jounce {

CamSpec filled(const CamSpec& cam, Boundaries rule) {
  switch (rule) {
    case Boundaries::minimum_jerk:
      return filled(cam, Fill::minimum_jerk);
    case Boundaries::minimum_peak_acceleration:
      return filled_for_least_peak(cam).cam;
    case Boundaries::rest:
      break;
  }
  return cam;
}

NamedCam named(const CamSpec& cam, Boundaries rule) {
  auto [curve, origin] = design(filled(cam, rule));
  std::vector<std::string> names;
  names.reserve(origin.size());
  for (const std::size_t i : origin) {
    const std::string& name = cam.segments[i].name;
    names.push_back(std::to_string(i + 1) + (name.empty() ? "" : " " + name));
  }
  return {std::move(curve), std::move(names)};
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_length_map.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr double resolution = 1e-13;  ///< relative resolution of a bisection

/// The place in [from, to] from which on `above` is true; it is true at `to` and false at `from`.
template <class Above>
double boundary(double from, double to, Above&& above) {
  while (to - from > resolution * to) {
    const double middle = from + (to - from) / 2;
    if (middle == from || middle == to) break;
    (above(middle) ? to : from) = middle;
  }
  return to;
}

CutSpeedOfLength speeds_of(const CamOfLength& cams, const CutLimits& limits) {
  return [&](double length) { return fastest_cut(cams, length, limits); };
}

}  // namespace

CutSpeed fastest_cut(const CamOfLength& cams, double length, const CutLimits& limits) {
  require_positive("length", length);
  if (!(limits.line_speed > 0))
    throw InputError("line_speed", limits.line_speed, "must be greater than 0");
  const std::optional<Cam> cam = cams(length);
  if (!cam) return {length, 0, "length", 0};
  const MasterLimit slave = greatest_master_velocity(*cam, limits.slave);
  if (slave.value < limits.line_speed) return {length, slave.value, slave.quantity, slave.where};
  const bool endless = std::isinf(limits.line_speed);
  return {length, limits.line_speed, endless ? "" : "line", 0};
}

std::vector<CutSpeed> cut_length_map(const CutSpeedOfLength& fastest,
                                     std::span<const double> lengths) {
  std::vector<CutSpeed> map;
  map.reserve(lengths.size());
  for (const double length : lengths) map.push_back(fastest(length));
  return map;
}

std::vector<CutSpeed> cut_length_map(const CamOfLength& cams, std::span<const double> lengths,
                                     const CutLimits& limits) {
  return cut_length_map(speeds_of(cams, limits), lengths);
}

std::vector<LimitChange> limit_changes(const CutSpeedOfLength& fastest,
                                       std::span<const CutSpeed> map) {
  std::vector<LimitChange> changes;
  for (std::size_t i = 0; i + 1 < map.size(); ++i) {
    double from = map[i].length;
    std::string before = map[i].limit;
    while (before != map[i + 1].limit) {  // one or more changes between two neighbors
      std::string after;
      const double at = boundary(from, map[i + 1].length, [&](double length) {
        const std::string limit = fastest(length).limit;
        if (limit == before) return false;
        after = limit;
        return true;
      });
      if (after.empty()) after = map[i + 1].limit;
      changes.push_back({at, before, after});
      before = after;
      from = at;
    }
  }
  return changes;
}

std::vector<LimitChange> limit_changes(const CamOfLength& cams, std::span<const CutSpeed> map,
                                       const CutLimits& limits) {
  return limit_changes(speeds_of(cams, limits), map);
}

std::optional<double> shortest_length(const CamOfLength& cams, const CutLimits& limits,
                                      double speed, double from, double to) {
  require_positive("speed", speed);
  const auto can = [&](double length) { return fastest_cut(cams, length, limits).speed >= speed; };
  if (!can(to)) return std::nullopt;
  if (can(from)) return from;
  return boundary(from, to, can);
}

}  // namespace jounce

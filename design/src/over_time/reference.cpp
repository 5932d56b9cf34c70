// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/reference.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/base/units.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/over_time/slave_motion.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

double seconds(const Input& input) {
  return conversion(input.table.units.x, "s");
}

}  // namespace

Trajectory master_of(const Input& input) {
  if (!input.spec)
    throw InputError("master", "",
                     "is missing: a cam table does not contain the motion of its master. Give the "
                     "spec of the cam, with [master]; `jounce stream` also takes the master as a "
                     "table over time (--master)")
        .at(input.name);
  return make_master(*input.spec);
}

Reference exact_reference(const Input& input) {
  if (const auto* cam = std::get_if<Cam>(&*input.curve)) return Followed(*cam, master_of(input));
  return scaled(std::get<Trajectory>(*input.curve), 1, seconds(input));
}

Reference table_reference(const Input& input) {
  if (std::holds_alternative<Cam>(*input.curve))
    return Followed(input.table.table.curve<OverMaster>(), master_of(input));
  return stretched(input.table.table, seconds(input)).curve<OverTime>();
}

Fitted<OverTime> design_detail::slave_motion(const Input& input) {
  const auto* cam = &std::get<Cam>(*input.curve);
  const Trajectory master = scaled(master_of(input), 1, 1 / seconds_per_unit(*input.spec));
  double size = 0;
  for (const Segment& each : cam->segments()) size = std::max(size, magnitude(each));
  const double turns = std::abs(cam->advance() * master.jet(master.end())[0] / cam->length());
  return composed_within(*cam, master, rounded_input * std::max(size, turns));
}

Trajectory motion_over_time(const Input& input) {
  if (std::holds_alternative<Cam>(*input.curve)) return design_detail::slave_motion(input).curve;
  return std::get<Trajectory>(*input.curve);
}

SignalView view(const Reference& reference) {
  return std::visit([](const auto& signal) { return SignalView(signal); }, reference);
}

double duration(const Reference& reference) {
  return std::visit([](const auto& signal) { return signal.end() - signal.start(); }, reference);
}

Motion at(const Reference& reference, double t) {
  return std::visit([&](const auto& signal) { return signal.at(signal.start() + t); }, reference);
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/input_look.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "jounce/design/detail/sync_zones.hpp"
#include "jounce/design/make.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

/// The ends of the segments of the spec. Ends of the pieces of a law are left out.
std::vector<double> knots(std::span<const double> breaks, const Labels& labels) {
  std::vector<double> all{breaks.front()};
  for (const auto& group : groups(breaks.size() - 1, labels)) all.push_back(breaks[group.last + 1]);
  return all;
}

/// The segments of a cam's spec, as reports call them, and their laws. A cam that is made from another has no laws of
/// its own.
std::vector<std::vector<Shade>> strips(std::span<const double> breaks, const Input& input) {
  if (!input.spec || !input.spec->is_cam()) return {};
  const auto* const knots = std::get_if<CamSpec>(&input.spec->subject);
  std::vector<Shade> names;
  std::vector<Shade> laws;
  for (const auto& group : groups(breaks.size() - 1, input.labels)) {
    if (knots != nullptr && names.size() == knots->segments.size()) break;
    const double from = breaks[group.first];
    const double to = breaks[group.last + 1];
    if (knots != nullptr) laws.push_back({from, to, name(knots->segments[names.size()].law)});
    names.push_back({from, to, group.label});
  }
  if (knots == nullptr) return {std::move(names)};
  return {std::move(names), std::move(laws)};
}

/// "4 start": "start". A name that is only a number stays.
std::string without_number(const std::string& label) {
  const std::size_t blank = label.find(' ');
  const bool has_number =
      blank != std::string::npos && label.find_first_not_of("0123456789") == blank;
  return has_number ? label.substr(blank + 1) : label;
}

/// The segments of a cam over time, without those in the shades, which have names of their own.
std::vector<Shade> names_beside(std::span<const double> breaks, const Labels& labels,
                                const std::vector<Shade>& shades) {
  std::vector<Shade> names;
  for (const auto& group : groups(breaks.size() - 1, labels)) {
    const double from = breaks[group.first];
    const double to = breaks[group.last + 1];
    const bool is_shaded = std::any_of(shades.begin(), shades.end(), [&](const Shade& shade) {
      return shade.from <= (from + to) / 2 && (from + to) / 2 <= shade.to;
    });
    if (!is_shaded) names.push_back({from, to, without_number(group.label)});
  }
  return names;
}

/// Adds [limits.slave] at the speed of [master] to the limits of a cam. A point of the cam breaks
/// them for sure only if the master passes the whole cam at this speed.
void add_slave_limits(const Input& input, CurveLook& look) {
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr || !input.spec || !input.spec->master || !(input.spec->master->velocity > 0))
    return;
  const Limits& slave = input.spec->slave;
  if (!slave.velocity && !slave.acceleration && !slave.jerk) return;
  const MasterSpec& master = *input.spec->master;
  look.limits = with_slave_limits(input.limits, *input.spec);
  look.x_note = "limits at " + master_speed_text(*input.spec);
  const bool passes_all =
      !master.acceleration && master.distance >= cam->length() * (1 - rounded_input);
  if (!passes_all) look.marked_limits = input.limits;
}

}  // namespace

CurveLook look_of(const Input& input) {
  CurveLook look{.title = input.name,
                 .axis_unit = input.labels.units.x,
                 .unit = input.labels.units.position,
                 .rate_units = input.rate_units,
                 .limits = input.limits};
  add_slave_limits(input, look);
  for (const SyncZone& zone : sync_zones(input))
    look.shades.push_back({zone.from, zone.to, zone.name});
  const auto breaks = std::visit([](const auto& curve) { return curve.breaks(); }, *input.curve);
  look.knots = knots(breaks, input.labels);
  look.strips = strips(breaks, input);
  if (!input.spec && !input.labels.over_master && !input.labels.segments.empty())
    look.names = names_beside(breaks, input.labels, look.shades);
  return look;
}

template <class Over>
Curve<Over> in_units_of(const Input& input, const Input& other, const Curve<Over>& curve) {
  const Version version = in_units({other.name, curve, other.labels}, input.labels.units);
  return std::get<Curve<Over>>(version.curve);
}

template Trajectory in_units_of(const Input&, const Input&, const Trajectory&);
template Cam in_units_of(const Input&, const Input&, const Cam&);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/input_figure.hpp"

#include <algorithm>
#include <utility>

#include "jounce/design/sync_zones.hpp"
#include "jounce/plot/curve_figure.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {
namespace {

/// The ends of the segments of the spec. Ends of the pieces of a law are left out.
std::vector<double> knots(std::span<const double> breaks, const Labels& labels) {
  std::vector<double> all{breaks.front()};
  for (const auto& group : groups(breaks.size() - 1, labels)) all.push_back(breaks[group.last + 1]);
  return all;
}

/// The segments of a cam's spec, as reports call them, and their laws.
std::vector<std::vector<Shade>> strips(std::span<const double> breaks, const Input& input) {
  if (!input.spec || !std::holds_alternative<CamSpec>(input.spec->subject)) return {};
  const auto& segments = std::get<CamSpec>(input.spec->subject).segments;
  std::vector<Shade> names;
  std::vector<Shade> laws;
  for (const auto& group : groups(breaks.size() - 1, input.labels)) {
    if (names.size() == segments.size()) break;
    const CamSegment& segment = segments[names.size()];
    names.push_back({breaks[group.first], breaks[group.last + 1], group.label});
    laws.push_back({breaks[group.first], breaks[group.last + 1], name(segment.law)});
  }
  return {std::move(names), std::move(laws)};
}

CurveLook look_of(const Input& input) {
  CurveLook look{.title = input.name,
                 .axis_unit = input.labels.units.x,
                 .unit = input.labels.units.position,
                 .rate_units = input.rate_units,
                 .limits = input.limits};
  for (const SyncZone& zone : sync_zones(input))
    look.shades.push_back({zone.from, zone.to, zone.name});
  const auto breaks = std::visit([](const auto& curve) { return curve.breaks(); }, *input.curve);
  look.knots = knots(breaks, input.labels);
  look.strips = strips(breaks, input);
  return look;
}

/// The curve of another input in the units of this one.
template <class Over>
Curve<Over> in_units_of(const Input& input, const Input& other, const Curve<Over>& curve) {
  const Version version = in_units({other.name, curve, other.labels}, input.labels.units);
  return std::get<Curve<Over>>(version.curve);
}

/// Adds what another axis does to a panel.
void add(Panel& panel, Panel other) {
  if (panel.lower != other.lower) panel.lower.reset();
  if (panel.upper != other.upper) panel.upper.reset();
  panel.noise = std::max(panel.noise, other.noise);
  for (Series& series : other.series) panel.series.push_back(std::move(series));
  for (Marker& marker : other.markers) panel.markers.push_back(std::move(marker));
}

Figure figure_of_axis(const Input& input) {
  CurveLook look = look_of(input);
  if (!input.axis.empty()) look.label = input.axis;
  return std::visit([&](const auto& curve) { return curve_figure(curve, look); }, *input.curve);
}

}  // namespace

Figure figure_of(const std::vector<Input>& axes) {
  Figure figure = figure_of_axis(axes.front());
  if (axes.size() == 1) return figure;
  if (axes.front().spec) figure.title = axes.front().spec->name;
  figure.knots.clear();  // each axis has its own
  for (std::size_t i = 1; i < axes.size(); ++i) {
    if (axes[i].labels.units.position != axes.front().labels.units.position)
      throw InputError("axis", "",
                       "is missing: " + axes.front().axis + " and " + axes[i].axis +
                           " have different units, so one picture cannot show both. Choose one");
    Figure other = figure_of_axis(axes[i]);
    for (std::size_t k = 0; k < figure.panels.size(); ++k)
      add(figure.panels[k], std::move(other.panels[k]));
  }
  for (Panel& panel : figure.panels)  // every axis rests at 0 somewhere: not worth a number each
    std::erase_if(panel.markers, [](const Marker& marker) { return marker.y == 0; });
  return figure;
}

Figure figure_of(const Input& input, const std::optional<Input>& before) {
  CurveLook look = look_of(input);
  if (!before)
    return std::visit([&](const auto& curve) { return curve_figure(curve, look); }, *input.curve);
  look.label = input.name;
  look.before = before->name == input.name ? "before" : before->name;
  return std::visit(
      [&]<class Over>(const Curve<Over>& curve) {
        const auto* other = std::get_if<Curve<Over>>(&*before->curve);
        if (other == nullptr)
          throw InputError(
              "before",
              before->table.provenance.spec.empty() ? before->name : before->table.provenance.spec,
              std::string("is over ") + (before->labels.over_master ? "a master" : "time") +
                  ", but " + input.name + " is over " +
                  (input.labels.over_master ? "a master" : "time") +
                  ": one picture cannot show both");
        return curve_figure(curve, in_units_of(input, *before, *other), look);
      },
      *input.curve);
}

Figure law_figure(Law law) {
  const auto rising = rising_laws();
  if (std::find(rising.begin(), rising.end(), law) == rising.end())
    throw InputError("law", info(law).name,
                     "has no shape to draw, because its points define it: choose another law");
  CurveLook look;
  look.title = info(law).title;
  look.label = info(law).name;
  return curve_figure(Cam(normalised(law, shown_form(law))), look);
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/input_figure.hpp"

#include <algorithm>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "plot/src/figure/curve_figure.hpp"
#include "plot/src/figure/input_look.hpp"

namespace jounce {
namespace {

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
                  ": draw both over time, with --over time");
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
  return curve_figure(Cam(normalized(law, shown_form(law))), look);
}

}  // namespace jounce

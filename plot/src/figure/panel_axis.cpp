// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "jounce/plot/label.hpp"

#include "plot/src/figure/panel.hpp"
#include "plot/src/figure/style.hpp"

namespace jounce {
namespace {

constexpr double panel_edge = 1e-9;        ///< share of the width
constexpr double padding = 17;             // px above and below the data, for a marker's number
constexpr double least_knot_distance = 4;  // px, on average

/// A limit is drawn to scale unless it makes the axis this much longer than the data need.
constexpr double most_stretch = 3;

PlotRange data_extent(const Panel& panel) {
  PlotRange data;
  for (const Series& series : panel.series)
    for (const double y : series.y) data.add(y);
  for (const Marker& marker : panel.markers) data.add(marker.y);
  return data;
}

/// Makes the axis show the limit, unless that is held by far. `flat`: the data are a constant.
bool include(PlotRange& axis, const PlotRange& data, bool flat, std::optional<double> limit,
             bool held) {
  if (!limit || !drawable(*limit)) return false;
  PlotRange longer = data;
  longer.add(*limit);
  if (held && !flat && longer.span() > most_stretch * data.span()) return false;
  axis.add(*limit);
  return true;
}

std::vector<std::string> off_scale(const Panel& panel, const PanelAxis& axis) {
  const auto in_scale = [&](double limit) {
    return short_number(limit / std::pow(10.0, axis.ticks.exponent));
  };
  const bool upper = panel.upper && !axis.upper;
  const bool lower = panel.lower && !axis.lower;
  if (upper && lower && *panel.lower == -*panel.upper)
    return {"limits ±" + in_scale(*panel.upper) + " off scale"};
  std::vector<std::string> notes;
  if (upper) notes.push_back("limit " + in_scale(*panel.upper) + " off scale");
  if (lower) notes.push_back("limit " + in_scale(*panel.lower) + " off scale");
  return notes;
}

}  // namespace

PanelAxis panel_axis(const Panel& panel, double height) {
  PanelAxis axis;
  const PlotRange data = data_extent(panel);
  const PlotRange shown = axis_extent(data, panel.noise);
  const bool flat = data.empty() || shown.lo != data.lo || shown.hi != data.hi;
  PlotRange extent = flat ? data : shown;
  axis.upper = include(extent, data, flat, panel.upper, data.hi <= panel.upper);
  axis.lower = include(extent, data, flat, panel.lower, data.lo >= panel.lower);
  extent = axis_extent(extent, panel.noise);
  const double room = padding * extent.span() / std::max(height - 2 * padding, 1.0);
  axis.extent = {extent.lo - room, extent.hi + room};
  const double middle = extent.lo + extent.span() / 2;
  // A constant does not determine a scale: its value is the only tick.
  if (flat && !axis.upper && !axis.lower) {
    axis.ticks = {{middle}, {short_number(middle)}, 0};
  } else {
    axis.ticks = ticks(axis.extent, std::max(2, static_cast<int>(height / 20)));
  }
  axis.notes = off_scale(panel, axis);
  return axis;
}

std::vector<std::string> line_labels(const Figure& figure) {
  std::vector<std::string> labels;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      if (series.style != Style::under &&
          std::find(labels.begin(), labels.end(), series.label) == labels.end())
        labels.push_back(series.label);
    }
  }
  return labels;
}

std::string series_class(const Series& series, const std::vector<std::string>& labels) {
  if (series.style == Style::under) return "under";
  const auto found = std::find(labels.begin(), labels.end(), series.label);
  const auto index = static_cast<int>(found - labels.begin()) % line_styles + 1;
  return fmt::format("{} l{}", series.style == Style::dots ? "dots" : "l", index);
}

std::vector<double> drawn_knots(const Figure& figure, const Scale& x) {
  std::vector<double> inside;
  const double edge = panel_edge * x.of.span();
  for (const double knot : figure.knots)
    if (knot > x.of.lo + edge && knot < x.of.hi - edge) inside.push_back(knot);
  const double room = x.at_hi - x.at_lo;
  if (static_cast<double>(inside.size()) * least_knot_distance > room) inside.clear();
  return inside;
}

std::string with_factor(const std::string& label, int exponent) {
  if (exponent == 0) return label;
  return fmt::format("{} (×{})", label, superscripts(fmt::format("10^{}", exponent)));
}

}  // namespace jounce

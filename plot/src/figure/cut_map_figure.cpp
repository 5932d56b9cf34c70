// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/cut_map_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

constexpr double just_before = 1e-9;  ///< share of a length

/// The map's points, and those at which a limit takes over or that are marked, ascending.
std::vector<CutSpeed> points_of(const CutMap& map) {
  std::vector<CutSpeed> all = map.speeds;
  const auto add = [&](double length) {
    if (length > all.front().length && length < map.speeds.back().length)
      all.push_back(map.cuts.fastest(length, map.limits));
  };
  for (const LimitChange& change : map.changes) {
    add(change.length * (1 - just_before));
    add(change.length);
  }
  for (const auto& mark : map.cuts.marks) add(mark.length);
  if (map.shortest) add(*map.shortest);
  std::sort(all.begin(), all.end(),
            [](const CutSpeed& a, const CutSpeed& b) { return a.length < b.length; });
  return all;
}

/// One line for each limit, colored and named by it, joined where the next limit binds.
std::vector<Series> lines_of(const std::vector<CutSpeed>& points, double per_minute, bool rate) {
  std::vector<Series> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CutSpeed& p = points[i];
    // Without a cut there is no line: the previous line gets a gap.
    const bool drawn = p.speed > 0 || all.empty();
    const std::string label = drawn ? limit_word(p.limit) : all.back().label;
    auto own = std::find_if(all.begin(), all.end(),
                            [&](const Series& series) { return series.label == label; });
    if (own == all.end()) own = all.insert(all.end(), {label, {}, {}, Style::line});
    const bool resumed = i > 0 && points[i - 1].limit != p.limit && !own->x.empty();
    if (resumed) {
      own->x.push_back(p.length);
      own->y.push_back(std::nan(""));
    }
    own->x.push_back(p.length);
    const double shown = p.speed > 0 ? p.speed : std::nan("");
    own->y.push_back(rate ? shown / p.length * per_minute : shown);
  }
  return all;
}

std::vector<Marker> markers_of(const CutMap& map) {
  std::vector<Marker> markers;
  const auto add = [&](double length, const std::string& name) {
    if (length < map.speeds.front().length || length > map.speeds.back().length) return;
    const CutSpeed at = map.cuts.fastest(length, map.limits);
    if (!std::isfinite(at.speed) || at.speed == 0) return;
    markers.push_back({length, at.speed, fmt::format("{} {}", name, rounded(length)),
                       fmt::format("{}: {} {}", name, number(length), map.spec.units.x)});
  };
  if (map.shortest) add(*map.shortest, fmt::format("shortest at {}:", rounded(map.running)));
  for (const auto& mark : map.cuts.marks) add(mark.length, mark.name);
  return markers;
}

/// The stretches in which each limit binds, for the strip above the panels.
std::vector<Shade> strip_of(const CutMap& map) {
  std::vector<Shade> strip;
  double from = map.speeds.front().length;
  std::string limit = map.speeds.front().limit;
  for (const LimitChange& change : map.changes) {
    strip.push_back({from, change.length, limit_word(limit)});
    from = change.length;
    limit = change.after;
  }
  strip.push_back({from, map.speeds.back().length, limit_word(limit)});
  return strip;
}

}  // namespace

Figure cut_map_figure(const CutMap& map) {
  const std::vector<CutSpeed> points = points_of(map);
  Figure figure;
  figure.title = map.spec.name.empty() ? map.spec.document.name : map.spec.name;
  figure.x_label = "cut length [" + map.spec.units.x + "]";
  figure.strips = {strip_of(map)};
  if (const double end = map.speeds.back().length; map.cuts.turns_back < end)
    figure.strips.push_back(
        {{std::max(map.cuts.turns_back, map.speeds.front().length), end, needs_dwell}});
  Panel speed;
  speed.y_label = "line speed [" + map.speed_unit() + "]";
  speed.series = lines_of(points, map.per_minute, false);
  speed.markers = markers_of(map);
  Panel rate;
  rate.y_label = "cuts [1/min]";
  rate.series = lines_of(points, map.per_minute, true);
  for (const auto& change : map.changes) figure.knots.push_back(change.length);
  figure.panels = {std::move(speed), std::move(rate)};
  return figure;
}

}  // namespace jounce

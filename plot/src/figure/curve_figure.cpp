// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/curve_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "plot/src/figure/input_look.hpp"

namespace jounce {
namespace {

using profiles_detail::one_rounding;
using profiles_detail::rounded_sum;

constexpr double steps = 1600;  // over the whole curve: two a pixel in a plot of 800 px
constexpr std::size_t most_broken = 8;

Segment derivative_of(Segment f, int order) {
  for (int k = 0; k < order; ++k) f = derivative(f);
  return f;
}

/// Appends the points of g, a segment from `start` to `end`: equal steps of at most `step`, and
/// where g' vanishes.
void append(Series& series, const Segment& g, double start, double end, double step) {
  const Segment slope = derivative(g);
  std::vector<double> s;
  const double flat = one_rounding * magnitude(g) / g.length;  // the same in extrema()
  if (flat > 0) roots(slope, flat, s);
  const bool straight = g.degree <= 1 && g.sines == 0;
  const int n = straight ? 1 : std::max(1, static_cast<int>(std::ceil(g.length / step)));
  for (int i = 0; i <= n; ++i) s.push_back(static_cast<double>(i) / n);
  std::sort(s.begin(), s.end());
  for (const double at : s) {
    series.x.push_back(at == 1 ? end : start + at * g.length);
    series.y.push_back(value(g, at));
  }
}

template <class Over>
Series line_of(const Curve<Over>& f, int order, const std::string& label, Style style) {
  Series series{label, {}, {}, style};
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    append(series, derivative_of(f.segments()[i], order), f.breaks()[i], f.breaks()[i + 1],
           f.length() / steps);
  }
  return series;
}

/// Rounding of the `order`th derivative: derivatives of a polynomial of degree d over
/// a length L grow with d / L each time, those of a sine with its angle / L. Slivers, whose
/// derivatives are rounding alone, do not count: they would flatten the rest.
template <class Over>
double noise_of(const Curve<Over>& f, int order) {
  double noise = 0;
  const double sliver = 1e-4 * f.length() / static_cast<double>(f.segments().size());
  for (const Segment& g : f.segments()) {
    if (g.length < sliver) continue;
    double growth = g.degree;
    for (int i = 0; i < g.sines; ++i)
      growth = std::max(growth, std::abs(g.sine[static_cast<std::size_t>(i)].angle));
    const double size = magnitude(g) - (order > 0 ? std::abs(g.c[0]) : 0);
    noise = std::max(noise, size * std::pow(growth / g.length, order));
  }
  return 16 * std::numeric_limits<double>::epsilon() * noise;
}

struct Band {
  std::optional<double> lower;
  std::optional<double> upper;

  [[nodiscard]] double excess(double value) const {
    const double over = upper ? value - *upper : 0;
    const double under = lower ? *lower - value : 0;
    return std::max({over, under, 0.0});
  }
  /// The rule of check(): a limit that is met exactly is met.
  [[nodiscard]] bool broken(double value) const {
    const double size =
        std::max({std::abs(value), std::abs(lower.value_or(0)), std::abs(upper.value_or(0))});
    return excess(value) > rounded_sum * size;
  }
};

Band band_of(const Limits& limits, int order) {
  if (order == 0) return {limits.position_min, limits.position_max};
  const auto rate = std::array{limits.velocity, limits.acceleration,
                               limits.jerk}[static_cast<std::size_t>(order) - 1];
  if (!rate) return {};
  return {-*rate, *rate};
}

/// The worst points of the segments that break the band, the worst first. A segment that is no
/// worse than the one before it was at its end (a plateau) is not marked again.
template <class Over>
std::vector<Extremum> broken_extrema(const Curve<Over>& f, int order, const Band& band,
                                     double noise) {
  const auto k = static_cast<std::size_t>(order);
  std::vector<Extremum> broken;
  for (std::size_t i = 0; i < f.segments().size() && (band.lower || band.upper); ++i) {
    const Range here = segment_extrema(f, i)[k];
    for (const Extremum& e : {here.max, here.min}) {
      const bool same = i > 0 && std::abs(f.jet(f.breaks()[i], Side::left)[k] - e.value) <= noise;
      if (band.broken(e.value) && !same) broken.push_back(e);
    }
  }
  std::stable_sort(broken.begin(), broken.end(), [&](const Extremum& a, const Extremum& b) {
    return band.excess(a.value) > band.excess(b.value);
  });
  broken.resize(std::min(broken.size(), most_broken));
  return broken;
}

/// The extrema of the whole curve, then what else is broken.
template <class Over>
std::vector<Extremum> extrema_to_mark(const Curve<Over>& f, int order, const Band& band,
                                      double noise) {
  const Range whole = extrema(f, order);
  std::vector<Extremum> marks{whole.max};
  if (whole.max.value - whole.min.value > noise) marks.push_back(whole.min);
  for (const Extremum& e : broken_extrema(f, order, band, noise)) {
    const bool known = std::any_of(marks.begin(), marks.end(), [&](const Extremum& m) {
      return m.where == e.where && m.value == e.value;
    });
    if (!known) marks.push_back(e);
  }
  return marks;
}

/// All values of a panel in a unit of this size.
Panel in_unit(Panel panel, double size) {
  if (panel.lower) *panel.lower /= size;
  if (panel.upper) *panel.upper /= size;
  panel.noise /= size;
  for (Marker& marker : panel.markers) marker.y /= size;
  for (Series& series : panel.series)
    for (double& y : series.y) y /= size;
  return panel;
}

template <class Over>
Panel panel_of(const Curve<Over>& f, const Curve<Over>* before, int order, const CurveLook& look) {
  const std::string name = Over::names[static_cast<std::size_t>(order)];
  const PanelUnit shown = panel_unit(look, order);
  const std::string unit = superscripts(shown.name);
  const std::string with_unit = unit.empty() ? "" : " " + unit;
  const std::string in_axis_unit = look.axis_unit.empty() ? "" : " " + look.axis_unit;
  const Band band = band_of(look.limits, order);
  Panel panel;
  panel.y_label = unit.empty() ? name : fmt::format("{} [{}]", name, unit);
  panel.lower = band.lower;
  panel.upper = band.upper;
  panel.noise = noise_of(f, order);
  const Band marked = band_of(look.marked_limits.value_or(look.limits), order);
  for (const Extremum& e : extrema_to_mark(f, order, marked, panel.noise)) {
    const double value = (std::abs(e.value) <= panel.noise ? 0 : e.value) / shown.size;
    panel.markers.push_back({e.where, e.value, short_number(value),
                             fmt::format("{} {}{} at {}{}", name, number(value), with_unit,
                                         number(e.where), in_axis_unit),
                             marked.broken(e.value), true});
  }
  panel.series.push_back(line_of(f, order, look.label, Style::line));
  if (before != nullptr) {
    panel.series.push_back(line_of(*before, order, look.before, Style::under));
    panel.noise = std::max(panel.noise, noise_of(*before, order));
  }
  return in_unit(std::move(panel), shown.size);
}

template <class Over>
Figure stacked_figure(const Curve<Over>& f, const Curve<Over>* before, const CurveLook& look) {
  require_valid(look.limits);
  const std::string axis = !look.axis.empty()               ? look.axis
                           : std::is_same_v<Over, OverTime> ? "time"
                                                            : "master";
  Figure figure;
  figure.title = look.title;
  figure.x_label = look.axis_unit.empty() ? axis : fmt::format("{} [{}]", axis, look.axis_unit);
  figure.x_note = look.x_note;
  figure.shades = look.shades;
  figure.names = look.names;
  figure.strips = look.strips;
  figure.knots = look.knots.value_or(std::vector<double>(f.breaks().begin(), f.breaks().end()));
  figure.degrees = look.axis_unit == "deg" || look.axis_unit == "°";
  for (int order = 0; order < 4; ++order) figure.panels.push_back(panel_of(f, before, order, look));
  return figure;
}

}  // namespace

PanelUnit panel_unit(const CurveLook& look, int order) {
  const std::string own = rate_unit(look.unit, look.axis_unit, order);
  if (order == 0) return {own};
  const std::string& other = look.rate_units[static_cast<std::size_t>(order) - 1];
  if (other.empty() || other == own) return {own};
  return {other, conversion(other, own)};
}

template <class Over>
Figure curve_figure(const Curve<Over>& f, const CurveLook& look) {
  return stacked_figure<Over>(f, nullptr, look);
}

template <class Over>
Figure curve_figure(const Curve<Over>& f, const Curve<Over>& before, const CurveLook& look) {
  return stacked_figure(f, &before, look);
}

#define JOUNCE_INSTANTIATE(Over)                                      \
  template Figure curve_figure(const Curve<Over>&, const CurveLook&); \
  template Figure curve_figure(const Curve<Over>&, const Curve<Over>&, const CurveLook&);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce

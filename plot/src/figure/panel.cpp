// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/panel.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jounce/plot/label.hpp"

#include "plot/src/figure/style.hpp"
#include "plot/src/figure/text.hpp"

namespace jounce {
namespace {

constexpr double text_height = 13;  // px, of a line in the small font
constexpr double dot_radius = 3;
constexpr double small_dot = 2;    // px, half of a point of a series
constexpr double least_lead = 14;  // px

/// The points of a series that can be drawn, in one run for each stretch without a gap.
std::vector<std::vector<Pixel>> runs(const Series& series, const Scale& x, const Scale& y) {
  assert(series.x.size() == series.y.size());
  std::vector<std::vector<Pixel>> out;
  bool gap = true;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const bool draw = drawable(series.x[i]) && drawable(series.y[i]);
    if (draw && gap) out.emplace_back();
    if (draw) out.back().push_back({x(series.x[i]), y(series.y[i])});
    gap = !draw;
  }
  for (auto& run : out) run = series.style == Style::dots ? aggregated(run) : thinned(run);
  return out;
}

std::string series_path(const Series& series, const std::vector<std::vector<Pixel>>& lines) {
  std::string d;
  for (const auto& line : lines) {
    if (series.style != Style::dots) {
      d += path_data(line);
    } else {
      for (const Pixel& p : line) d += path_data({&p, 1});
    }
  }
  return d;
}

std::string rectangle(const Rectangle& box) {
  return fmt::format("M{} {}V{}H{}V{}z", coordinate(box.left), coordinate(box.top),
                     coordinate(box.bottom), coordinate(box.right), coordinate(box.top));
}

/// One panel being drawn: what has been written, and what later labels must avoid.
class PanelDrawing {
 public:
  PanelDrawing(std::string& out, const Figure& figure, const Panel& panel, PanelAxis axis,
               const PanelPlace& at)
      : out_(out),
        figure_(figure),
        panel_(panel),
        axis_(std::move(axis)),
        at_(at),
        y_{axis_.extent, at.plot.bottom, at.plot.top},
        around_{at.plot, {}, {}} {}

  void draw() {
    shades();
    grid();
    limits();
    series();
    line("frame", rectangle(at_.plot));
    markers();
    limit_labels();
    header();
  }

 private:
  void line(const std::string& kind, const std::string& d) {
    if (!d.empty()) out_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, d);
  }

  void text(const std::string& kind, double x, double y, const std::string& content) {
    out_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, coordinate(x),
                        coordinate(y), escaped(content));
  }

  void shades() {
    for (const Shade& shade : figure_.shades) {
      const double from = std::max(std::min(shade.from, shade.to), at_.x.of.lo);
      const double to = std::min(std::max(shade.from, shade.to), at_.x.of.hi);
      if (!(from < to)) continue;
      const Rectangle box{at_.x(from), at_.shade_top, at_.x(to), at_.plot.bottom};
      out_ += fmt::format("<path class=\"zone\" d=\"{}\"><title>{}</title></path>\n",
                          rectangle(box), escaped(shade.label));
    }
  }

  void grid() {
    const Rectangle& plot = at_.plot;
    std::string d;
    for (std::size_t i = 0; i < axis_.ticks.at.size(); ++i) {
      const double y = y_(axis_.ticks.at[i]);
      d += fmt::format("M{} {}H{}", coordinate(plot.left), coordinate(y), coordinate(plot.right));
      text("soft end", plot.left - 6, y + 4, axis_.ticks.labels[i]);
    }
    line("grid", d);
    d.clear();
    for (const double knot : drawn_knots(figure_, at_.x)) {
      const double x = at_.x(knot);
      d += fmt::format("M{} {}V{}", coordinate(x), coordinate(plot.top), coordinate(plot.bottom));
    }
    line("knot", d);
  }

  void limits() {
    const Rectangle& plot = at_.plot;
    if (axis_.upper) limit(*panel_.upper, {plot.left, plot.top, plot.right, y_(*panel_.upper)});
    if (axis_.lower) limit(*panel_.lower, {plot.left, y_(*panel_.lower), plot.right, plot.bottom});
  }

  void limit(double value, const Rectangle& beyond) {
    const double y = y_(value);
    line("over", rectangle(beyond));
    line("lim", path_data(std::array{Pixel{beyond.left, y}, Pixel{beyond.right, y}}));
    around_.lines.push_back({{beyond.left, y}, {beyond.right, y}});
  }

  void series() {
    const auto labels = line_labels(figure_);
    for (const bool under : {true, false}) {
      for (const Series& one : panel_.series) {
        if ((one.style == Style::under) != under) continue;
        const auto lines = runs(one, at_.x, y_);
        line(series_class(one, labels), series_path(one, lines));
        if (!under) avoid(lines, one.style == Style::dots);
      }
    }
  }

  /// Makes later labels avoid the lines, or the points of dots, between which nothing is drawn.
  void avoid(const std::vector<std::vector<Pixel>>& lines, bool dots) {
    for (const auto& run : lines) {
      if (!dots) around_.lines.push_back(run);
      for (const Pixel& p : run)
        if (dots)
          around_.lines.push_back(
              {{p.x - small_dot, p.y - small_dot}, {p.x + small_dot, p.y + small_dot}});
    }
  }

  void markers() {
    const auto visible = [](const Marker& m) { return drawable(m.x) && drawable(m.y); };
    for (const Marker& marker : panel_.markers)
      if (visible(marker)) around_.taken.push_back(dot(marker));
    for (const Marker& marker : panel_.markers)
      if (visible(marker)) draw(marker);
  }

  [[nodiscard]] Rectangle dot(const Marker& marker) const {
    const double x = at_.x(marker.x);
    const double y = y_(marker.y);
    return {x - dot_radius, y - dot_radius, x + dot_radius, y + dot_radius};
  }

  /// A circle; beyond a limit a full diamond, so that it differs not by color alone.
  void draw(const Marker& marker) {
    const double x = at_.x(marker.x);
    const double y = y_(marker.y);
    const std::string hint =
        marker.hint.empty() ? "" : fmt::format("<title>{}</title>", escaped(marker.hint));
    if (marker.text_only) {
      // the series draws the point
    } else if (marker.broken) {
      out_ += fmt::format("<path class=\"badmark\" d=\"M{} {}l4 4-4 4-4-4z\">{}</path>\n",
                          coordinate(x), coordinate(y - 4), hint);
    } else {
      out_ += fmt::format("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"2.5\">{}</circle>\n",
                          coordinate(x), coordinate(y), hint);
    }
    const std::string words = marker.is_value ? in_scale(marker.y) : marker.text;
    const std::string kind = marker.broken ? "halo bad" : "halo";
    // A text beside its marker; where it would cover a line, farther away.
    std::vector<Rectangle> boxes;
    for (const double away : {0.0, 14.0, 28.0, 42.0})
      for (const Rectangle& box : beside(marker, words, away)) boxes.push_back(box);
    if (const auto box = label(words, kind, boxes)) lead(*box, {x, y});
  }

  /// A thin line from a text to its point, if they are not side by side.
  void lead(const Rectangle& box, Pixel point) {
    const Pixel from{std::clamp(point.x, box.left, box.right),
                     std::clamp(point.y, box.top, box.bottom)};
    const double length = std::hypot(point.x - from.x, point.y - from.y);
    if (length < least_lead) return;
    const double share = 1 - (dot_radius + 1) / length;
    line("frame", path_data(std::array{from, Pixel{from.x + share * (point.x - from.x),
                                                   from.y + share * (point.y - from.y)}}));
  }

  /// A value as the ticks of the axis show it: without their factor.
  [[nodiscard]] std::string in_scale(double value) const {
    return short_number((std::abs(value) <= panel_.noise ? 0 : value) /
                        std::pow(10.0, axis_.ticks.exponent));
  }

  /// Boxes for a marker's text, `away` px from touching it; outwards from the middle of the plot
  /// first.
  [[nodiscard]] std::vector<Rectangle> beside(const Marker& marker, const std::string& words,
                                              double away) const {
    const Rectangle spot = dot(marker);
    const double width = text_width(words, small_font);
    const double x = at_.x(marker.x);
    const double level = y_(marker.y) - text_height / 2;
    const double above = spot.top - text_height - 1 - away;
    const double below = spot.bottom + 1 + away;
    const bool up = y_(marker.y) <= (at_.plot.top + at_.plot.bottom) / 2;
    const double first = at_.plot.left + 3;
    const double last = std::max(first, at_.plot.right - 3 - width);
    std::vector<Rectangle> boxes;
    for (const double top : {up ? above : below, level, up ? below : above}) {
      for (const double left :
           {x - width / 2, spot.right + 3 + away, spot.left - 3 - away - width}) {
        const double inside = std::clamp(left, first, last);
        boxes.push_back({inside, top, inside + width, top + text_height});
      }
    }
    return boxes;
  }

  void limit_labels() {
    if (axis_.upper) limit_label(*panel_.upper, true);
    if (axis_.lower) limit_label(*panel_.lower, false);
  }

  void limit_label(double value, bool upper) {
    const std::string words = "limit " + in_scale(value);
    const double width = text_width(words, small_font);
    const double y = y_(value);
    const double above = y - text_height - 1;
    std::vector<Rectangle> boxes;
    for (const double top : {upper ? above : y + 1, upper ? y + 1 : above}) {
      for (const double along : {1.0, 0.0, 0.75, 0.25, 0.5, 0.875, 0.125, 0.625, 0.375}) {
        const double left =
            at_.plot.left + 5 + along * (at_.plot.right - at_.plot.left - 10 - width);
        boxes.push_back({left, top, left + width, top + text_height});
      }
    }
    if (!label(words, "halo limtext", boxes)) axis_.notes.push_back(words);
  }

  /// Writes words into one of the boxes, which it returns; nullopt if none has space.
  std::optional<Rectangle> label(const std::string& words, const std::string& kind,
                                 const std::vector<Rectangle>& boxes) {
    const auto chosen = words.empty() ? std::nullopt : place(around_, boxes);
    if (!chosen) return std::nullopt;
    const Rectangle& box = boxes[*chosen];
    around_.taken.push_back(box);
    text(kind + " mid", (box.left + box.right) / 2, box.bottom - 3, words);
    return box;
  }

  void header() {
    const Rectangle& plot = at_.plot;
    const double y = at_.shade_top - 7;
    const double room = plot.right - plot.left;
    const std::string words =
        fitted(with_factor(superscripts(panel_.y_label), axis_.ticks.exponent), label_font, room);
    text("label", plot.left, y, words);
    std::string notes;
    for (const std::string& note : axis_.notes) notes += (notes.empty() ? "" : " · ") + note;
    const double left = room - text_width(words, label_font) - 12;
    if (!notes.empty() && left > 0)
      text("soft end", plot.right, y, fitted(notes, small_font, left));
  }

  std::string& out_;
  const Figure& figure_;
  const Panel& panel_;
  PanelAxis axis_;
  const PanelPlace& at_;
  Scale y_;
  Surroundings around_;
};

}  // namespace

void draw_panel(std::string& out, const Figure& figure, const Panel& panel, PanelAxis axis,
                const PanelPlace& at) {
  PanelDrawing(out, figure, panel, std::move(axis), at).draw();
}

}  // namespace jounce

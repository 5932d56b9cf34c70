// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/path_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jounce/plot/label.hpp"

#include "plot/src/figure/panel.hpp"
#include "plot/src/figure/path.hpp"
#include "plot/src/figure/placing.hpp"
#include "plot/src/figure/style.hpp"
#include "plot/src/figure/text.hpp"
#include "plot/src/figure/ticks.hpp"

namespace jounce {
namespace {

constexpr double edge = 12;            // px, around everything
constexpr double heading = 26;         // px, of the title
constexpr double below = 42;           // px, for the labels of the x axis
constexpr double bar_width = 14;       // px, of the scale of colors
constexpr double bar_space = 96;       // px, right of the plot
constexpr double tallest = 640;        // px
constexpr double shortest_side = 80;   // px
constexpr double shortest_line = 0.2;  // px
constexpr double label_height = 10;    // px
constexpr double near_label = 14;      // px: a label that is farther from its ring has a line to it
constexpr std::size_t colors = 16;
constexpr const char* rapid_path =
    "<path class=\"speed\" style=\"stroke-width:.8\" stroke=\"#9aa0a6\" d=\"{}\"/>\n";

/// From slow to fast. Okabe and Ito's vermilion, orange, green and blue, between which a color is mixed.
std::string color_of(std::size_t bin) {
  constexpr std::array<std::array<double, 3>, 4> knots{
      {{213, 94, 0}, {230, 159, 0}, {0, 158, 115}, {0, 114, 178}}};
  const double at = 3.0 * static_cast<double>(bin) / static_cast<double>(colors - 1);
  const auto k = std::min<std::size_t>(2, static_cast<std::size_t>(at));
  const double share = at - static_cast<double>(k);
  std::string text = "#";
  for (std::size_t c = 0; c < 3; ++c)
    text +=
        fmt::format("{:02x}", std::lround(knots[k][c] + share * (knots[k + 1][c] - knots[k][c])));
  return text;
}

/// The plot's frame, and the scale of both axes.
struct PlotFrame {
  PlotRange x, y;
  double left = 0, top = 0, width = 0, height = 0;

  [[nodiscard]] Pixel operator()(double px, double py) const {
    return {left + (px - x.lo) / x.span() * width, top + (y.hi - py) / y.span() * height};
  }
};

/// Adds a part of the span on both sides, and widens to `least`.
PlotRange widened(PlotRange range, double least) {
  const double more = std::max(0.04 * range.span(), (least - range.span()) / 2);
  return {range.lo - more, range.hi + more};
}

/// True if the line that ends at point i is a rapid.
bool is_rapid(const PathFigure& figure, std::size_t i) {
  return !figure.rapid.empty() && figure.rapid[i];
}

PlotFrame frame_of(const PathFigure& figure, const SvgOptions& options) {
  PlotRange x;
  PlotRange y;
  for (std::size_t i = 1; i < figure.x.size(); ++i) {
    if (is_rapid(figure, i)) continue;
    for (const std::size_t end : {i - 1, i}) {
      x.add(figure.x[end]);
      y.add(figure.y[end]);
    }
  }
  PlotFrame frame;
  frame.left = edge + 56;
  frame.top = edge + (figure.title.empty() ? 0 : heading);
  frame.width = options.width - frame.left - bar_space - edge;
  const double largest = std::max(x.span(), y.span());
  frame.x = widened(x, largest > 0 ? 0 : 1);
  frame.y = widened(y, frame.x.span() * shortest_side / frame.width);
  frame.x = widened(x, frame.y.span() * frame.width / tallest);
  frame.height = frame.width * frame.y.span() / frame.x.span();
  return frame;
}

void write(std::string& out, const char* kind, double x, double y, const std::string& content) {
  out += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, coordinate(x),
                     coordinate(y), escaped(content));
}

void draw_frame(std::string& out, const PathFigure& figure, const PlotFrame& frame) {
  const Ticks across = ticks(frame.x, 8);
  const Ticks up = ticks(frame.y, std::max(4, static_cast<int>(frame.height / 60)));
  std::string grid;
  const double bottom = frame.top + frame.height;
  for (const double at : across.at)
    grid += fmt::format("M{} {}v{}", coordinate(frame(at, 0).x), coordinate(frame.top),
                        coordinate(frame.height));
  for (const double at : up.at)
    grid += fmt::format("M{} {}h{}", coordinate(frame.left), coordinate(frame(0, at).y),
                        coordinate(frame.width));
  out += "<path class=\"grid\" d=\"" + grid + "\"/>\n";
  out += fmt::format("<path class=\"frame\" d=\"M{} {}h{}v{}h-{}z\"/>\n", coordinate(frame.left),
                     coordinate(frame.top), coordinate(frame.width), coordinate(frame.height),
                     coordinate(frame.width));
  for (std::size_t i = 0; i < across.at.size(); ++i)
    write(out, "soft mid", frame(across.at[i], 0).x, bottom + 16, across.labels[i]);
  for (std::size_t i = 0; i < up.at.size(); ++i)
    write(out, "soft end", frame.left - 6, frame(0, up.at[i]).y + 4, up.labels[i]);
  write(out, "label mid", frame.left + frame.width / 2, bottom + 34,
        with_factor(superscripts(figure.x_label), across.exponent));
  const double middle = frame.top + frame.height / 2;
  out += fmt::format(
      "<text class=\"label mid\" transform=\"translate({} {}) rotate(-90)\">{}</text>\n",
      coordinate(edge + 8), coordinate(middle),
      escaped(with_factor(superscripts(figure.y_label), up.exponent)));
}

std::size_t bin_of(double speed, double fastest) {
  const double at = fastest > 0 ? speed / fastest * static_cast<double>(colors) : 0;
  return std::min(colors - 1, static_cast<std::size_t>(std::max(0.0, at)));
}

/// The part of a line inside the frame (Liang and Barsky, 1984); nullopt: none.
std::optional<std::pair<Pixel, Pixel>> clipped(Pixel a, Pixel b, const PlotFrame& frame) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double first = 0;
  double last = 1;
  for (const auto& [direction, distance] :
       {std::pair{-dx, a.x - frame.left}, std::pair{dx, frame.left + frame.width - a.x},
        std::pair{-dy, a.y - frame.top}, std::pair{dy, frame.top + frame.height - a.y}}) {
    if (direction == 0 && distance < 0) return std::nullopt;
    if (direction < 0) first = std::max(first, distance / direction);
    if (direction > 0) last = std::min(last, distance / direction);
  }
  if (first > last) return std::nullopt;
  return std::pair{Pixel{a.x + first * dx, a.y + first * dy},
                   Pixel{a.x + last * dx, a.y + last * dy}};
}

/// The rapids, below the other lines.
void draw_rapids(std::string& out, const PathFigure& figure, const PlotFrame& frame) {
  std::string data;
  for (std::size_t i = 1; i < figure.x.size(); ++i) {
    if (!is_rapid(figure, i)) continue;
    const auto line =
        clipped(frame(figure.x[i - 1], figure.y[i - 1]), frame(figure.x[i], figure.y[i]), frame);
    if (line) data += path_data(std::array{line->first, line->second});
  }
  if (!data.empty()) out += fmt::format(rapid_path, data);
}

/// One element for each color: the lines between the points, by their mean speed.
void draw_path(std::string& out, const PathFigure& figure, const PlotFrame& frame, double fastest) {
  std::array<std::string, colors> data;
  std::vector<Pixel> line;
  std::size_t bin = 0;
  const auto finish = [&] {
    if (line.size() > 1) data[bin] += path_data(thinned(line));
    line.clear();
  };
  std::size_t from = 0;
  for (std::size_t i = 1; i < figure.x.size(); ++i) {
    const Pixel start = frame(figure.x[from], figure.y[from]);
    const Pixel end = frame(figure.x[i], figure.y[i]);
    const bool last = i + 1 == figure.x.size() || is_rapid(figure, i + 1);
    if (is_rapid(figure, i)) {
      finish();
      from = i;
      continue;
    }
    if (!last && std::hypot(end.x - start.x, end.y - start.y) < shortest_line) continue;
    const std::size_t now = bin_of((figure.speed[from] + figure.speed[i]) / 2, fastest);
    if (line.empty() || now != bin) {
      finish();
      bin = now;
      line.push_back(start);
    }
    line.push_back(end);
    from = i;
  }
  finish();
  for (std::size_t k = 0; k < colors; ++k)
    if (!data[k].empty())
      out += fmt::format(
          "<path class=\"speed\" "
          "style=\"stroke-width:2;stroke-linejoin:round;stroke-linecap:round\" "
          "stroke=\"{}\" d=\"{}\"/>\n",
          color_of(k), data[k]);
}

void draw_scale(std::string& out, const PathFigure& figure, const PlotFrame& frame,
                double fastest) {
  const double left = frame.left + frame.width + 20;
  const double height = std::min(frame.height, 240.0);
  const double step = height / static_cast<double>(colors);
  for (std::size_t k = 0; k < colors; ++k)
    out += fmt::format("<rect fill=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                       color_of(k), coordinate(left),
                       coordinate(frame.top + height - static_cast<double>(k + 1) * step),
                       coordinate(bar_width), coordinate(step + 0.3));
  const Ticks marks =
      ticks({0, fastest > 0 ? fastest : 1}, std::max(2, static_cast<int>(height / 40)));
  for (std::size_t i = 0; i < marks.at.size(); ++i)
    write(out, "soft", left + bar_width + 5,
          frame.top + height * (1 - marks.at[i] / (fastest > 0 ? fastest : 1)) + 4,
          marks.labels[i]);
  const std::string label = with_factor(superscripts(figure.speed_label), marks.exponent);
  out += fmt::format(
      "<text class=\"label mid\" transform=\"translate({} {}) rotate(-90)\">{}</text>\n",
      coordinate(left + bar_width + 58), coordinate(frame.top + height / 2), escaped(label));
  if (figure.rapid.empty()) return;
  const double below_scale = frame.top + height + 20;
  out += fmt::format(rapid_path, path_data(std::array{Pixel{left, below_scale},
                                                      Pixel{left + bar_width, below_scale}}));
  write(out, "soft", left + bar_width + 5, below_scale + 4, "rapid");
}

/// Places of a label from its ring, px, the nearest first.
std::vector<Pixel> label_places() {
  std::vector<Pixel> places;
  for (int far = 0; far < 20; ++far)
    for (const double dy : {-5.0 - 14 * far, 13.0 + 14 * far})
      for (const double dx : {7.0, -7.0}) places.push_back({dx, dy});
  return places;
}

/// The box of a label whose text begins, or ends (`flips`), at a place.
Rectangle box_of(Pixel at, double width, bool flips) {
  return {flips ? at.x - width : at.x, at.y - label_height, flips ? at.x : at.x + width, at.y + 3};
}

/// Places the labels of the marks: beside their ring, or farther above or below it. No label covers
/// another label or a ring.
void draw_marks(std::string& out, const PathFigure& figure, const PlotFrame& frame) {
  const Rectangle inside{frame.left, frame.top, frame.left + frame.width, frame.top + frame.height};
  std::vector<Rectangle> taken;
  std::vector<std::pair<Pixel, std::string>> marks;
  for (const PathFigure::Mark& mark : figure.marks) {
    const Pixel at = frame(mark.x, mark.y);
    if (!clipped(at, at, frame)) continue;  // on a rapid
    out += fmt::format("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"3\"/>\n", coordinate(at.x),
                       coordinate(at.y));
    taken.push_back({at.x - 4, at.y - 4, at.x + 4, at.y + 4});
    marks.emplace_back(at, mark.text);
  }
  for (const auto& [at, text] : marks) {
    const double width = text_width(text, 11);
    for (const auto& [dx, dy] : label_places()) {
      const Pixel start{at.x + dx, at.y + dy};
      const Rectangle box = box_of(start, width, dx < 0);
      const bool fits = box.left >= inside.left && box.right <= inside.right &&
                        box.top >= inside.top && box.bottom <= inside.bottom;
      if (!fits || std::any_of(taken.begin(), taken.end(),
                               [&](const Rectangle& other) { return overlap(box, other); }))
        continue;
      taken.push_back(box);
      if (std::abs(dy) > near_label) {
        const double end = dy < 0 ? box.bottom : box.top;
        out += fmt::format(rapid_path, path_data(std::array{at, Pixel{start.x, end}}));
      }
      write(out, dx < 0 ? "halo end" : "halo", start.x, start.y, text);
      break;
    }
  }
}

}  // namespace

std::string svg(const PathFigure& figure, const SvgOptions& options) {
  const PlotFrame frame = frame_of(figure, options);
  const double height = frame.top + frame.height + below;
  const double fastest = *std::max_element(figure.speed.begin(), figure.speed.end());
  const std::string size = options.inlined
                               ? ""
                               : fmt::format(R"( width="{}" height="{}")",
                                             coordinate(options.width), coordinate(height));
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"jf\"{} viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-label=\"{}\">\n",
      size, coordinate(options.width), coordinate(height),
      escaped(figure.title.empty() ? "path" : figure.title));
  if (!options.inlined) {
    out += "<style>" + figure_style() + "</style>\n";
    out += fmt::format("<path class=\"paper\" d=\"M0 0h{}v{}H0z\"/>\n", coordinate(options.width),
                       coordinate(height));
  }
  if (!figure.title.empty())
    write(out, "title", frame.left, edge + 14,
          fitted(figure.title, 1.06 * title_font, frame.width + bar_space));
  draw_frame(out, figure, frame);
  draw_rapids(out, figure, frame);
  draw_path(out, figure, frame, fastest);
  draw_scale(out, figure, frame, fastest);
  draw_marks(out, figure, frame);
  return out + "</svg>\n";
}

}  // namespace jounce

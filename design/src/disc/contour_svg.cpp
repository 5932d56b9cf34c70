// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "jounce/design/disc.hpp"

namespace jounce {
namespace {

/// The bounding rectangle of the drawing, mm.
struct DrawingFrame {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;

  void add(Place p, double around) {
    left = std::min(left, p.x - around);
    right = std::max(right, p.x + around);
    bottom = std::min(bottom, p.y - around);
    top = std::max(top, p.y + around);
  }
};

DrawingFrame frame_of(const DiscDrawing& d) {
  DrawingFrame frame;
  frame.add({}, std::max(d.base_radius, d.hub_radius.value_or(0)));
  frame.add(d.roller, d.roller_radius);
  if (d.pivot) frame.add(*d.pivot, 3);
  for (const Contour* c : {&d.profile, &d.pitch, &d.cutter})
    for (std::size_t i = 0; i < c->size(); ++i) {
      const Vertex& a = (*c)[i];
      const Vertex& b = (*c)[(i + 1) % c->size()];
      frame.add({a.x, a.y}, std::abs(a.bulge) * std::hypot(b.x - a.x, b.y - a.y) / 2);
    }
  constexpr double margin = 5;
  return {frame.left - margin, frame.right + margin, frame.bottom - margin, frame.top + margin};
}

std::string mm(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string path(const char* style, const Contour& contour) {
  if (contour.empty()) return "";
  std::string d = "M" + mm(contour[0].x) + " " + mm(contour[0].y);
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vertex& a = contour[i];
    const Vertex& b = contour[(i + 1) % contour.size()];
    const double chord = std::hypot(b.x - a.x, b.y - a.y);
    if (a.bulge == 0) {
      d += "L";
    } else {
      const std::string r = mm(chord * (1 + a.bulge * a.bulge) / (4 * std::abs(a.bulge)));
      d += "A" + r + " " + r + " 0 0 " + (a.bulge > 0 ? "1 " : "0 ");
    }
    d += mm(b.x) + " " + mm(b.y);
  }
  return fmt::format("<path class=\"{}\" d=\"{}Z\"/>\n", style, d);
}

std::string svg_circle(const char* style, Place center, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style, mm(center.x),
                     mm(center.y), mm(radius));
}

std::string svg_line(const char* style, Place from, Place to) {
  return fmt::format("<path class=\"{}\" d=\"M{} {}L{} {}\"/>\n", style, mm(from.x), mm(from.y),
                     mm(to.x), mm(to.y));
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

/// Line widths in mm, for printing. The colors are light or dark as the viewer prefers.
constexpr const char* style_sheet =
    "<style>path,circle{fill:none;stroke:#222;stroke-width:.15}"
    ".cam{stroke-width:.5;fill:#8883}.pitch{stroke:#1a7f37;stroke-dasharray:4 1 .5 1}"
    ".cutter{stroke:#8250df;stroke-dasharray:2 1}.base{stroke:#0969da;stroke-dasharray:2 1}"
    ".hub{stroke-width:.25}.roller{stroke:#bc4c00;stroke-width:.35}.arm{stroke:#bc4c00}"
    "@media(prefers-color-scheme:dark){path,circle{stroke:#ddd}.pitch{stroke:#3fb950}"
    ".cutter{stroke:#a371f7}.base{stroke:#58a6ff}.roller,.arm{stroke:#f0883e}}</style>\n";

}  // namespace

std::string contour_svg(const DiscDrawing& d) {
  const DrawingFrame f = frame_of(d);
  const std::string width = mm(f.right - f.left);
  const std::string height = mm(f.top - f.bottom);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} "
      "{3} "
      "{0} {1}\">\n<title>{4}</title>\n",
      width, height, mm(f.left), mm(-f.top), escaped(d.name));
  out += style_sheet;
  out += "<g transform=\"scale(1,-1)\">\n";  // y points upwards, as in the DXF
  out += path("cam", d.profile) + path("pitch", d.pitch) + path("cutter", d.cutter);
  out += svg_circle("base", {}, d.base_radius);
  if (d.hub_radius) out += svg_circle("hub", {}, *d.hub_radius);
  out += svg_line("center", {-3, 0}, {3, 0}) + svg_line("center", {0, -3}, {0, 3});
  if (d.roller_radius > 0) out += svg_circle("roller", d.roller, d.roller_radius);
  if (d.pivot) out += svg_circle("arm", *d.pivot, 1.5) + svg_line("arm", *d.pivot, d.roller);
  return out + "</g>\n</svg>\n";
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "jounce/design/disc.hpp"

// DXF consists of pairs of lines: a group code and its value (Autodesk, "DXF Reference"). Every
// program reads release 12; its polylines are POLYLINE, VERTEX ..., SEQEND. $INSUNITS is newer;
// older readers ignore it.

namespace jounce {
namespace {

struct Layer {
  const char* name;
  int color;  ///< AutoCAD color index
};
constexpr std::array layers{Layer{"CAM", 7},  Layer{"PITCH", 3},  Layer{"CUTTER", 6},
                            Layer{"BASE", 5}, Layer{"ROLLER", 2}, Layer{"HUB", 1}};

template <class Value>
void pair(std::string& out, int code, const Value& value) {
  out += fmt::format("{}\n{}\n", code, value);
}

void real(std::string& out, int code, double value) {
  const std::string text = fmt::format("{:.9f}", value);
  pair(out, code, text == "-0.000000000" ? "0.000000000" : text);
}

void point(std::string& out, double x, double y) {
  real(out, 10, x);
  real(out, 20, y);
  real(out, 30, 0);
}

/// The greatest distance from the center to any point of the drawing, arcs included.
double reach(const DiscDrawing& d) {
  double r = std::hypot(d.roller.x, d.roller.y) + d.roller_radius;
  for (const Contour* c : {&d.profile, &d.pitch, &d.cutter})
    for (std::size_t i = 0; i < c->size(); ++i) {
      const Vertex& a = (*c)[i];
      const Vertex& b = (*c)[(i + 1) % c->size()];
      const double sagitta = std::abs(a.bulge) * std::hypot(b.x - a.x, b.y - a.y) / 2;
      r = std::max(r, std::hypot(a.x, a.y) + sagitta);
    }
  return std::max({r, d.base_radius, d.hub_radius.value_or(0)});
}

void header(std::string& out, const DiscDrawing& d) {
  const double r = reach(d);
  pair(out, 0, "SECTION"), pair(out, 2, "HEADER");
  pair(out, 9, "$ACADVER"), pair(out, 1, "AC1009");
  pair(out, 9, "$INSUNITS"), pair(out, 70, 4);  // mm
  pair(out, 9, "$MEASUREMENT"), pair(out, 70, 1);
  pair(out, 9, "$EXTMIN"), point(out, -r, -r);
  pair(out, 9, "$EXTMAX"), point(out, r, r);
  pair(out, 0, "ENDSEC");
}

void tables(std::string& out) {
  pair(out, 0, "SECTION"), pair(out, 2, "TABLES");
  pair(out, 0, "TABLE"), pair(out, 2, "LTYPE"), pair(out, 70, 1);
  pair(out, 0, "LTYPE"), pair(out, 2, "CONTINUOUS"), pair(out, 70, 0), pair(out, 3, "Solid line");
  pair(out, 72, 65), pair(out, 73, 0), real(out, 40, 0);
  pair(out, 0, "ENDTAB");
  pair(out, 0, "TABLE"), pair(out, 2, "LAYER"), pair(out, 70, layers.size());
  for (const Layer& layer : layers) {
    pair(out, 0, "LAYER"), pair(out, 2, layer.name), pair(out, 70, 0);
    pair(out, 62, layer.color), pair(out, 6, "CONTINUOUS");
  }
  pair(out, 0, "ENDTAB"), pair(out, 0, "ENDSEC");
}

void polyline(std::string& out, const char* layer, const Contour& contour) {
  if (contour.empty()) return;
  pair(out, 0, "POLYLINE"), pair(out, 8, layer), pair(out, 66, 1);
  point(out, 0, 0);
  pair(out, 70, 1);  // closed
  for (const Vertex& v : contour) {
    pair(out, 0, "VERTEX"), pair(out, 8, layer);
    point(out, v.x, v.y);
    if (v.bulge != 0) pair(out, 42, fmt::format("{:.15f}", v.bulge));
  }
  pair(out, 0, "SEQEND"), pair(out, 8, layer);
}

void circle(std::string& out, const char* layer, Place center, double radius) {
  if (!(radius > 0)) return;
  pair(out, 0, "CIRCLE"), pair(out, 8, layer);
  point(out, center.x, center.y);
  real(out, 40, radius);
}

}  // namespace

std::string contour_dxf(const DiscDrawing& d) {
  std::string out;
  header(out, d);
  tables(out);
  pair(out, 0, "SECTION"), pair(out, 2, "ENTITIES");
  polyline(out, "CAM", d.profile);
  polyline(out, "PITCH", d.pitch);
  polyline(out, "CUTTER", d.cutter);
  circle(out, "BASE", {}, d.base_radius);
  circle(out, "HUB", {}, d.hub_radius.value_or(0));
  circle(out, "ROLLER", d.roller, d.roller_radius);
  pair(out, 0, "ENDSEC"), pair(out, 0, "EOF");
  return out;
}

}  // namespace jounce

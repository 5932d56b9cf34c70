// SPDX-License-Identifier: Apache-2.0
#include "io/src/drawing/strokes.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce::io_detail {
namespace {

constexpr double curve_tolerance =
    1e-7;                       ///< greatest distance of an arc, as a share of its curve's size
constexpr int first_parts = 4;  ///< a full circle becomes four arcs
constexpr int most_divisions = 12;
constexpr std::size_t most_strokes = 1'000'000;

double cross(PlanePoint a, PlanePoint b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// The arc from a to b through m. By the inscribed angle, the angle between m - a and b - m is half
/// of the arc's angle.
Stroke arc_through(PlanePoint a, PlanePoint m, PlanePoint b) {
  const double half = std::arg((b - m) * std::conj(m - a));
  return {a, b, std::tan(half / 2)};
}

/// Distance of a point from the circle of an arc, or from its line.
double distance(const Stroke& arc, PlanePoint p) {
  const PlanePoint chord = arc.to - arc.from;
  const double length = std::abs(chord);
  if (length == 0) return std::abs(p - arc.from);
  const double bulge = arc.bulge;
  // The circle through both ends: cross/length is the height over the chord, the power of the point
  // divided by the diameter stays finite for a straight line.
  const double height = cross(chord, p - arc.from) / length;
  const double along = std::real((p - arc.from) * std::conj(chord)) / length;
  const double sagitta = -bulge * length / 2;  // height of the middle of the arc
  if (sagitta == 0) return std::abs(height);
  const double power = along * (along - length) + height * height -
                       height * (sagitta - length * length / (4 * sagitta));
  const double radius = std::abs(sagitta + length * length / (4 * sagitta)) / 2;
  return std::abs(power) / (2 * radius);
}

class Divider {
 public:
  Divider(std::vector<Stroke>& strokes, const std::function<PlanePoint(double)>& at,
          double tolerance)
      : strokes_(strokes), at_(at), tolerance_(tolerance) {}

  void add(double from, double to, int divisions) {
    const double middle = (from + to) / 2;
    const PlanePoint a = at_(from), b = at_(to);
    if (a == b && at_(middle) == a) return;
    if (!std::isfinite(std::norm(a)) || !std::isfinite(std::norm(b)))
      throw InputError("curve", "", "has coordinates beyond the range of numbers");
    if (strokes_.size() > most_strokes)
      throw InputError("curve", "", "is too complex: the drawing needs more than a million arcs");
    const Stroke arc = arc_through(a, at_(middle), b);
    const bool flat = std::abs(arc.bulge) <= 1;
    const bool close = distance(arc, at_((from + middle) / 2)) <= tolerance_ &&
                       distance(arc, at_((middle + to) / 2)) <= tolerance_;
    if ((flat && close) || divisions == 0) {
      strokes_.push_back(arc);
      return;
    }
    add(from, middle, divisions - 1);
    add(middle, to, divisions - 1);
  }

 private:
  std::vector<Stroke>& strokes_;
  const std::function<PlanePoint(double)>& at_;
  double tolerance_;
};

}  // namespace

void add_curve(std::vector<Stroke>& strokes, const std::function<PlanePoint(double)>& at,
               double from, double to) {
  double size = 0;
  for (int i = 1; i <= first_parts; ++i)
    size = std::max(size, std::abs(at(from + (to - from) * i / first_parts) - at(from)));
  Divider divider(strokes, at, curve_tolerance * size);
  for (int i = 0; i < first_parts; ++i)
    divider.add(from + (to - from) * i / first_parts, from + (to - from) * (i + 1) / first_parts,
                most_divisions);
}

void add_lines(std::vector<Stroke>& strokes, const std::vector<PlanePoint>& points, bool closed) {
  for (std::size_t i = 1; i < points.size(); ++i) strokes.push_back({points[i - 1], points[i]});
  if (closed && points.size() > 2) strokes.push_back({points.back(), points.front()});
}

}  // namespace jounce::io_detail

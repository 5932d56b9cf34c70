// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// Rotation in the plane of two axes, from the first towards the second.
Matrix turn(double degrees, std::size_t first, std::size_t second) {
  require_finite("rotation", degrees);
  const double quarters = degrees / 90;
  double cs = std::cos(degrees * (std::numbers::pi / 180));
  double sn = std::sin(degrees * (std::numbers::pi / 180));
  if (quarters == std::round(quarters)) {
    cs = std::round(cs);
    sn = std::round(sn);
  }
  Matrix m = Frame{}.rotation;
  m[first][first] = m[second][second] = cs;
  m[first][second] = -sn;
  m[second][first] = sn;
  return m;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t m = 0; m < 3; ++m) c[i][k] += a[i][m] * b[m][k];
  return c;
}

/// Rotates a direction; without the offset.
Point turned(const Frame& frame, const Point& v) {
  Point out = v;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = 0;
    for (std::size_t k = 0; k < 3; ++k) out[i] += frame.rotation[i][k] * v[k];
  }
  return out;
}

/// A linear combination of polynomials and sines of one length. Sines of one frequency are combined
/// into one.
Segment combination(const std::array<double, 3>& row, std::span<const Segment> axes,
                    double offset) {
  Segment out = scaled(axes[0], row[0], offset);
  for (std::size_t k = 1; k < axes.size(); ++k)
    if (row[k] != 0) out = *sum(out, scaled(axes[k], row[k]));
  return out;
}

}  // namespace

bool Frame::shifts() const {
  return rotation == Frame{}.rotation;
}

Frame turned_frame(const Point& offset, double degrees) {
  return {offset, turn(degrees, 0, 1)};
}

Frame euler_frame(const Point& offset, const std::array<double, 3>& zyz) {
  // A rotation about Y turns from Z towards X.
  return {offset, product(product(turn(zyz[0], 0, 1), turn(zyz[1], 2, 0)), turn(zyz[2], 0, 1))};
}

Point placed(const Frame& frame, const Point& part) {
  Point out = frame.shifts() ? part : turned(frame, part);
  for (std::size_t i = 0; i < max_axes; ++i) out[i] += frame.offset[i];
  return out;
}

Point within(const Frame& frame, const Point& machine) {
  Point out = machine;
  for (std::size_t i = 0; i < max_axes; ++i) out[i] -= frame.offset[i];
  if (frame.shifts()) return out;
  Frame back;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) back.rotation[i][k] = frame.rotation[k][i];
  return turned(back, out);
}

Arc placed(const Frame& frame, const Arc& arc) {
  Arc out = arc;
  out.center = placed(frame, arc.center);
  out.to = placed(frame, arc.to);
  out.e1 = turned(frame, arc.e1);
  out.e2 = turned(frame, arc.e2);
  out.drift = turned(frame, arc.drift);
  return out;
}

PathCurve placed(const Frame& frame, const PathCurve& curve) {
  PathCurve out = curve;
  out.from = placed(frame, curve.from);
  out.to = placed(frame, curve.to);
  const std::size_t n = curve.axes;
  const std::size_t turning = std::min<std::size_t>(n, 3);
  for (std::size_t k = 0; k < curve.segments.size(); k += n) {
    const std::span<const Segment> axes(curve.segments.data() + k, turning);
    for (std::size_t i = 0; i < n; ++i)
      out.segments[k + i] = i < turning && !frame.shifts()
                                ? combination(frame.rotation[i], axes, frame.offset[i])
                                : scaled(curve.segments[k + i], 1, frame.offset[i]);
  }
  return out;
}

Program placed(const Frame& frame, const Program& program) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (frame.rotation[i][k] != (i == k ? 1 : 0) && std::max(i, k) >= program.path_axes())
        throw InputError("rotation", std::to_string(program.path_axes()) + " path axes",
                         "turns an axis that is a follower or does not exist");
  Program out(program.axes(), placed(frame, program.start()), program.path_axes());
  for (const Program::Command& c : program.commands()) {
    out.set(program.settings()[c.settings]);
    switch (c.kind) {
      case Program::Kind::line: {
        Point to{};
        for (std::size_t i = 0; i < program.axes(); ++i) to[i] = program.numbers()[c.data + i];
        out.line(placed(frame, to), c.line);
        break;
      }
      case Program::Kind::arc:
        out.arc(placed(frame, program.arcs()[c.data]), c.line);
        break;
      case Program::Kind::curve:
        out.curve(placed(frame, program.curves()[c.data]), c.line);
        break;
      case Program::Kind::dwell:
        out.dwell(program.numbers()[c.data], c.line);
        break;
    }
  }
  return out;
}

}  // namespace jounce

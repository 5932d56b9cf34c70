// SPDX-License-Identifier: Apache-2.0
// DXF (Autodesk, "DXF Reference"): pairs of lines, a group code and its value. An object begins with
// the code 0.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/drawing/strokes.hpp"
#include "io/src/points/header.hpp"

namespace jounce::io_detail {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Group {
  int code = 0;
  int line = 0;  ///< line of the value
  std::string_view value;
};

/// Reads the pairs of lines.
std::vector<Group> groups_of(std::string_view text, const std::string& document) {
  std::vector<Group> all;
  int line = 0;
  const auto next = [&] {
    const auto end = text.find('\n');
    const std::string_view found = trimmed(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    ++line;
    return found;
  };
  while (!text.empty()) {
    const std::string_view code = next();
    if (code.empty() && text.empty()) break;
    Group group;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc() || end != code.data() + code.size())
      throw InputError("group code", printable(std::string(code.substr(0, 20))),
                       "must be a whole number: is this an ASCII DXF file?")
          .at(document, line);
    group.value = next();
    group.line = line;
    all.push_back(group);
  }
  return all;
}

/// One object of the drawing: its groups after the code 0.
class Object {
 public:
  Object(std::string_view name, std::vector<Group> groups, int line, const std::string& document)
      : name_(name), groups_(std::move(groups)), line_(line), document_(document) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] double value(const Group& group) const {
    if (const auto number = csv_number(group.value)) return *number;
    throw InputError(std::string(name_), printable(std::string(group.value)),
                     "must be a finite number")
        .at(document_, group.line);
  }
  [[nodiscard]] std::optional<double> optional(int code) const {
    for (const Group& group : groups_)
      if (group.code == code) return value(group);
    return std::nullopt;
  }
  [[nodiscard]] double number(int code) const {
    if (const auto found = optional(code)) return *found;
    fail("has no group " + std::to_string(code));
  }
  [[nodiscard]] int whole(int code) const { return static_cast<int>(optional(code).value_or(0)); }
  [[nodiscard]] PlanePoint point(int code) const { return {number(code), number(code + 10)}; }
  [[nodiscard]] std::string text(int code) const {
    for (const Group& group : groups_)
      if (group.code == code) return std::string(group.value);
    return "";
  }
  /// All values of a code.
  [[nodiscard]] std::vector<double> all(int code) const {
    std::vector<double> values;
    for (const Group& group : groups_)
      if (group.code == code) values.push_back(value(group));
    return values;
  }
  /// True if the object is mirrored: its normal points downwards. Fails for a tilted object.
  [[nodiscard]] bool is_mirrored() const {
    const double z = optional(230).value_or(1);
    if (optional(210).value_or(0) != 0 || optional(220).value_or(0) != 0 || std::abs(z) != 1)
      fail("is not in the plane of the drawing");
    return z < 0;
  }
  [[noreturn]] void fail(const std::string& rule) const {
    throw InputError(std::string(name_), "", rule).at(document_, line_);
  }

 private:
  std::string_view name_;
  std::vector<Group> groups_;
  int line_;
  const std::string& document_;
};

/// A vertex of a polyline with the bulge of the piece that begins there.
struct PolylineVertex {
  PlanePoint at;
  double bulge = 0;
};

void add_polyline(std::vector<Stroke>& strokes, std::vector<PolylineVertex> corners, bool closed,
                  bool mirrored) {
  if (mirrored)
    for (PolylineVertex& corner : corners) corner = {-std::conj(corner.at), -corner.bulge};
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n && (closed || i + 1 < n); ++i) {
    const Stroke whole{corners[i].at, corners[(i + 1) % n].at, corners[i].bulge};
    if (std::abs(whole.bulge) <= 1) {
      strokes.push_back(whole);
      continue;
    }
    // More than half a circle: two arcs.
    const PlanePoint chord = whole.to - whole.from;
    const PlanePoint middle = whole.from + chord * PlanePoint(0.5, -0.5 * whole.bulge);
    const double half = std::tan(std::atan(whole.bulge) / 2);
    strokes.push_back({whole.from, middle, half});
    strokes.push_back({middle, whole.to, half});
  }
}

constexpr double least_arc = 1e-9;  ///< rad; an arc that seems shorter is a full turn, rounded

/// The end of an arc that runs counterclockwise, at most one turn after its start.
double end_after(double from, double to) {
  const double travel = std::fmod(to - from, 2 * std::numbers::pi);
  return from + (travel > least_arc ? travel : travel + 2 * std::numbers::pi);
}

void add_arc(std::vector<Stroke>& strokes, const Object& object, double from, double to) {
  const PlanePoint center = object.point(10);
  const double radius = object.number(40);
  if (!(radius > 0)) object.fail("must have a radius greater than 0");
  const bool mirrored = object.is_mirrored();
  add_curve(
      strokes,
      [&](double angle) {
        const PlanePoint p = center + std::polar(radius, angle);
        return mirrored ? -std::conj(p) : p;
      },
      from, to);
}

void add_dxf_ellipse(std::vector<Stroke>& strokes, const Object& object) {
  const PlanePoint center = object.point(10), major = object.point(11);
  const PlanePoint minor = major * PlanePoint(0, object.is_mirrored() ? -1 : 1) * object.number(40);
  const double from = object.optional(41).value_or(0);
  const double to = end_after(from, object.optional(42).value_or(2 * std::numbers::pi));
  add_curve(
      strokes, [&](double t) { return center + major * std::cos(t) + minor * std::sin(t); }, from,
      to);
}

/// A point of a rational B-spline, by the algorithm of de Boor in homogeneous coordinates.
class Spline {
 public:
  explicit Spline(const Object& object)
      : degree_(static_cast<std::size_t>(std::max(object.whole(71), 0))),
        knots_(object.all(40)),
        weights_(object.all(41)) {
    const std::vector<double> x = object.all(10), y = object.all(20);
    if (x.empty())
      object.fail("has fit points only: save the drawing with control points, or as polylines");
    if (degree_ < 1 || degree_ > most_degree || y.size() != x.size() ||
        knots_.size() != x.size() + degree_ + 1 || x.size() <= degree_ ||
        !std::is_sorted(knots_.begin(), knots_.end()) ||
        (!weights_.empty() && weights_.size() != x.size()))
      object.fail(
          "must have a degree of 1 to 9, control points, and one more knot than the sum of "
          "both, in ascending order");
    weights_.resize(x.size(), 1);
    for (std::size_t i = 0; i < x.size(); ++i) points_.emplace_back(x[i], y[i]);
  }

  void add_to(std::vector<Stroke>& strokes) const {
    for (std::size_t i = degree_; i + degree_ + 1 < knots_.size(); ++i)
      if (knots_[i + 1] > knots_[i])
        add_curve(
            strokes, [&](double t) { return at(i, t); }, knots_[i], knots_[i + 1]);
  }

 private:
  static constexpr std::size_t most_degree = 9;

  [[nodiscard]] PlanePoint at(std::size_t span, double t) const {
    std::array<PlanePoint, most_degree + 1> p;
    std::array<double, most_degree + 1> w;
    for (std::size_t j = 0; j <= degree_; ++j) {
      const std::size_t i = span - degree_ + j;
      w[j] = weights_[i];
      p[j] = points_[i] * w[j];
    }
    for (std::size_t r = 1; r <= degree_; ++r)
      for (std::size_t j = degree_; j >= r; --j) {
        const std::size_t i = span - degree_ + j;
        const double u = (t - knots_[i]) / (knots_[i + degree_ - r + 1] - knots_[i]);
        p[j] = (1 - u) * p[j - 1] + u * p[j];
        w[j] = (1 - u) * w[j - 1] + u * w[j];
      }
    return p[degree_] / w[degree_];
  }

  std::size_t degree_;
  std::vector<double> knots_, weights_;
  std::vector<PlanePoint> points_ = {};
};

std::vector<PolylineVertex> corners_of(const Object& object) {
  std::vector<PolylineVertex> corners;
  for (const Group& group : object.groups()) {
    if (group.code == 10) corners.push_back({{object.value(group), 0}});
    if (corners.empty()) continue;
    if (group.code == 20) corners.back().at.imag(object.value(group));
    if (group.code == 42) corners.back().bulge = object.value(group);
  }
  return corners;
}

/// Reads the objects of a drawing.
class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& document)
      : groups_(groups_of(text, document)), document_(document) {}

  Layers read() {
    while (at_ < groups_.size()) {
      const Group group = groups_[at_++];
      if (group.code == 2 && at_ >= 2 && groups_[at_ - 2].value == "SECTION")
        section_ = group.value, is_drawing_ = is_drawing_ || section_ == "ENTITIES";
      if (group.code == 9 && group.value == "$INSUNITS" && at_ < groups_.size())
        read_unit(groups_[at_]);
      if (group.code == 0 && group.value == "ENDSEC") section_ = "";
      if (group.code == 0 && section_ == "ENTITIES") add(object(group));
    }
    if (!is_drawing_)
      throw InputError("", "", "has no section ENTITIES: is this a DXF file?").at(document_, 1);
    return std::move(all_);
  }

 private:
  void read_unit(const Group& group) {
    constexpr std::array<std::pair<std::string_view, const char*>, 5> units{
        {{"1", "in"}, {"4", "mm"}, {"5", "cm"}, {"6", "m"}, {"13", "um"}}};
    for (const auto& [code, unit] : units)
      if (group.value == code) all_.unit = unit;
    if (all_.unit.empty() && group.value != "0")
      throw InputError("$INSUNITS", printable(std::string(group.value)),
                       "must be 1 (in), 4 (mm), 5 (cm), 6 (m), 13 (um) or 0 (not stated)")
          .at(document_, group.line);
  }

  Object object(const Group& name) {
    std::vector<Group> own;
    while (at_ < groups_.size() && groups_[at_].code != 0) own.push_back(groups_[at_++]);
    return {name.value, std::move(own), name.line, document_};
  }

  void add(const Object& object) {
    if (object.whole(67) != 0) return;  // paper space
    const std::string_view name = object.name();
    constexpr std::array known{"LINE",     "ARC",     "CIRCLE", "LWPOLYLINE",
                               "POLYLINE", "ELLIPSE", "SPLINE"};
    constexpr std::array rejected{"INSERT", "MLINE", "REGION", "XLINE", "RAY", "HELIX"};
    const bool curve = std::find(known.begin(), known.end(), name) != known.end();
    if (!curve && std::find(rejected.begin(), rejected.end(), name) == rejected.end()) return;
    Layer& layer = all_.layers[object.text(8)];
    if (curve)
      add_to(layer.strokes, object);
    else if (layer.unsupported.empty())
      layer.unsupported = name, layer.line = object.line();
  }

  void add_to(std::vector<Stroke>& strokes, const Object& object) {
    const std::string_view name = object.name();
    constexpr double turn = 360 * degree;
    if (name == "LINE") strokes.push_back({object.point(10), object.point(11)});
    if (name == "CIRCLE") add_arc(strokes, object, 0, turn);
    if (name == "ELLIPSE") add_dxf_ellipse(strokes, object);
    if (name == "SPLINE") Spline(object).add_to(strokes);
    if (name == "LWPOLYLINE")
      add_polyline(strokes, corners_of(object), (object.whole(70) & 1) != 0, object.is_mirrored());
    if (name == "POLYLINE") add_vertices(strokes, object);
    if (name == "ARC") {
      const double from = object.number(50) * degree;
      add_arc(strokes, object, from, end_after(from, object.number(51) * degree));
    }
  }

  /// A POLYLINE is followed by its objects VERTEX, until SEQEND.
  void add_vertices(std::vector<Stroke>& strokes, const Object& polyline) {
    constexpr int mesh = 16 | 64, frame_point = 16;
    if ((polyline.whole(70) & mesh) != 0) polyline.fail("is a mesh, not a curve");
    std::vector<PolylineVertex> corners;
    while (at_ < groups_.size() && groups_[at_].value == "VERTEX") {
      const Group name = groups_[at_++];
      const Object vertex = object(name);
      if ((vertex.whole(70) & frame_point) == 0)
        corners.push_back({vertex.point(10), vertex.optional(42).value_or(0)});
    }
    add_polyline(strokes, std::move(corners), (polyline.whole(70) & 1) != 0,
                 polyline.is_mirrored());
  }

  std::vector<Group> groups_;
  const std::string& document_;
  std::size_t at_ = 0;
  std::string_view section_ = {};
  bool is_drawing_ = false;
  Layers all_ = {};
};

}  // namespace

Layers read_dxf(std::string_view text, const std::string& document) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw InputError("", "", "is a binary DXF file: save it as an ASCII DXF file").at(document, 1);
  return DxfReader(text, document).read();
}

}  // namespace jounce::io_detail

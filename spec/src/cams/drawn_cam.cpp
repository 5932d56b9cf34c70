// SPDX-License-Identifier: Apache-2.0
#include "spec/src/cams/drawn_cam.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/cam/disc/plate_motion.hpp"
#include "jounce/io/drawing.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce {
namespace spec_detail {
namespace {

constexpr std::size_t usual_intervals = 720;

/// The unit of a drawing: of its file, or the key `unit`.
std::string unit_of_drawing(TomlReader& drawing, const Outline& outline) {
  const auto given = drawing.optional_text("unit");
  if (given && (!is_unit(*given) || !is_convertible(*given, "mm")))
    drawing.fail("unit", '"' + *given + '"', "must be a unit of length, such as mm");
  if (given && !outline.unit.empty() && *given != outline.unit)
    drawing.fail("unit", '"' + *given + '"',
                 "is not the unit in the file, " + outline.unit + ": leave it out");
  if (!outline.unit.empty()) return outline.unit;
  if (given) return *given;
  throw InputError(drawing.path("unit"), "",
                   "is missing: the file " + outline.document +
                       " states no unit. Add one, such as unit = \"mm\"");
}

/// The place of the center of a plate, or of the zero of a graph.
std::pair<double, double> origin_of(TomlReader& drawing, const std::string& unit) {
  const std::vector<std::string> units{unit, unit};
  const std::vector<double> given = drawing.numbers("origin", units, ", x and y");
  return given.empty() ? std::pair{0.0, 0.0} : std::pair{given[0], given[1]};
}

/// A curve whose point `origin` is moved to 0, then turned, then enlarged.
Contour moved_curve(Contour curve, std::pair<double, double> origin, double turn, double factor) {
  const std::complex<double> map = std::polar(factor, turn);
  for (Vertex& v : curve) {
    const auto p = map * std::complex<double>(v.x - origin.first, v.y - origin.second);
    v.x = p.real(), v.y = p.imag();
  }
  return curve;
}

std::size_t intervals_of(TomlReader& drawing) {
  constexpr std::size_t most = 100'000;
  const std::size_t n = drawing.optional_count("intervals").value_or(usual_intervals);
  if (n < 8 || n > most)
    drawing.fail("intervals", std::to_string(n), "must be at least 8, and at most 100000");
  return n;
}

Points points_with(const std::string& document, const Units& units, std::vector<double> masters,
                   std::vector<double> slaves) {
  Points points;
  points.document = document;
  points.lines.resize(masters.size(), 0);  // a drawing has no line for a point
  points.columns.push_back({"master", units.x, std::move(masters)});
  points.columns.push_back({"slave", units.position, std::move(slaves)});
  return points;
}

/// Calls a function of a library with the keys of the drawing; an error gets the place of its key.
template <class Make>
auto with_place(TomlReader& drawing, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    if (error.key() == "profile")  // no key of the spec
      drawing.fail("origin", "", "the plate " + error.rule());
    drawing.fail(error.key().c_str(), error.value(), error.rule());
  }
}

DrawnCam plate_of(TomlReader& drawing, const Outline& outline, Units units) {
  drawing.describe("the drawing of a plate, a closed curve");
  if (units.x.empty()) units.x = "deg";
  if (units.position.empty()) units.position = "mm";
  DiscPart disc = read_disc_geometry(drawing, units);
  const std::string unit = unit_of_drawing(drawing, outline);
  const auto origin = origin_of(drawing, unit);
  const double turn = drawing.optional_number("turn", "rad").value_or(0);
  disc.geometry.base_radius = drawing.optional_positive("base_radius", disc.length).value_or(0);
  const std::size_t n = intervals_of(drawing);
  drawing.finish();
  const Contour profile = moved_curve(outline.pieces, origin, turn, conversion(unit, disc.length));
  std::vector<double> masters;
  for (std::size_t i = 0; i <= n; ++i)
    masters.push_back(2 * std::numbers::pi / disc.geometry.angle * static_cast<double>(i) /
                      static_cast<double>(n));
  PlateMotion motion =
      with_place(drawing, [&] { return plate_motion(profile, disc.geometry, masters); });
  motion.slave.back() = motion.slave.front();  // one turn later
  disc.geometry.base_radius = motion.base_radius;
  return {points_with(outline.document, units, std::move(masters), std::move(motion.slave)), disc};
}

/// Points on a graph: the vertices, and places on its arcs at most `spacing` apart.
class Graph {
 public:
  Graph(const Outline& outline, double spacing) : outline_(outline), spacing_(spacing) {
    const Contour& c = outline.pieces;
    add(c.front().x, c.front().y);
    for (std::size_t i = 1; i < c.size(); ++i) add_piece(c[i - 1], c[i]);
  }
  std::vector<double> x = {}, y = {};

 private:
  void add(double at, double value) {
    if (!x.empty() && !(at > x.back()))
      throw InputError("curve", "",
                       "runs back or up at x = " + number(at) +
                           ": a graph needs one slave position for each master position")
          .at(outline_.document, 0);
    x.push_back(at);
    y.push_back(value);
  }

  void add_piece(const Vertex& a, const Vertex& b) {
    if (a.bulge != 0) {
      const std::complex<double> from(a.x, a.y), chord(b.x - a.x, b.y - a.y);
      const double half = 2 * std::atan(a.bulge);  // half of the angle of the arc
      const auto n = static_cast<int>(std::ceil(std::abs(b.x - a.x) / spacing_));
      for (int k = 1; k < n; ++k) {
        // Chord to a place at the share s of the arc: sin(s half) / sin(half), turned by
        // (1 - s) half.
        const double s = static_cast<double>(k) / n;
        const auto p =
            from + chord * std::polar(std::sin(s * half) / std::sin(half), (s - 1) * half);
        add(p.real(), p.imag());
      }
    }
    add(b.x, b.y);
  }

  const Outline& outline_;
  double spacing_;
};

/// Units of a column for one unit of the drawing.
double scale_of(TomlReader& drawing, const char* key, const std::string& unit,
                const std::string& of_drawing) {
  if (is_convertible(of_drawing, unit) && !drawing.has(key)) return conversion(of_drawing, unit);
  const double scale = drawing.number(key, unit);
  if (!(scale > 0)) drawing.fail(key, number(scale), "must be greater than 0");
  return scale;
}

DrawnCam graph_of(TomlReader& drawing, Outline outline, Units units) {
  drawing.describe("the drawing of a graph, an open curve");
  const std::string unit = unit_of_drawing(drawing, outline);
  if (units.x.empty()) units.x = unit;
  if (units.position.empty()) units.position = unit;
  const double master = scale_of(drawing, "master_scale", units.x, unit);
  const double slave = scale_of(drawing, "slave_scale", units.position, unit);
  const auto origin = origin_of(drawing, unit);
  const std::size_t n = intervals_of(drawing);
  drawing.finish();
  Contour& c = outline.pieces;
  if (c.back().x < c.front().x) {
    std::reverse(c.begin(), c.end());
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i].bulge = -c[i + 1].bulge;
    c.back().bulge = 0;
  }
  c = moved_curve(std::move(c), origin, 0, 1);
  Graph graph(outline, (c.back().x - c.front().x) / static_cast<double>(n));
  for (double& each : graph.x) each *= master;
  for (double& each : graph.y) each *= slave;
  return {points_with(outline.document, units, std::move(graph.x), std::move(graph.y)), {}};
}

DrawnCam drawn_cam(TomlReader drawing, Outline outline, const Units& units) {
  return outline.closed ? plate_of(drawing, outline, units)
                        : graph_of(drawing, std::move(outline), units);
}

}  // namespace

std::optional<Points> read_drawn_points(TomlReader& segment, const Units& units) {
  const auto given = segment.optional_text("points");
  if (!given || !is_drawing(*given)) return std::nullopt;
  const std::filesystem::path spec = segment.document().name;
  const std::string file = (spec.parent_path() / *given).string();
  Outline outline = segment.file_of("points", file, [&] { return read_outline(file); });
  if (auto drawing = segment.optional_table("drawing"))
    return drawn_cam(std::move(*drawing), std::move(outline), units).points;
  const toml::table nothing;
  Document document;
  return drawn_cam(TomlReader(nothing, segment.path("drawing"), document), std::move(outline),
                   units)
      .points;
}

}  // namespace spec_detail

DrawnCam read_drawn_cam(const std::string& path, const std::string& keys, const Units& units) {
  Outline outline = read_outline(path);
  Document document;
  document.text = "drawing = { " + keys + " }";
  try {
    const toml::table root = toml::parse(std::string_view(document.text));
    spec_detail::TomlReader top(root, "", document);
    return spec_detail::drawn_cam(top.table("drawing"), std::move(outline), units);
  } catch (const InputError& error) {
    if (!error.document().empty()) throw;
    std::string key = error.key();
    if (key.starts_with("drawing.")) key[std::string("drawing").size()] = ' ';
    throw InputError(key, error.value(), error.rule());
  } catch (const toml::parse_error&) {
    throw InputError("drawing", keys,
                     "must be keys and values, such as roller_radius = 8, turn = \"-30 deg\"");
  }
}

}  // namespace jounce

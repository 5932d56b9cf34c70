// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

const DiscPart& require_disc(const Spec& spec) {
  if (!spec.disc)
    throw spec.document.located(InputError(
        "disc", "", "is missing: add the section [disc] with base_radius and roller_radius"));
  return *spec.disc;
}

/// Calls `work`; its errors get the keys and the place in the document.
template <class Work>
auto placed(const Spec& spec, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    const std::string key = error.key() == "cam" ? "disc" : "disc." + error.key();
    throw spec.document.located(InputError(key, error.value(), error.rule()));
  }
}

Contour scaled(Contour contour, double factor) {
  for (Vertex& v : contour) v = {v.x * factor, v.y * factor, v.bulge, v.master};
  return contour;
}

}  // namespace

Disc make_disc(const Spec& spec, const Cam& cam) {
  const DiscPart& part = require_disc(spec);
  return placed(spec, [&] { return Disc(cam, part.geometry); });
}

const Spec& cam_with_disc(const Input& input, const std::string& file) {
  if (!input.spec) throw InputError("SPEC", file, "is a table: give the spec of a cam with [disc]");
  const Spec& spec = *input.spec;
  if (!spec.is_cam())
    throw spec.document.located(InputError("kind", '"' + spec_kind(spec.document.text) + '"',
                                           "must be \"cam\": only a cam has a plate ([disc])"));
  return spec;
}

Report check_disc(const Spec& spec, const Cam& cam) {
  const Disc disc = make_disc(spec, cam);
  Report report = placed(spec, [&] { return check(disc, spec.disc->limits); });
  for (Finding& f : report.findings)
    if (f.unit.empty() && f.rule != "disc/corner") f.unit = spec.disc->length;
  return report;
}

DiscDrawing drawing_of(const Spec& spec, const Disc& disc) {
  const DiscPart& part = require_disc(spec);
  const DiscSpec& g = part.geometry;
  const double mm = conversion(part.length, "mm");
  const auto curve = [&](double distance) {
    return placed(spec, [&] { return scaled(contour(disc, distance, part.tolerance), mm); });
  };
  DiscDrawing d;
  d.name = spec.name.empty() ? spec.document.name : spec.name;
  d.profile = curve(-g.roller_radius);
  if (g.roller_radius > 0) d.pitch = curve(0);
  if (const auto cutter = part.limits.cutter_radius) d.cutter = curve(*cutter - g.roller_radius);
  d.tolerance = part.tolerance * mm;
  d.base_radius = g.base_radius * mm;
  if (part.hub_radius) d.hub_radius = *part.hub_radius * mm;
  d.roller_radius = g.roller_radius * mm;
  const Place roller = disc.at(disc.lift().start()).center;
  d.roller = {roller.x * mm, roller.y * mm};
  if (g.follower == Follower::oscillating) {
    const double turned =
        (g.rotation == Rotation::clockwise ? 1 : -1) * g.angle * disc.lift().start();
    d.pivot =
        Place{g.center_distance * mm * std::cos(turned), g.center_distance * mm * std::sin(turned)};
  }
  return d;
}

std::string contour_csv(const Spec& spec, const Disc& disc) {
  const DiscPart& part = require_disc(spec);
  const double mm = conversion(part.length, "mm");
  Contour c = placed(spec, [&] {
    return contour(disc, -part.geometry.roller_radius, part.tolerance, Pieces::lines);
  });
  c.push_back(c.front());
  c.back().master = disc.lift().end();
  std::string text = fmt::format("master [{}],x [mm],y [mm]\n", spec.units.x);
  for (const Vertex& v : c)
    text += number(v.master) + "," + number(v.x * mm) + "," + number(v.y * mm) + "\n";
  return text;
}

bool cannot_be_cut(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& f) {
    return f.broken && (f.rule == "disc/interference" || f.rule == "disc/cutter_radius" ||
                        (f.rule == "disc/profile_radius" && f.value <= 0));
  });
}

std::string extremes_text(const Spec& spec, const Disc& disc) {
  const DiscExtremes e = extremes(disc);
  const std::string& length = spec.disc->length;
  const double roller = spec.disc->geometry.roller_radius;
  const auto at = [&](const Extremum& x) { return rounded(x.where) + " " + spec.units.x; };
  const auto deg = [](const Extremum& x) { return rounded(x.value * 180 / std::numbers::pi); };
  const Extremum& hollow = e.pitch_curvature.min;
  return fmt::format("pressure angle: {} deg at {} .. {} deg at {}\n", deg(e.pressure_angle.min),
                     at(e.pressure_angle.min), deg(e.pressure_angle.max),
                     at(e.pressure_angle.max)) +
         fmt::format("profile, most convex: radius {} {} at {}\n",
                     rounded(1 / e.pitch_curvature.max.value - roller), length,
                     at(e.pitch_curvature.max)) +
         (hollow.value < 0 ? fmt::format("profile, most hollow: radius {} {} at {}\n",
                                         rounded(roller - 1 / hollow.value), length, at(hollow))
                           : "profile: nowhere hollow\n");
}

std::string contour_file(const std::string& path, const Spec& spec, const Disc& disc) {
  if (path.ends_with(".dxf")) return contour_dxf(drawing_of(spec, disc));
  if (path.ends_with(".svg")) return contour_svg(drawing_of(spec, disc));
  if (path.ends_with(".csv")) return contour_csv(spec, disc);
  throw InputError("output", path, "must end in .dxf, .svg or .csv");
}

}  // namespace jounce

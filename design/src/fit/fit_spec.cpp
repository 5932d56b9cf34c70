// SPDX-License-Identifier: Apache-2.0
#include "design/src/fit/fit_spec.hpp"

#include <cmath>

#include <fmt/format.h>

#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce::design_detail {
namespace {

void add(std::string& text, const char* key, const std::optional<double>& value) {
  if (value) text += fmt::format(", {} = {}", key, number(*value));
}

std::string knot_text(const CamKnot& knot) {
  std::string text =
      fmt::format("{{ master = {}, slave = {}", number(knot.master), number(knot.slave));
  add(text, "geo_velocity", knot.geo_velocity);
  add(text, "geo_acceleration", knot.geo_acceleration);
  return text + " }";
}

std::string word(const CamKnot& from, const CamSegment& segment) {
  if (segment.law == Law::dwell || segment.law == Law::line) return name(segment.law);
  return segment.end.slave > from.slave   ? "rise"
         : segment.end.slave < from.slave ? "return"
                                          : "motion";
}

std::string segment_text(const CamKnot& from, const CamSegment& segment) {
  std::string text = fmt::format("\n[[segment]]\nname = \"{}\"\nlaw = \"{}\"\n",
                                 word(from, segment), name(segment.law));
  if (segment.form.inflection)
    text += fmt::format("inflection = {}\n", number(*segment.form.inflection));
  if (!segment.points.empty()) {
    text += "points = [\n";
    for (const CamPoint& p : segment.points)
      text += fmt::format("  {{ master = {}, slave = {} }},\n", number(p.master), number(*p.slave));
    text += "]\n";
  }
  return text + fmt::format("end = {}\n", knot_text(segment.end));
}

std::string disc_text(const DiscPart& disc) {
  constexpr double digits = 1e9;  // a measured base radius is rounded to 1/digits
  const DiscSpec& g = disc.geometry;
  const bool slides = g.follower == Follower::translating;
  std::string text =
      fmt::format("\n[disc]\nfollower = \"{}\"\nbase_radius = {}\nroller_radius = {}\n",
                  slides ? "translating" : "oscillating",
                  number(std::round(g.base_radius * digits) / digits), number(g.roller_radius));
  if (slides && g.offset != 0) text += fmt::format("offset = {}\n", number(g.offset));
  if (!slides)
    text += fmt::format("arm_length = {}\ncenter_distance = {}\n", number(g.arm_length),
                        number(g.center_distance));
  return g.rotation == Rotation::clockwise ? text + "rotation = \"clockwise\"\n" : text;
}

}  // namespace

std::string fit_spec_text(const CamSpec& spec, const Units& units, const std::string& name,
                          const std::string& comment, double table_tolerance,
                          const std::optional<DiscPart>& disc) {
  std::string text =
      fmt::format("# {}\njounce = 1\nkind = \"cam\"\nname = \"{}\"\n", comment, name);
  if (spec.periodic) text += "periodic = true\n";
  if (spec.slave_period) text += fmt::format("slave_period = {}\n", number(*spec.slave_period));
  text += fmt::format("units = {{ master = \"{}\", position = \"{}\" }}\nstart = {}\n", units.x,
                      units.position, knot_text(spec.start));
  const CamKnot* from = &spec.start;
  for (const CamSegment& segment : spec.segments) {
    text += segment_text(*from, segment);
    from = &segment.end;
  }
  text += fmt::format("\n[table]\nrule = \"quintic_hermite\"\ntolerance = {}\n",
                      six_digits(table_tolerance));
  return disc ? text + disc_text(*disc) : text;
}

}  // namespace jounce::design_detail

// SPDX-License-Identifier: Apache-2.0
#include "design/src/fit/fit_spec.hpp"

#include <fmt/format.h>

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

}  // namespace

std::string fit_spec_text(const CamSpec& spec, const Units& units, const std::string& name,
                          const std::string& comment, double table_tolerance) {
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
  return text + fmt::format("\n[table]\nrule = \"quintic_hermite\"\ntolerance = {}\n",
                            number(table_tolerance));
}

}  // namespace jounce::design_detail

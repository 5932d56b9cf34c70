// SPDX-License-Identifier: Apache-2.0
#include "edit/src/cam_change.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "jounce/design/detail/law_guide.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/cam_edit.hpp"
#include "jounce/spec/spec.hpp"

#include "edit/src/cam_geometry.hpp"
#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {
namespace {

constexpr std::size_t last_share = 10;  ///< an added segment has 1/10 of the length of the cam

/// A cam spec that is being changed.
struct CamSource {
  std::string path;
  Spec spec;
  const CamSpec& cam;

  CamSource(std::string file, const std::string& text)
      : path(std::move(file)), spec(parse_spec(text, path)), cam(cam_of(spec)) {}

  static const CamSpec& cam_of(const Spec& spec) {
    if (const auto* cam = std::get_if<CamSpec>(&spec.subject)) return *cam;
    throw InputError("kind", "", "must be \"cam\" for this change");
  }

  [[nodiscard]] std::size_t knot(const JsonReader& change) const {
    return change.index("knot", 0, cam.segments.size());
  }
  /// The index of a segment, from 0.
  [[nodiscard]] std::size_t segment(const JsonReader& change) const {
    return change.index("segment", 1, cam.segments.size()) - 1;
  }
  [[nodiscard]] std::string segment_name(std::size_t i) const {
    const std::string& name = cam.segments[i].name;
    return fmt::format("segment {}{}", i + 1, name.empty() ? "" : " " + name);
  }
  /// The text with the numbers of a changed cam.
  [[nodiscard]] std::string with(const CamSpec& changed) const { return with_cam(spec, changed); }
};

ChangedText move(const CamSource& source, const JsonReader& change) {
  const std::size_t knot = source.knot(change);
  return {source.with(moved(source.cam, knot, change.number("master"), change.number("slave"))),
          fmt::format("move knot {}", knot)};
}

/// The knots that are the same knot as this one: both ends of a period, if both give the value.
std::vector<std::size_t> same_knots(const CamSource& source, std::size_t knot,
                                    std::optional<double> CamKnot::*value) {
  const std::size_t last = source.cam.segments.size();
  if (!source.cam.periodic || (knot != 0 && knot != last)) return {knot};
  const std::size_t other = last - knot;
  if (!(knot_of(source.cam, other).*value)) return {knot};
  if (!(knot_of(source.cam, knot).*value)) return {other};
  return {knot, other};
}

ChangedText set(const CamSource& source, const JsonReader& change) {
  const std::size_t knot = source.knot(change);
  const std::string key = change.word("key");
  const std::string label = fmt::format("{} of knot {}", key, knot);
  const CamKnot& now = knot_of(source.cam, knot);
  if (key == "master")
    return {source.with(moved(source.cam, knot, change.number("value"), now.slave)), label};
  if (key == "slave")
    return {source.with(moved(source.cam, knot, now.master, change.number("value"))), label};
  if (key != "geo_velocity" && key != "geo_acceleration")
    throw InputError("key", key, "must be master, slave, geo_velocity or geo_acceleration");
  const auto value = key == "geo_velocity" ? &CamKnot::geo_velocity : &CamKnot::geo_acceleration;
  CamSpec cam = source.cam;
  for (const std::size_t k : same_knots(source, knot, value))
    knot_of(cam, k).*value = change.optional_number("value");
  return {source.with(cam), label};
}

bool accepts(Law law, const LawForm& form) {
  try {
    require_valid(law, form);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// The values of a form that another law accepts.
LawForm form_for(Law law, const LawForm& old) {
  LawForm form;
  if (law == Law::scca) form.shares = old.shares ? old.shares : shown_form(law).shares;
  for (const auto value : {&LawForm::inflection, &LawForm::straight}) {
    LawForm with = form;
    with.*value = old.*value;
    if (accepts(law, with)) form = with;
  }
  return form;
}

/// Another law. A segment that becomes a dwell ends where it begins.
ChangedText set_law(const CamSource& source, const JsonReader& change) {
  const std::size_t i = source.segment(change);
  const Law law = law_of(change.word("law"));
  CamSpec cam = source.cam;
  if (law == Law::dwell)
    cam = moved(std::move(cam), i + 1, knot_of(source.cam, i + 1).master,
                knot_of(source.cam, i).slave);
  cam.segments[i].law = law;
  cam.segments[i].form = form_for(law, cam.segments[i].form);
  return {source.with(cam), fmt::format("law of {}", source.segment_name(i))};
}

ChangedText set_form(const CamSource& source, const JsonReader& change) {
  const std::size_t i = source.segment(change);
  const std::string key = change.word("key");
  CamSpec cam = source.cam;
  LawForm& form = cam.segments[i].form;
  if (key == "inflection")
    form.inflection = change.optional_number("value");
  else if (key == "straight")
    form.straight = change.optional_number("value");
  else if (key == "shares")
    form.shares = change.three_numbers("value");
  else
    throw InputError("key", key, "must be inflection, straight or shares");
  return {source.with(cam), fmt::format("{} of {}", key, source.segment_name(i))};
}

ChangedText set_name(const CamSource& source, const JsonReader& change) {
  const std::size_t i = source.segment(change);
  CamSpec cam = source.cam;
  cam.segments[i].name = change.word("name");
  return {source.with(cam), fmt::format("name of segment {}", i + 1)};
}

Cam curve_of(const Spec& spec) {
  if (spec.boundaries == Boundaries::rest) return design(std::get<CamSpec>(spec.subject)).cam;
  return std::get<Cam>(*make(spec).curve);
}

ChangedText split_at(const CamSource& source, const JsonReader& change) {
  const double master = change.number("master");
  const Split halves = split(source.cam, curve_of(source.spec), master);
  return {with_segment(source.with(halves.cam), halves.at, halves.first),
          fmt::format("split {}", source.segment_name(halves.at))};
}

/// Adds a dwell at the end.
ChangedText append(const CamSource& source, const JsonReader& /*change*/) {
  const CamKnot& end = source.cam.segments.back().end;
  CamSegment dwell{Law::dwell, {end.master, end.slave}};
  dwell.end.master += (end.master - source.cam.start.master) / last_share;
  return {with_segment(source.spec.document.text, source.cam.segments.size(), dwell),
          "add a segment"};
}

/// One segment in place of two: with the law of the first, and the end of the second.
std::string merged_text(const CamSource& source, std::size_t first) {
  CamSpec cam = source.cam;
  cam.segments[first].end = cam.segments[first + 1].end;
  return without_segment(source.with(cam), first + 1);
}

void require_segments(const CamSource& source, std::size_t least, const char* rule) {
  if (source.cam.segments.size() < least) throw InputError("segment", "", rule);
}

ChangedText merge(const CamSource& source, const JsonReader& change) {
  require_segments(source, 2, "is the only one: it has no next segment");
  const std::size_t i = change.index("segment", 1, source.cam.segments.size() - 1) - 1;
  return {merged_text(source, i), fmt::format("merge {} with the next", source.segment_name(i))};
}

/// The next segment then begins where this one began; before a deleted last segment, the previous
/// one ends where it ended.
ChangedText erase(const CamSource& source, const JsonReader& change) {
  require_segments(source, 2, "is the only one: a cam needs a segment");
  const std::size_t i = source.segment(change);
  const bool last = i + 1 == source.cam.segments.size();
  return {last ? merged_text(source, i - 1) : without_segment(source.spec.document.text, i),
          fmt::format("delete {}", source.segment_name(i))};
}

/// True for the master, false for the slave.
bool is_master(const JsonReader& change) {
  const std::string axis = change.word("axis");
  if (axis != "master" && axis != "slave")
    throw InputError("axis", axis, "must be master or slave");
  return axis == "master";
}

ChangedText mirror(const CamSource& source, const JsonReader& change) {
  if (is_master(change)) return {source.with(mirrored_master(source.cam)), "reverse the cam"};
  return {source.with(mirrored_slave(source.cam)), "mirror the cam"};
}

ChangedText shift(const CamSource& source, const JsonReader& change) {
  const Affine by{1, change.number("by")};
  if (is_master(change)) return {source.with(with_master(source.cam, by)), "shift the master"};
  return {source.with(with_slave(source.cam, by)), "shift the slave"};
}

ChangedText scale(const CamSource& source, const JsonReader& change) {
  const Affine by{change.number("by"), 0};
  const bool master = is_master(change);
  if (by.scale == 0 || (master && by.scale < 0))
    throw InputError("by", by.scale, master ? "must be greater than 0" : "must not be 0");
  if (master) return {source.with(with_master(source.cam, by)), "scale the master"};
  return {source.with(with_slave(source.cam, by)), "scale the slave"};
}

/// Moves a point of a segment through points.
ChangedText move_point(const CamSource& source, const JsonReader& change) {
  const std::size_t i = source.segment(change);
  CamSpec cam = source.cam;
  auto& points = cam.segments[i].points;
  if (points.empty()) throw InputError("segment", std::to_string(i + 1), "has no points");
  const std::size_t k = change.index("point", 1, points.size()) - 1;
  points[k].master = change.number("master");
  if (points[k].slave) points[k].slave = change.number("slave");
  return {source.with(cam), fmt::format("move point {} of {}", k + 1, source.segment_name(i))};
}

ChangedText move_switch(const CamSource& source, const JsonReader& change) {
  const std::size_t count = source.spec.switches.table.switches.size();
  const std::size_t i = change.index("switch", 1, std::max<std::size_t>(count, 1)) - 1;
  return {with_switch(source.spec, i, change.number("first"), change.optional_number("last")),
          fmt::format("move switch {}", i + 1)};
}

/// A change by name, and its keys beside "do".
struct Action {
  const char* name;
  std::vector<std::string> keys;
  ChangedText (*act)(const CamSource& source, const JsonReader& change);
};

const std::vector<Action>& actions() {
  static const std::vector<Action> all{
      {"move", {"knot", "master", "slave"}, move},
      {"set", {"knot", "key", "value"}, set},
      {"law", {"segment", "law"}, set_law},
      {"form", {"segment", "key", "value"}, set_form},
      {"name", {"segment", "name"}, set_name},
      {"split", {"master"}, split_at},
      {"append", {}, append},
      {"merge", {"segment"}, merge},
      {"delete", {"segment"}, erase},
      {"mirror", {"axis"}, mirror},
      {"shift", {"axis", "by"}, shift},
      {"scale", {"axis", "by"}, scale},
      {"point", {"segment", "point", "master", "slave"}, move_point},
      {"switch", {"switch", "first", "last"}, move_switch},
  };
  return all;
}

}  // namespace

std::optional<ChangedText> changed_cam(const std::string& path, const std::string& text,
                                       const JsonReader& change) {
  const std::string name = change.word("do");
  for (const Action& action : actions()) {
    if (name != action.name) continue;
    std::vector<std::string> keys = action.keys;
    keys.emplace_back("do");
    change.require_only(keys);
    return action.act(CamSource(path, text), change);
  }
  return std::nullopt;
}

std::vector<std::string> cam_changes() {
  std::vector<std::string> names;
  for (const Action& action : actions()) names.emplace_back(action.name);
  return names;
}

}  // namespace jounce::edit_detail

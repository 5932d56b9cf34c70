// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/cam_edit.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "spec/src/toml/table_list.hpp"
#include "spec/src/toml/toml_editor.hpp"

namespace jounce {
namespace {

using spec_detail::quoted;
using spec_detail::tidy;
using spec_detail::TomlEditor;

/// A table of the text: the start, a segment, its end, one of its points, or a switch, whose index is
/// `segment`.
struct CamPlace {
  enum class Of { start, segment, end, point, cam_switch } of;
  std::size_t segment = 0;
  std::size_t point = 0;

  [[nodiscard]] std::string path() const {
    if (of == Of::start) return "start";
    if (of == Of::cam_switch) return fmt::format("switch[{}]", segment + 1);
    const std::string own = fmt::format("segment[{}]", segment + 1);
    if (of == Of::segment) return own;
    return of == Of::end ? own + ".end" : fmt::format("{}.points[{}]", own, point + 1);
  }

  /// Null: the text does not have the table.
  [[nodiscard]] const toml::table* in(const toml::table& root) const {
    if (of == Of::start) return root["start"].as_table();
    if (of == Of::cam_switch) return root["switch"][segment].as_table();
    const auto own = root["segment"][segment];
    if (of == Of::segment) return own.as_table();
    return of == Of::end ? own["end"].as_table() : own["points"][point].as_table();
  }
};

/// Collects the changes of the text of a cam.
class CamText {
 public:
  explicit CamText(const Spec& spec)
      : spec_(spec), root_(toml::parse(spec.document.text)), editor_(spec.document.text) {}

  void knot(const CamPlace& at, const CamKnot& before, const CamKnot& after) {
    number(at, "master", spec_.units.x, before.master, after.master);
    number(at, "slave", spec_.units.position, before.slave, after.slave);
    // Entries that are added at one place: the later one comes first in the text.
    rate(at, 3, before.geo_jerk, after.geo_jerk);
    rate(at, 2, before.geo_acceleration, after.geo_acceleration);
    rate(at, 1, before.geo_velocity, after.geo_velocity);
  }

  /// The end of a line that gives its speed, and no slave position. `from`: the knots before it.
  void line_end(const CamPlace& at, const CamKnot& before, CamKnot after, const CamKnot& from) {
    number(at, "master", spec_.units.x, before.master, after.master);
    rate(at, 2, before.geo_acceleration, after.geo_acceleration);
    if (before.geo_velocity == after.geo_velocity)
      after.geo_velocity = (after.slave - from.slave) / (after.master - from.master);
    if (tidy(*before.geo_velocity) != tidy(*after.geo_velocity))
      rate(at, 1, before.geo_velocity, after.geo_velocity);
  }

  void segment(std::size_t i, const CamSegment& before, const CamSegment& after) {
    const CamPlace at{CamPlace::Of::segment, i};
    const toml::table& table = require(at);
    if (before.law != after.law) editor_.replace(table, "law", quoted(name(after.law)));
    text(at, "name", before.name, after.name);
    number(at, "inflection", "1", before.form.inflection, after.form.inflection, "law");
    number(at, "straight", "1", before.form.straight, after.form.straight, "law");
    shares(at, before.form.shares, after.form.shares);
    points(i, before, after);
    if (std::tie(before.control.values, before.control.knots) !=
        std::tie(after.control.values, after.control.knots))
      throw spec_.document.located(
          InputError(at.path() + ".control", "", "must be changed as text: the law is b_spline"));
  }

  void switch_positions(std::size_t i, const CamSwitch& before, const CamSwitch& after) {
    const CamPlace at{CamPlace::Of::cam_switch, i};
    number(at, "first_on_position", spec_.units.x, before.first_on_position,
           after.first_on_position, "track");
    number(at, "last_on_position", spec_.units.x, before.last_on_position, after.last_on_position,
           "track");
  }

  [[nodiscard]] bool has_no_slave(const CamPlace& at) const {
    const toml::table* table = at.in(root_);
    return table != nullptr && !table->contains("slave");
  }

  /// The changed text. Entries are removed one by one, because two neighbors share a comma.
  [[nodiscard]] std::string result() const {
    std::string changed = editor_.result();
    for (const auto& [at, key] : erased_) {
      const toml::table root = toml::parse(std::string_view(changed));
      TomlEditor eraser(changed);
      eraser.erase(*at.in(root), key);
      changed = eraser.result();
    }
    return changed;
  }

 private:
  const toml::table& require(const CamPlace& at) const {
    if (const toml::table* table = at.in(root_)) return *table;
    throw spec_.document.located(
        InputError(at.path(), "", "is a point of a file: give the knot in the spec"));
  }

  void number(const CamPlace& at, const char* key, const std::string& unit,
              std::optional<double> before, std::optional<double> after,
              const char* beside = "master") {
    if (before == after) return;
    const toml::table& table = require(at);
    if (!after) {
      if (table.contains(key)) erased_.emplace_back(at, key);
      return;
    }
    const std::string given = spec_.document.given_unit(at.path() + '.' + key, "");
    const std::string text =
        given.empty() ? tidy(*after) : quoted(tidy(*after * conversion(unit, given)) + ' ' + given);
    if (table.contains(key))
      editor_.replace(table, key, text);
    else
      editor_.add(table, beside, key, text);
  }

  /// A derivative under the key that its table has: by the master, or over time.
  void rate(const CamPlace& at, std::size_t order, std::optional<double> before,
            std::optional<double> after) {
    const char* const timed = OverTime::names[order];
    const toml::table* table = at.in(root_);
    const int n = static_cast<int>(order);
    if (table == nullptr || !table->contains(timed) || !spec_.master)
      return number(at, OverMaster::names[order], rate_unit(spec_.units.position, spec_.units.x, n),
                    before, after);
    const double speed = std::pow(spec_.master->velocity, n);
    const auto over_time = [&](std::optional<double> value) {
      return value ? std::optional(*value * speed) : std::nullopt;
    };
    if (before == after) return;
    number(at, timed, rate_unit(spec_.units.position, spec_.time_unit, n), over_time(before),
           over_time(after));
  }

  void text(const CamPlace& at, const char* key, const std::string& before,
            const std::string& after) {
    if (before == after) return;
    const toml::table& table = require(at);
    if (after.empty())
      erased_.emplace_back(at, key);
    else if (table.contains(key))
      editor_.replace(table, key, quoted(after));
    else
      editor_.add_beside(table, "law", key, quoted(after));
  }

  void shares(const CamPlace& at, const std::optional<std::array<double, 3>>& before,
              const std::optional<std::array<double, 3>>& after) {
    if (before == after) return;
    const toml::table& table = require(at);
    if (!after) {
      erased_.emplace_back(at, "shares");
      return;
    }
    const std::string list =
        fmt::format("[{}, {}, {}]", tidy((*after)[0]), tidy((*after)[1]), tidy((*after)[2]));
    if (table.contains("shares"))
      editor_.replace(table, "shares", list);
    else
      editor_.add(table, "law", "shares", list);
  }

  void points(std::size_t i, const CamSegment& before, const CamSegment& after) {
    const CamPlace own{CamPlace::Of::segment, i};
    const auto refuse = [&](const char* rule) {
      throw spec_.document.located(InputError(own.path() + ".points", "", rule));
    };
    if (before.points.size() != after.points.size()) refuse("must keep the number of its points");
    const bool in_file = root_["segment"][i]["points"].is_string();
    for (std::size_t k = 0; k < after.points.size(); ++k) {
      const CamPlace at{CamPlace::Of::point, i, k};
      const CamPoint& a = before.points[k];
      const CamPoint& b = after.points[k];
      const auto values = [](const CamPoint& p) {
        return std::tie(p.master, p.slave, p.geo_velocity, p.geo_acceleration, p.geo_jerk,
                        p.tolerance);
      };
      if (values(a) == values(b)) continue;
      if (in_file) refuse("are in another file: change that file");
      number(at, "master", spec_.units.x, a.master, b.master);
      number(at, "slave", spec_.units.position, a.slave, b.slave);
      rate(at, 1, a.geo_velocity, b.geo_velocity);
      rate(at, 2, a.geo_acceleration, b.geo_acceleration);
      rate(at, 3, a.geo_jerk, b.geo_jerk);
      number(at, "tolerance", spec_.units.position, a.tolerance, b.tolerance);
    }
  }

  const Spec& spec_;
  toml::table root_;
  TomlEditor editor_;
  std::vector<std::pair<CamPlace, const char*>> erased_;
};

// ---- segments as text ---------------------------------------------------------------------------

/// The text of the knot at the end of a segment.
std::string inline_knot(const CamKnot& knot) {
  std::string text = fmt::format("{{ master = {}, slave = {}", tidy(knot.master), tidy(knot.slave));
  if (knot.geo_velocity) text += ", geo_velocity = " + tidy(*knot.geo_velocity);
  if (knot.geo_acceleration) text += ", geo_acceleration = " + tidy(*knot.geo_acceleration);
  if (knot.geo_jerk) text += ", geo_jerk = " + tidy(*knot.geo_jerk);
  return text + " }";
}

std::vector<std::string> entries_of(const CamSegment& segment) {
  std::vector<std::string> entries;
  if (!segment.name.empty()) entries.push_back("name = " + quoted(segment.name));
  entries.push_back("law = " + quoted(name(segment.law)));
  entries.push_back("end = " + inline_knot(segment.end));
  return entries;
}

}  // namespace

std::string with_cam(const Spec& spec, const CamSpec& cam) {
  const auto& before = std::get<CamSpec>(spec.subject);
  assert(before.segments.size() == cam.segments.size());
  CamText text(spec);
  text.knot({CamPlace::Of::start}, before.start, cam.start);
  const CamKnot* from = &cam.start;
  for (std::size_t i = 0; i < cam.segments.size(); ++i) {
    const CamSegment& a = before.segments[i];
    const CamSegment& b = cam.segments[i];
    text.segment(i, a, b);
    const CamPlace end{CamPlace::Of::end, i};
    if (a.law == Law::line && a.end.geo_velocity && b.end.geo_velocity && text.has_no_slave(end))
      text.line_end(end, a.end, b.end, *from);
    else
      text.knot(end, a.end, b.end);
    from = &b.end;
  }
  return text.result();
}

std::string with_switch(const Spec& spec, std::size_t at, double first_on,
                        std::optional<double> last_on) {
  const auto& switches = spec.switches.table.switches;
  if (at >= switches.size())
    throw InputError("switch", std::to_string(at + 1),
                     fmt::format("must be 1 to {}", switches.size()));
  CamSwitch changed = switches[at];
  changed.first_on_position = first_on;
  if (changed.last_on_position) changed.last_on_position = last_on;
  CamText text(spec);
  text.switch_positions(at, switches[at], changed);
  return text.result();
}

std::string with_segment(const std::string& text, std::size_t at, const CamSegment& segment) {
  return spec_detail::with_table(text, "segment", at, entries_of(segment));
}

std::string without_segment(const std::string& text, std::size_t at) {
  return spec_detail::without_table(text, "segment", at);
}

}  // namespace jounce

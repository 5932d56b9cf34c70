// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/cam_edit.hpp"

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

#include "spec/src/toml/toml_editor.hpp"

namespace jounce {
namespace {

using spec_detail::TomlEditor;

/// A number without the rounding of its last digits: 0.3, not 0.30000000000000004.
std::string tidy(double value) {
  return number(std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr));
}

/// A text in the quotes of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20U)
      out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out + '"';
}

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

/// The end of the last value in a node.
toml::source_position last_of(const toml::node& node) {
  toml::source_position last = node.source().end;
  const auto take = [&](const toml::node& part) { last = std::max(last, last_of(part)); };
  if (const toml::table* table = node.as_table())
    for (const auto& [key, value] : *table) take(value);
  else if (const toml::array* array = node.as_array())
    for (const toml::node& each : *array) take(each);
  return last;
}

/// The text of a cam with its segments.
class SegmentList {
 public:
  explicit SegmentList(const std::string& text)
      : text_(text),
        root_(toml::parse(std::string_view(text))),
        segments_(*root_["segment"].as_array()) {}

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  /// True for segment = [{...}, ...], false for [[segment]].
  [[nodiscard]] bool is_inline() const { return segments_[0].as_table()->is_inline(); }

  /// The beginning of a segment: its {, or the line of its [[segment]].
  [[nodiscard]] std::size_t begin(std::size_t i) const {
    const std::size_t at = offset(segments_[i].source().begin);
    return is_inline() ? at : line_of(text_.rfind("[[", at + 1));
  }
  /// The end of a segment: behind its }, or behind the line of its last value.
  [[nodiscard]] std::size_t end(std::size_t i) const {
    if (is_inline()) return offset(segments_[i].source().end);
    const std::size_t line = text_.find('\n', offset(last_of(segments_[i])));
    return line == std::string::npos ? text_.size() : line + 1;
  }
  /// The beginning of the comment above a segment, if there is one without an empty line between.
  [[nodiscard]] std::size_t comment(std::size_t i) const {
    std::size_t at = begin(i);
    while (at > 0) {
      const std::size_t above = line_of(at - 1);
      const std::size_t word = text_.find_first_not_of(" \t", above);
      if (text_[word] != '#') break;
      at = above;
    }
    return at;
  }
  /// The indent of a segment that begins its line; "" otherwise.
  [[nodiscard]] std::optional<std::string> indent(std::size_t i) const {
    const std::size_t at = begin(i);
    const std::string_view before = std::string_view(text_).substr(line_of(at), at - line_of(at));
    if (before.find_first_not_of(" \t") != std::string_view::npos) return std::nullopt;
    return std::string(before);
  }
  /// The place behind the comma that follows, or `at` without a comma.
  [[nodiscard]] std::size_t behind_comma(std::size_t at) const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at);
    return next < text_.size() && text_[next] == ',' ? next + 1 : at;
  }
  [[nodiscard]] std::size_t line_of(std::size_t at) const {
    return at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
  }
  [[nodiscard]] bool is_blank_line(std::size_t at) const {
    const std::size_t word = text_.find_first_not_of(" \t\r", at);
    return word == std::string::npos || text_[word] == '\n';
  }

 private:
  [[nodiscard]] std::size_t offset(const toml::source_position& place) const {
    return spec_detail::offset(text_, place);
  }

  const std::string& text_;
  toml::table root_;
  const toml::array& segments_;
};

std::string with_line_ends_of(const std::string& text, std::string block) {
  if (text.find("\r\n") == std::string::npos) return block;
  for (std::size_t at = 0; (at = block.find('\n', at)) != std::string::npos; at += 2)
    block.insert(at, 1, '\r');
  return block;
}

/// segment = [{...}, ...]
std::string with_inline_segment(const std::string& text, const SegmentList& list, std::size_t at,
                                const std::string& entry) {
  std::string out = text;
  const bool last = at == list.size();
  const auto indent = list.indent(last ? at - 1 : at);
  const std::string gap = indent ? with_line_ends_of(text, "\n") + *indent : " ";
  if (last) return out.insert(list.end(at - 1), "," + gap + entry);
  return out.insert(list.begin(at), entry + "," + gap);
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
  const SegmentList list(text);
  assert(at <= list.size());
  const std::vector<std::string> entries = entries_of(segment);
  if (list.is_inline())
    return with_inline_segment(text, list, at, fmt::format("{{ {} }}", fmt::join(entries, ", ")));
  std::string block = "[[segment]]\n";
  for (const std::string& entry : entries) block += entry + "\n";
  std::string out = text;
  if (at < list.size()) return out.insert(list.comment(at), with_line_ends_of(text, block + "\n"));
  const std::size_t end = list.end(at - 1);
  const bool open = end > 0 && text[end - 1] != '\n';
  return out.insert(end, with_line_ends_of(text, (open ? "\n\n" : "\n") + block));
}

std::string without_segment(const std::string& text, std::size_t at) {
  const SegmentList list(text);
  assert(at < list.size() && list.size() > 1);
  std::size_t begin = list.begin(at);
  std::size_t end = list.end(at);
  std::string out = text;
  if (list.is_inline()) {
    end = list.behind_comma(end);
    end = std::min(text.find_first_not_of(" \t", end), text.size());
    if (list.indent(at) && list.is_blank_line(end)) {  // the whole line
      begin = list.line_of(begin);
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    }
    return out.erase(begin, end - begin);
  }
  const bool blank_above = begin == 0 || list.is_blank_line(list.line_of(begin - 1));
  if (blank_above)
    while (end < text.size() && list.is_blank_line(end))
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return out.erase(begin, end - begin);
}

}  // namespace jounce

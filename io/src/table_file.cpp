// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/table_file.hpp"

#include <array>
#include <cctype>
#include <utility>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/table_npy.hpp"

namespace jounce {

std::string made_by() {
  return "jounce " JOUNCE_VERSION;
}

namespace io_detail {

std::vector<std::string> column_names(Domain axis, Interpolation rule) {
  const auto& names = axis == Domain::time ? OverTime::names : OverMaster::names;
  std::vector<std::string> all{name(axis), names[0]};
  if (rule != Interpolation::linear) all.emplace_back(names[1]);
  if (rule == Interpolation::quintic_hermite) all.emplace_back(names[2]);
  return all;
}

std::string take_unit(TableParts& parts, std::size_t column, const std::string& unit) {
  if (!is_unit(unit)) return "is not a known unit";
  if (column == 0) parts.units.x = unit;
  if (column == 1) parts.units.position = unit;
  if (column < 2) return "";
  const auto needed = rate_unit(parts.units.position, parts.units.x, static_cast<int>(column) - 1);
  if (unit == needed) return "";
  const std::string& position = parts.units.position;
  return (position.empty() ? "" : "does not match the position, which is in " + position + ": ") +
         "the unit must be " + needed;
}

TableHead head_of(const TableFile& file) {
  return {{"axis", name(file.table.axis())},
          {"rule", name(file.table.rule())},
          {"outside", name(file.table.outside())},
          {"x_unit", file.units.x},
          {"position_unit", file.units.position},
          {"sha256", hex(content_hash(file.table, file.units))},
          {"spec", file.provenance.spec},
          {"spec_sha256", file.provenance.spec_sha256},
          {"made_by", file.provenance.made_by}};
}

TableParts parts_of(const TableHead& head, const std::string& name) {
  const auto value = [&](const char* key) {
    const auto found = head.find(key);
    if (found == head.end())
      throw InputError(key, "", "is missing: a table of Jounce has this property").at(name);
    return printable(found->second);
  };
  const auto fail = [&](const char* key) {
    return [key, &name](const std::string& given, const std::string& rule) {
      throw InputError(key, given, rule).at(name);
    };
  };
  TableParts parts;
  parts.axis = choice(value("axis"), std::span(axes), fail("axis"));
  parts.rule = choice(value("rule"), std::span(rules), fail("rule"));
  parts.outside = choice(value("outside"), std::span(policies), fail("outside"));
  parts.sha256 = value("sha256");
  parts.provenance = {value("spec"), value("spec_sha256"), value("made_by")};
  const std::array units{"x_unit", "position_unit"};
  for (std::size_t i = 0; i < units.size(); ++i)
    if (const std::string rule = take_unit(parts, i, value(units[i])); !rule.empty())
      fail(units[i])(value(units[i]), rule);
  return parts;
}

/// The line of the knot that an error's key names ("knot[3].time"), or 0.
int line_of(const InputError& error, const TableParts& parts) {
  if (parts.line_before_knots == 0 || !error.key().starts_with("knot[")) return 0;
  return parts.line_before_knots + std::stoi(error.key().substr(5));
}

}  // namespace io_detail

std::span<const OwnForm> own_forms() {
  static constexpr std::array all{
      OwnForm{"csv", ".csv", to_csv, true}, OwnForm{"json", ".json", to_json, true},
      OwnForm{"npy", ".npy", to_npy, false}, OwnForm{"lcm-log", ".lcmlog", to_lcm_log, true},
      OwnForm{"mcap", ".mcap", to_mcap, true}};
  return all;
}

const OwnForm* own_form_of_path(const std::string& path) {
  for (const OwnForm& form : own_forms())
    if (path.ends_with(form.ending)) return &form;
  return nullptr;
}

TableFile parse_table(const std::string& text, const std::string& name) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("", "", "the file is empty").at(name, 1);
  const auto parse = io_detail::is_lcm_log(text) ? io_detail::parse_lcm_log
                     : io_detail::is_mcap(text)  ? io_detail::parse_mcap
                     : text.starts_with('{')     ? io_detail::parse_json
                                                 : io_detail::parse_csv;
  auto parts = parse(text, name);
  try {
    TableFile file{Table(parts.axis, parts.rule, parts.outside, std::move(parts.columns)),
                   parts.units, parts.provenance};
    const std::string actual = hex(content_hash(file.table, file.units));
    if (actual != parts.sha256)
      throw InputError(
          "sha256", parts.sha256,
          "does not match the content, whose hash is " + actual +
              ": the file was changed after Jounce wrote it. Restore it, or export it again");
    return file;
  } catch (const InputError& error) {
    throw error.at(name, io_detail::line_of(error, parts));
  }
}

TableFile read_table(const std::string& path) {
  return parse_table(read_file(path), path);
}

bool is_table(const std::string& text) {
  // A letter behind the brace makes it a pragma of Structured Text: {attribute 'linkalways'}.
  const bool pragma = text.size() > 1 && std::isalpha(static_cast<unsigned char>(text[1])) != 0;
  const auto is_ros = [&] { return text.find("\"joint_names\"") != text.npos; };
  return text.starts_with("# jounce table") || (text.starts_with('{') && !pragma && !is_ros()) ||
         io_detail::is_lcm_log(text) || io_detail::is_mcap(text);
}

std::string table_text(const std::string& path, const TableFile& file) {
  for (const auto& [unit, whose] :
       {std::pair{&file.units.x, name(file.table.axis())}, {&file.units.position, "position"}})
    if (unit->empty())
      throw InputError("unit", "",
                       std::string("is missing: give `jounce convert` the unit of the ") + whose);
  const OwnForm* const form = own_form_of_path(path);
  return form != nullptr && form->readable ? form->write(file) : to_csv(file);
}

void write_table(const std::string& path, const TableFile& file) {
  write_file(path, table_text(path, file));
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "io/src/points/header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace io_detail {
namespace {

/// Signs of units. A sign of Windows-1252 is one byte, which UTF-8 has only after another one.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> signs{{
    {"\xC2\xB5", "u"},  // micro sign
    {"\xCE\xBC", "u"},  // Greek letter mu
    {"\xC2\xB0", "deg"},
    {"\xC2\xBA", "deg"},  // masculine ordinal, typed for a degree sign
    {"\xC2\xB2", "^2"},
    {"\xC2\xB3", "^3"},
    {"\xC2\xB7", " "},  // middle dot
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> windows_signs{
    {{"\xB5", "u"}, {"\xB0", "deg"}, {"\xB2", "^2"}, {"\xB3", "^3"}}};

std::string with_plain_signs(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const auto begins = [&](const auto& sign) { return text.starts_with(sign.first); };
    const std::pair<std::string_view, std::string_view>* found =
        std::find_if(signs.begin(), signs.end(), begins);
    if (found == signs.end()) {
      found = std::find_if(windows_signs.begin(), windows_signs.end(), begins);
      if (found == windows_signs.end()) found = nullptr;
    }
    plain += found != nullptr ? found->second : text.substr(0, 1);
    text.remove_prefix(found != nullptr ? found->first.size() : 1);
  }
  return plain;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool begins_with_number(std::string_view text) {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

/// The unit after a mark, and the name before it. None if the text after the mark is not a unit.
std::optional<PointColumn> split_at(std::string_view cell, std::string_view mark,
                                    std::string_view end) {
  const auto at = cell.rfind(mark);
  if (at == cell.npos || at == 0 || !cell.ends_with(end)) return std::nullopt;
  const auto from = at + mark.size();
  if (from + end.size() > cell.size()) return std::nullopt;
  const std::string unit = unit_of(cell.substr(from, cell.size() - from - end.size()));
  if (unit.empty()) return std::nullopt;
  return PointColumn{lower(trimmed(cell.substr(0, at))), unit};
}

PointColumn split(std::string_view cell) {
  if (const auto bracket = cell.find('['); bracket != cell.npos) {
    const std::string name = lower(trimmed(cell.substr(0, bracket)));
    if (cell.back() != ']')
      throw InputError(name, std::string(cell), "needs a closing bracket after its unit");
    const std::string text(trimmed(cell.substr(bracket + 1, cell.size() - bracket - 2)));
    const std::string unit = unit_of(text);
    if (unit.empty() && text != "-")
      throw InputError(name, text, "is not a known unit: write one such as mm, deg, s or mm/s");
    return {name, unit};
  }
  for (const auto& [mark, end] :
       {std::pair<std::string_view, std::string_view>{"(", ")"}, {" / ", ""}, {" in ", ""}})
    if (const auto column = split_at(cell, mark, end)) return *column;
  return {lower(cell), ""};
}

/// Other names of the columns, without spaces, `_` and `-`: those of CODESYS (SMC_CAMXYVA: X, Y),
/// TwinCAT (MC_MotionFunctionPoint: MasterPos, SlavePos) and Siemens (LCamHdl_typeBasicPoint:
/// leadingValue, followingValue), common short forms, and German words.
struct OtherNames {
  std::string_view column;
  std::array<std::string_view, 7> names;
};
constexpr std::array other_names{
    OtherNames{"time", {"t", "zeit"}},
    OtherNames{"master",
               {"x", "masterpos", "masterposition", "leadingvalue", "leitwert", "angle", "winkel"}},
    OtherNames{"slave",
               {"y", "slavepos", "slaveposition", "followingvalue", "folgewert", "lift", "hub"}},
    OtherNames{"position", {"pos", "p", "weg"}},
    OtherNames{"velocity", {"vel", "v", "geschwindigkeit"}},
    OtherNames{"acceleration", {"acc", "a", "accel", "beschleunigung"}},
    OtherNames{"tolerance", {"tol"}},
    OtherNames{"type", {"typ"}}};

bool names(std::string_view column, const std::string& name) {
  std::string plain;
  for (const char c : name)
    if (c != ' ' && c != '_' && c != '-') plain += c;
  return std::any_of(other_names.begin(), other_names.end(), [&](const OtherNames& other) {
    return other.column == column &&
           std::find(other.names.begin(), other.names.end(), plain) != other.names.end();
  });
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

std::string unit_of(std::string_view text) {
  text = trimmed(text);
  for (const std::string_view brackets : {"[]", "()"})
    if (text.size() > 2 && text.front() == brackets[0] && text.back() == brackets[1])
      text = trimmed(text.substr(1, text.size() - 2));
  const std::string plain = with_plain_signs(text);
  return is_unit(plain) ? plain : "";
}

bool has_words(const PointColumn& column) {
  return column.name == "type" || names("type", column.name);
}

PointColumn column_of(std::string_view cell) {
  if (cell.find('=') != cell.npos)
    throw InputError("", "",
                     "is a line of a spec, not a header with the names of columns: give a CSV "
                     "file, whose first line has these names");
  PointColumn column = split(cell);
  if (column.name.empty() || begins_with_number(column.name))
    throw InputError(
        "header", std::string(cell),
        "must be the name of a column, with or without a unit, such as position [mm]: write a "
        "header above the numbers");
  return column;
}

}  // namespace io_detail

void Points::name_columns(std::span<const std::string> wanted) {
  for (const std::string& name : wanted) {
    if (find(name) != nullptr) continue;
    std::vector<PointColumn*> others;
    for (PointColumn& column : columns)
      if (io_detail::names(name, column.name) &&
          std::find(wanted.begin(), wanted.end(), column.name) == wanted.end())
        others.push_back(&column);
    if (others.size() == 1) others.front()->name = name;
  }
}

}  // namespace jounce

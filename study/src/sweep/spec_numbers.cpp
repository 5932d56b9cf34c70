// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/spec_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/text_edit.hpp"

namespace jounce {
namespace {

/// "12.5 mm/s": the number and the unit behind it.
std::optional<std::pair<double, std::string>> split(const std::string& text) {
  constexpr const char* blank = " \t";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return std::nullopt;
  const char* begin = text.data() + first + (text[first] == '+' ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  std::string unit(end, text.data() + text.size());
  unit.erase(0, std::min(unit.find_first_not_of(blank), unit.size()));
  unit.erase(unit.find_last_not_of(blank) + 1);
  if (!unit.empty() && !is_unit(unit)) return std::nullopt;
  return std::pair{value, std::move(unit)};
}

}  // namespace

/// Walks through the document and notes where each value stands.
struct SpecNumbers::Reader {
  SpecNumbers& into;

  void operator()(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table)
      (*this)(node,
              prefix.empty() ? std::string(key.str()) : prefix + "." + std::string(key.str()));
  }

  void operator()(const toml::node& node, const std::string& key) {
    if (const auto* table = node.as_table()) {
      into.others_.emplace(key, static_cast<int>(node.source().begin.line));
      (*this)(*table, key);
    } else if (const auto* array = node.as_array()) {
      into.others_.emplace(key, static_cast<int>(node.source().begin.line));
      std::size_t i = 0;
      for (const auto& element : *array) (*this)(element, key + "[" + std::to_string(++i) + "]");
    } else {
      leaf(node, key);
    }
  }

  void leaf(const toml::node& node, const std::string& key) {
    Place place{spec_detail::offset(into.document_.text, node.source().begin),
                spec_detail::offset(into.document_.text, node.source().end)};
    if (const auto whole = node.value_exact<std::int64_t>()) {
      place.value = static_cast<double>(*whole);
      place.whole = true;
    } else if (const auto real = node.value_exact<double>()) {
      place.value = *real;
    } else {
      const auto text = node.value_exact<std::string>();
      const auto parts = text ? split(*text) : std::nullopt;
      if (!parts) {
        into.others_.emplace(key, static_cast<int>(node.source().begin.line));
        return;
      }
      std::tie(place.value, place.unit) = *parts;
      place.quoted = true;
    }
    into.numbers_.emplace(key, std::move(place));
  }
};

SpecNumbers::SpecNumbers(Document document) : document_(std::move(document)) {
  try {
    const toml::table root =
        toml::parse(std::string_view(document_.text), std::string_view(document_.name));
    Reader{*this}(root, "");
  } catch (const toml::parse_error&) {
    (void)parse_spec(document_.text, document_.name);  // throws with the reason
    throw;
  }
}

const SpecNumbers::Place& SpecNumbers::place(const std::string& key) const {
  if (const auto it = numbers_.find(key); it != numbers_.end()) return it->second;
  if (const auto it = others_.find(key); it != others_.end())
    throw InputError(key, "", "is not a number").at(document_.name, it->second);
  std::vector<std::string> known;
  for (const auto& [name, place] : numbers_) known.push_back(name);
  const std::string hint = nearest(key, known);
  throw InputError(key, "",
                   "names no number in this file" +
                       (hint.empty() ? "; if the file omits the key, add it there first"
                                     : ": did you mean " + hint + "?"))
      .at(document_.name);
}

double SpecNumbers::value(const std::string& key) const {
  return place(key).value;
}

std::string SpecNumbers::unit(const std::string& key) const {
  return place(key).unit;
}

bool SpecNumbers::is_whole(const std::string& key) const {
  return place(key).whole;
}

std::string SpecNumbers::text(std::span<const Change> changes) const {
  std::vector<spec_detail::Edit> edits;
  std::set<std::string> seen;
  for (const Change& change : changes) {
    const Place& at = place(change.key);
    if (!std::isfinite(change.value))
      throw InputError(change.key, change.value, "must be a finite number").at(document_.name);
    if (!seen.insert(change.key).second)
      throw InputError(change.key, change.value, "is given twice").at(document_.name);
    std::string written = number(change.value);
    if (at.quoted) written = '"' + written + (at.unit.empty() ? "" : " " + at.unit) + '"';
    edits.push_back({at.begin, at.end, std::move(written)});
  }
  return spec_detail::edited(document_.text, std::move(edits));
}

Spec SpecNumbers::spec(std::span<const Change> changes) const {
  return parse_spec(text(changes), document_.name);
}

}  // namespace jounce

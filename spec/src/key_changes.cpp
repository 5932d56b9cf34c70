// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/key_changes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce {
namespace {

/// The value of a key.
struct KeyValue {
  std::string text = {};              ///< the text of the file, without quotes
  std::optional<double> number = {};  ///< a number without a unit in the text
  Document::Place place = {};
};

/// The values of one spec, by key.
struct KeyValues {
  std::vector<std::string> keys = {};  ///< in the order of the text
  std::map<std::string, KeyValue> values = {};
};

void collect(const toml::node& node, const std::string& key, KeyValues& all) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table)
      collect(value, key.empty() ? std::string(name.str()) : key + '.' + std::string(name.str()),
              all);
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i)
      collect(*array->get(i), key + '[' + std::to_string(i + 1) + ']', all);
  } else {
    KeyValue value;
    value.text = node.value_exact<std::string>().value_or("");
    if (!node.is_string()) value.text = spec_detail::shown(node);
    if (node.is_number()) value.number = node.value<double>();
    value.place = {static_cast<int>(node.source().begin.line),
                   static_cast<int>(node.source().begin.column)};
    all.keys.push_back(key);
    all.values.emplace(key, std::move(value));
  }
}

KeyValues values_of(const Spec& spec) {
  KeyValues all;
  collect(spec_detail::parse_toml(spec.document), "", all);
  std::stable_sort(all.keys.begin(), all.keys.end(), [&](const auto& a, const auto& b) {
    const Document::Place& x = all.values.at(a).place;
    const Document::Place& y = all.values.at(b).place;
    return std::pair(x.line, x.column) < std::pair(y.line, y.column);
  });
  return all;
}

/// The unit in which the reader of the spec has read this number; an element of a list has that of the list.
std::string unit_of_key(const Document& document, const std::string& key) {
  auto unit = document.units.find(key);
  if (unit == document.units.end()) unit = document.units.find(key.substr(0, key.rfind('[')));
  return unit == document.units.end() || unit->second == "1" ? "" : unit->second;
}

/// The quantity in `unit`; nullopt for a text.
std::optional<double> quantity_in(const KeyValue& value, const std::string& own,
                                  const std::string& unit) {
  try {
    if (value.number) return *value.number * (own == unit ? 1 : conversion(own, unit));
    if (unit.empty()) return std::nullopt;
    return quantity(value.text, unit);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The value with its unit, of at most 60 characters on one line.
std::string value_text(const KeyValue& value, const std::string& unit) {
  constexpr std::size_t most = 60;
  std::string text = value.text.substr(0, value.text.find('\n'));
  if (text.size() > most) text.resize(most);
  if (text.size() < value.text.size()) text += " ...";
  if (text.empty()) return "\"\"";
  return value.number && !unit.empty() ? text + ' ' + unit : text;
}

bool is_limit(const std::string& key) {
  return key.starts_with("limits.") || key.find(".limits.") != key.npos || key.ends_with("_limit");
}

/// The place of the nearest table around a key that the spec does not have.
Document::Place place_around(const Document& document, std::string key) {
  while (!key.empty()) {
    const auto dot = key.rfind('.');
    key.resize(dot == key.npos ? 0 : dot);
    if (const auto at = document.places.find(key); at != document.places.end()) return at->second;
  }
  return {};
}

}  // namespace

std::vector<KeyChange> changed_keys(const Spec& before, const Spec& after) {
  const KeyValues old = values_of(before);
  const KeyValues now = values_of(after);
  std::vector<KeyChange> all;
  for (const std::string& key : now.keys) {
    const KeyValue& value = now.values.at(key);
    const std::string unit = unit_of_key(after.document, key);
    KeyChange change{key, "", value_text(value, unit), is_limit(key), value.place};
    if (const auto found = old.values.find(key); found != old.values.end()) {
      const std::string own = unit_of_key(before.document, key);
      const auto a = quantity_in(found->second, own, unit);
      const auto b = quantity_in(value, unit, unit);
      constexpr double rounding = 1e-14;  // that the conversions cause
      const bool same =
          a && b ? std::abs(*a - *b) <= rounding * std::abs(*b) : found->second.text == value.text;
      if (same) continue;
      change.before = value_text(found->second, own);
    }
    all.push_back(std::move(change));
  }
  for (const std::string& key : old.keys)
    if (!now.values.contains(key))
      all.push_back({key, value_text(old.values.at(key), unit_of_key(before.document, key)), "",
                     is_limit(key), place_around(after.document, key)});
  return all;
}

}  // namespace jounce

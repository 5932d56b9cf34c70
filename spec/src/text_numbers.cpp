// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/text_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "spec/src/toml/table_list.hpp"
#include "spec/src/toml/toml_editor.hpp"

namespace jounce {
namespace {

using spec_detail::node_at;
using spec_detail::quoted;
using spec_detail::tidy;
using spec_detail::TomlEditor;

std::optional<double> value_of(const toml::node& node, const std::string& unit) {
  if (const auto text = node.value_exact<std::string>()) return quantity(*text, unit);
  return node.value<double>();
}

/// The table that contains a key, and the last part of the key: "knot[3]" and "time".
std::pair<std::string, std::string> table_and_name(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) return {"", key};
  return {key.substr(0, dot), key.substr(dot + 1)};
}

/// An entry of a table beside which another one can be added: its first entry on one line.
const char* first_entry(const toml::table& table) {
  const toml::key* first = nullptr;
  for (const auto& [key, value] : table)
    if (!value.is_table() && !value.is_array_of_tables() &&
        (first == nullptr || key.source().begin < first->source().begin))
      first = &key;
  return first == nullptr ? nullptr : first->data();
}

class NumberEdit {
 public:
  explicit NumberEdit(const Document& document)
      : document_(document), root_(toml::parse(document.text)), editor_(document.text) {}

  void apply(const NumberChange& change) {
    const toml::node* node = node_at(root_, change.key);
    if (!change.value) return erase(change.key, node);
    const std::string text = text_of(change);
    if (node != nullptr) {
      if (value_of(*node, document_.units.at(change.key)) != change.value)
        editor_.replace(*node, text);
      return;
    }
    const auto [path, name] = table_and_name(change.key);
    const toml::node* parent = path.empty() ? &root_ : node_at(root_, path);
    const toml::table* table = parent == nullptr ? nullptr : parent->as_table();
    const char* beside = table == nullptr ? nullptr : first_entry(*table);
    if (beside == nullptr || name.ends_with(']'))
      throw InputError(change.key, *change.value, "is not in the text: it may be in another file");
    editor_.add(*table, beside, name.c_str(), text);
  }

  /// Entries are removed one by one, because two neighbors share a comma.
  [[nodiscard]] std::string result() const {
    std::string changed = editor_.result();
    for (const std::string& key : erased_) {
      const toml::table root = toml::parse(std::string_view(changed));
      const auto [path, name] = table_and_name(key);
      TomlEditor eraser(changed);
      eraser.erase(*(path.empty() ? &root : node_at(root, path))->as_table(), name.c_str());
      changed = eraser.result();
    }
    return changed;
  }

 private:
  void erase(const std::string& key, const toml::node* node) {
    if (key.ends_with(']')) throw InputError(key, "", "is a number of a list: give another number");
    if (node != nullptr) erased_.push_back(key);
  }

  /// The text of the new value, in the unit that the text or, without one, the spec gives.
  [[nodiscard]] std::string text_of(const NumberChange& change) const {
    const auto read = document_.units.find(change.key);
    if (read == document_.units.end()) {
      if (!document_.known.contains(change.key))
        throw InputError(change.key, *change.value, "is not the key of a number of this spec");
      return tidy(*change.value);
    }
    const auto given = document_.given.find(change.key);
    if (given == document_.given.end()) return tidy(*change.value);
    return quoted(tidy(*change.value * conversion(read->second, given->second)) + ' ' +
                  given->second);
  }

  const Document& document_;
  toml::table root_;
  TomlEditor editor_;
  std::vector<std::string> erased_;
};

}  // namespace

std::vector<TextNumber> numbers_of(const Document& document) {
  const toml::table root = toml::parse(std::string_view(document.text));
  std::vector<std::tuple<toml::source_position, TextNumber>> placed;
  for (const auto& [key, unit] : document.units) {
    const toml::node* node = node_at(root, key);
    if (node == nullptr) continue;
    const auto value = value_of(*node, unit);
    const toml::source_position at = node->source().begin;
    if (value) placed.push_back({at, {key, *value, unit, static_cast<int>(at.line)}});
  }
  std::sort(placed.begin(), placed.end(),
            [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  std::vector<TextNumber> numbers;
  for (auto& [at, number] : placed) numbers.push_back(std::move(number));
  return numbers;
}

std::string with_numbers(const Document& document, const std::vector<NumberChange>& changes) {
  NumberEdit edit(document);
  for (const NumberChange& change : changes) edit.apply(change);
  return edit.result();
}

std::string with_row(const std::string& text, const std::string& list, std::size_t at,
                     const std::vector<std::string>& entries) {
  const std::size_t count = spec_detail::tables_in(text, list);
  return spec_detail::with_table(text, list, std::min(at, count), entries);
}

std::string without_row(const std::string& text, const std::string& row) {
  const std::size_t open = row.ends_with(']') ? row.rfind('[') : std::string::npos;
  std::size_t number = 0;
  if (open != std::string::npos)
    std::from_chars(row.data() + open + 1, row.data() + row.size() - 1, number);
  if (number == 0) throw InputError("row", row, "must be a table of a list, such as knot[2]");
  const std::string list = row.substr(0, open);
  const std::size_t count = spec_detail::tables_in(text, list);
  if (number > count)
    throw InputError("row", row, fmt::format("must be {0}[1] to {0}[{1}]", list, count));
  if (count == 1) throw InputError("row", row, "is the only one: the list needs a table");
  return spec_detail::without_table(text, list, number - 1);
}

std::string entry_text(const std::string& key, double value) {
  return fmt::format("{} = {}", key, tidy(value));
}

std::string entry_text(const std::string& key, const std::vector<double>& values) {
  std::vector<std::string> numbers;
  for (const double value : values) numbers.push_back(tidy(value));
  return fmt::format("{} = [{}]", key, fmt::join(numbers, ", "));
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "jounce/base/input_errors.hpp"
#include "jounce/base/listed.hpp"
#include "jounce/base/nearest.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/six_digits.hpp"

#include "spec/src/toml/toml_syntax.hpp"

namespace jounce::spec_detail {
namespace {

Document::Place place(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

/// The only permitted word that a longer word contains: "absolute" for "move_absolute"; "" if there is none.
std::string contained(const std::string& given, std::span<const std::string> permitted) {
  constexpr std::size_t least = 4;
  std::string only;
  for (const std::string& word : permitted) {
    if (word.size() < least || given.find(word) == std::string::npos) continue;
    if (!only.empty()) return "";
    only = word;
  }
  return only;
}

/// End of the rule of a number or a flag that is written as another type.
const char* without_quotes(const toml::node& node) {
  const auto real = node.value_exact<double>();
  if (real && *real == std::floor(*real)) return ", without a decimal point or an exponent";
  return node.is_string() ? ", without quotes" : "";
}

/// A long list of words is shown only if no word is near.
std::string rule_of_choice(std::span<const std::string> permitted, const std::string& hint) {
  constexpr std::size_t most = 8;
  const std::string meant = hint.empty() ? "" : ": did you mean \"" + hint + "\"?";
  if (permitted.size() == 1) return "must be \"" + permitted[0] + '"';
  if (permitted.size() > most && !hint.empty()) return "is unknown" + meant;
  return "must be one of " + listed(permitted) + meant;
}

/// "[limits]" or "[[segment]]", for a section of this name; "" for a value on the line of its key.
std::string header_of(const toml::node& node, const std::string& name) {
  const bool array = node.is_array_of_tables();
  const toml::table* const table = array ? node.as_array()->front().as_table() : node.as_table();
  if (table == nullptr || table->is_inline()) return "";
  return array ? "[[" + name + "]]" : "[" + name + "]";
}

/// "; `jounce new cam` writes an example", for the section that a kind of spec requires.
std::string example_of(const toml::table& top, const std::string& section) {
  const auto kind = top["kind"].value<std::string>();
  return kind && *kind == section ? "; `jounce new " + section + "` writes an example" : "";
}

}  // namespace

std::string shown(const toml::node& node) {
  if (node.is_table()) return "{ ... }";
  if (const toml::array* array = node.as_array()) {
    std::string all;
    for (const auto& element : *array) all += (all.empty() ? "" : ", ") + shown(element);
    return "[" + all + "]";
  }
  if (const auto text = node.value_exact<std::string>()) return '"' + printable(*text) + '"';
  if (const auto value = node.value_exact<double>()) return number(*value);
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

void ErrorList::add(const InputError& error) {
  const bool known = std::any_of(all_.begin(), all_.end(), [&](const InputError& other) {
    return other.key() == error.key() && other.line() == error.line() &&
           other.column() == error.column();
  });
  if (!known && all_.size() < most) all_.push_back(error);
}

void ErrorList::throw_any() const {
  if (all_.size() == 1) throw all_.front();
  if (all_.size() > 1) throw InputErrors(all_);
}

TomlReader::TomlReader(const toml::table& table, std::string path, Document& document,
                       ErrorList* errors)
    : table_(&table), path_(std::move(path)), document_(&document), errors_(errors) {
  if (!path_.empty()) document.places.emplace(path_, place(table.source()));
}

std::string TomlReader::path(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void TomlReader::fail(const char* key, const std::string& value, const std::string& rule) {
  throw document_->located(InputError(path(key), value, rule));
}

void TomlReader::report(const InputError& error) const {
  if (errors_ == nullptr) throw error;
  errors_->add(error);
}

/// The value that `read` returns. With an ErrorList, an error of it is added, and the placeholder
/// returned.
template <class Value, class Read>
Value TomlReader::or_else(Value placeholder, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    report(error);
    return placeholder;
  }
}

const toml::node* TomlReader::find(const char* key) {
  known_.insert(key);
  const toml::node* node = table_->get(key);
  if (node != nullptr) document_->places[path(key)] = place(node->source());
  return node;
}

const toml::node& TomlReader::require(const char* key, const std::string& example) {
  const toml::node* node = find(key);
  if (node != nullptr) return *node;
  refuse_misspelt(key);
  fail(key, "", "is missing: add " + example);
}

void TomlReader::refuse_misspelt(const char* key) const {
  const std::string wanted = key;
  for (const auto& [other, node] : *table_)
    if (!known_.contains(std::string(other.str())) &&
        !nearest(other.str(), std::span(&wanted, 1)).empty())
      throw unknown(other, node, "here: did you mean " + wanted + "?");
}

InputError TomlReader::unknown(const toml::key& key, const toml::node& node,
                               const std::string& rule) const {
  const auto at = place(key.source());
  const std::string header = header_of(node, path(key.str()));
  return InputError(header.empty() ? path(key.str()) : header, header.empty() ? shown(node) : "",
                    std::string("is not a ") + (header.empty() ? "key " : "section ") + rule)
      .at(document_->name, at.line, at.column);
}

double TomlReader::read_number(const toml::node& node, const std::string& key,
                               const std::string& unit) {
  document_->units.emplace(key, unit);
  const auto error = [&](const std::string& value, const std::string& rule) {
    const auto at = place(node.source());
    return InputError(key, value, rule).at(document_->name, at.line, at.column);
  };
  if (const auto text = node.value_exact<std::string>()) {
    try {
      if (const auto own = quantity_unit(*text); !own.empty()) document_->given[key] = own;
      return quantity(*text, unit);
    } catch (const InputError& e) {
      throw error('"' + *text + '"', e.rule());
    }
  }
  if (!node.is_number())
    throw error(shown(node), unit.empty() || unit == "1"
                                 ? std::string("must be a number")
                                 : "must be a number in " + unit +
                                       ", or a quantity such as \"12.5 " + unit + '"');
  // Not value<double>(): it returns nothing for an integer beyond 2^53.
  const auto whole = node.value_exact<std::int64_t>();
  const double value =
      whole ? static_cast<double>(*whole) : node.value_exact<double>().value_or(NAN);
  if (!std::isfinite(value)) throw error(shown(node), "must be a finite number");
  return value;
}

double TomlReader::number(const char* key, const std::string& unit) {
  return or_else(1.0, [&] {
    const std::string measure = unit.empty() || unit == "1" ? "" : ", in " + unit;
    return read_number(require(key, std::string(key) + " = NUMBER" + measure), path(key), unit);
  });
}

std::optional<double> TomlReader::optional_number(const char* key, const std::string& unit) {
  const toml::node* node = find(key);
  know(key, unit);
  if (node == nullptr) return std::nullopt;
  return or_else(1.0, [&] { return read_number(*node, path(key), unit); });
}

std::optional<double> TomlReader::optional_positive(const char* key, const std::string& unit) {
  const auto value = optional_number(key, unit);
  if (!value || *value > 0) return value;
  return or_else(1.0,
                 [&]() -> double { fail(key, jounce::number(*value), "must be greater than 0"); });
}

void TomlReader::know(const std::string& key, const std::string& unit) {
  document_->known.emplace(path(key), unit);
}

std::optional<std::string> TomlReader::optional_quantity(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto text = node->value_exact<std::string>(); text && printable(*text) == *text)
    return *text;
  if (!node->is_number()) fail(key, shown(*node), "must be a number, or a quantity in quotes");
  return shown(*node);
}

std::optional<std::size_t> TomlReader::optional_count(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return or_else(std::size_t{1}, [&] {
    const auto value = node->value_exact<std::int64_t>();
    if (!value || *value < 1)
      fail(key, shown(*node),
           std::string("must be a whole number of at least 1") + without_quotes(*node));
    return static_cast<std::size_t>(*value);
  });
}

std::optional<std::int64_t> TomlReader::optional_whole(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return or_else(std::int64_t{1}, [&] {
    const auto value = node->value_exact<std::int64_t>();
    if (!value)
      fail(key, shown(*node), std::string("must be a whole number") + without_quotes(*node));
    return *value;
  });
}

std::int64_t TomlReader::whole(const char* key) {
  return or_else(std::int64_t{1}, [&] {
    require(key, std::string(key) + " = WHOLE NUMBER");
    return *optional_whole(key);
  });
}

std::optional<bool> TomlReader::optional_flag(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return or_else(false, [&] {
    if (!node->is_boolean())
      fail(key, shown(*node), std::string("must be true or false") + without_quotes(*node));
    return *node->value<bool>();
  });
}

std::string TomlReader::text(const char* key, const char* word) {
  require(key, std::string(key) + " = \"" + word + '"');
  return *optional_text(key);
}

std::optional<std::string> TomlReader::optional_text(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value_exact<std::string>();
  if (!value) fail(key, shown(*node), "must be a string in quotes");
  if (!is_printable(*value))
    fail(key, '"' + printable(*value) + '"', "must not contain control characters");
  return value;
}

std::size_t TomlReader::choice(const char* key, std::span<const std::string> permitted) {
  require(key, std::string(key) + " = \"WORD\", where WORD is one of " + listed(permitted));
  const std::string given = *optional_text(key);
  for (std::size_t i = 0; i < permitted.size(); ++i)
    if (permitted[i] == given) return i;
  const std::string near = nearest(given, permitted);
  fail(key, '"' + given + '"',
       rule_of_choice(permitted, near.empty() ? contained(given, permitted) : near));
}

std::optional<std::size_t> TomlReader::optional_choice(const char* key,
                                                       std::span<const std::string> permitted) {
  if (find(key) == nullptr) return std::nullopt;
  return choice(key, permitted);
}

std::size_t TomlReader::variant(const char* key, std::span<const std::string> permitted) {
  const std::size_t chosen = choice(key, permitted);
  describe(std::string(key) + " = \"" + permitted[chosen] + '"');
  return chosen;
}

TomlReader TomlReader::table(const char* key, const std::string& example) {
  require(key, !example.empty()
                   ? example
                   : "the section [" + path(key) + "]" + example_of(*table_, path(key)));
  return *optional_table(key);
}

std::optional<TomlReader> TomlReader::optional_table(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_array_of_tables() && !node->as_array()->front().as_table()->is_inline())
    throw single_brackets(*document_, path(key), place(node->as_array()->front().source()));
  if (!node->is_table())
    fail(key, shown(*node), std::string("must be a table: ") + key + " = { KEY = VALUE, ... }");
  return TomlReader(*node->as_table(), path(key), *document_, errors_);
}

std::vector<TomlReader> TomlReader::tables(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (node->is_table() && !node->as_table()->is_inline())
    throw double_brackets(*document_, path(key), place(node->source()));
  if (array == nullptr)
    fail(key, shown(*node),
         std::string("must be a list of tables: begin each with [[") + path(key) + "]]");
  std::vector<TomlReader> readers;
  for (const auto& element : *array) {
    const std::string name = path(key) + "[" + std::to_string(readers.size() + 1) + "]";
    if (!element.is_table()) {
      const auto at = place(element.source());
      throw InputError(name, shown(element), "must be a table: { KEY = VALUE, ... }")
          .at(document_->name, at.line, at.column);
    }
    readers.emplace_back(*element.as_table(), name, *document_, errors_);
  }
  return readers;
}

std::optional<std::pair<double, double>> TomlReader::optional_pair(const char* key,
                                                                   const std::string& unit) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return or_else(std::pair{0.0, 1.0}, [&] {
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != 2)
      fail(key, shown(*node), std::string("must be two numbers: ") + key + " = [lower, upper]");
    return std::pair{read_number(*array->get(0), path(key), unit),
                     read_number(*array->get(1), path(key), unit)};
  });
}

std::optional<std::pair<double, double>> TomlReader::optional_range(const char* key,
                                                                    const std::string& unit) {
  const toml::node* node = find(key);
  if (node == nullptr || node->is_array()) return optional_pair(key, unit);
  const double value = or_else(1.0, [&] { return read_number(*node, path(key), unit); });
  return std::pair{value, value};
}

bool TomlReader::holds_tables(const char* key) {
  const toml::node* node = find(key);
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  return array != nullptr && !array->empty() && array->front().is_table();
}

std::vector<double> TomlReader::numbers(const char* key, std::span<const std::string> units,
                                        const std::string& each) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() != units.size())
    fail(key, shown(*node), "must be a list of " + counted(units.size(), "number") + each);
  std::vector<double> all;
  for (const std::string& unit : units)
    all.push_back(read_number(*array->get(all.size()),
                              path(key) + "[" + std::to_string(all.size() + 1) + "]", unit));
  return all;
}

std::vector<double> TomlReader::number_list(const char* key, const std::string& unit) {
  const toml::node& node = require(key, std::string(key) + " = [NUMBER, ...]");
  const toml::array* array = node.as_array();
  if (array == nullptr)
    fail(key, shown(node), std::string("must be a list of numbers: ") + key + " = [NUMBER, ...]");
  std::vector<double> all;
  for (const auto& element : *array)
    all.push_back(
        read_number(element, path(key) + "[" + std::to_string(all.size() + 1) + "]", unit));
  return all;
}

bool TomlReader::is_text(const char* key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_string();
}

bool TomlReader::is_table(const char* key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_table();
}

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, node] : *table_) all.emplace_back(key.str());
  return all;
}

std::vector<std::string> TomlReader::texts(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr)
    fail(key, shown(*node),
         std::string("must be a list of strings: ") + key + " = [" +
             (node->is_string() ? shown(*node) : "\"TEXT\", ...") + "]");
  std::vector<std::string> all;
  for (const auto& element : *array) {
    const auto value = element.value_exact<std::string>();
    if (!value) fail(key, shown(element), "must be a string in quotes");
    all.push_back(*value);
  }
  return all;
}

void TomlReader::refuse_here(const char* key, const std::string& where) {
  const toml::node* node = table_->get(key);
  if (node == nullptr) return;
  known_.insert(key);
  const auto at = place(node->source());
  report(InputError(path(key), shown(*node), where).at(document_->name, at.line, at.column));
}

void TomlReader::finish() {
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& [key, node] : *table_) {
    if (known_.contains(std::string(key.str()))) continue;
    if (const std::string hint = nearest(key.str(), known); !hint.empty()) {
      report(unknown(key, node, "here: did you mean " + hint + "?"));
      continue;
    }
    report(unknown(key, node,
                   (what_.empty() ? "here" : "of " + what_) + "; possible keys" +
                       (path_.empty() ? " and sections: " : ": ") + listed(known)));
  }
}

}  // namespace jounce::spec_detail

// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

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

constexpr double no_number =
    std::numeric_limits<double>::quiet_NaN();  ///< instead of a number that is not finite

/// A long list of words is shown only if no word is near.
std::string rule_of_choice(std::span<const std::string> permitted, const std::string& hint,
                           const char* unknown) {
  constexpr std::size_t most = 8;
  const std::string meant = hint.empty() ? "" : ": did you mean \"" + hint + "\"?";
  if (permitted.size() == 1) return "must be \"" + permitted[0] + '"';
  if (permitted.size() > most && !hint.empty()) return "is unknown" + meant;
  if (unknown != nullptr && hint.empty()) return unknown;
  return "must be one of " + listed(permitted) + meant;
}

/// "[limits]" or "[[segment]]", for a section of this name; "" for a value on the line of its key.
std::string header_of(const toml::node& node, const std::string& name) {
  const bool array = node.is_array_of_tables();
  const toml::table* const table = array ? node.as_array()->front().as_table() : node.as_table();
  if (table == nullptr || table->is_inline()) return "";
  return array ? "[[" + name + "]]" : "[" + name + "]";
}

/// header_of() a section, or the key of a value.
std::string bracketed(const toml::node& node, const std::string& name, const std::string& key) {
  const std::string header = header_of(node, name);
  return header.empty() ? key : header;
}

/// True for a key that stands at the top of every file, before its sections.
bool is_of_file(std::string_view key) {
  return key == "jounce" || key == "kind" || key == "units";
}

/// The rule of a key of the file that stands in a section.
const char* const below_header =
    "is a key of the whole file: move this line up, before the first section";

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
  if (const auto value = node.value_exact<double>()) {
    const std::string text = number(*value);
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
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
  const toml::node* const node = table_->get(key);
  if (node != nullptr) document_->places.emplace(path(key), place(node->source()));
  const bool shows = value.empty() && node != nullptr && node->is_value();
  throw document_->located(InputError(path(key), shows ? shown(*node) : value, rule));
}

void TomlReader::fail_all(const char* key, const std::string& value, const std::string& rule) {
  try {
    fail(key, value, rule);
  } catch (const InputError& error) {
    end_all(error);
  }
}

void TomlReader::end_all(const InputError& error) const {
  report(error);
  throw PartEnded{};
}

void TomlReader::report(const InputError& error) const {
  if (errors_ == nullptr) throw error;
  if (!unread_) errors_->add(error);
}

void TomlReader::end_part(const InputError& error) const {
  for (const InputError& one : all_errors(error)) errors_->end_part(document_->located(one));
}

bool TomlReader::is_faulty(const char* key) const {
  return unread_ || (errors_ != nullptr && errors_->is_faulty(path(key)));
}

bool TomlReader::left_out(const char* key) const {
  return !unread_ && is_faulty(key) && errors_->leaves_out();
}

std::optional<std::string> TomlReader::placeholder(const char* key,
                                                   std::span<const char* const> words) {
  if (!is_faulty(key)) return std::nullopt;
  find(key);
  errors_->use();
  return words[errors_->choice(words.size())];
}

/// The value that `read` returns. With an ErrorList, an error of it is added, and the placeholder
/// returned.
template <class Value, class Read>
Value TomlReader::or_else(const char* key, const Value& placeholder, Read read) {
  if (!is_faulty(key)) {
    try {
      return read();
    } catch (const InputError& error) {
      report(error);
    }
  }
  find(key);
  errors_->use();
  return placeholder;
}

/// The same for a key that may be missing.
template <class Value, class Read>
std::optional<Value> TomlReader::optional_or_else(const char* key, const Value& placeholder,
                                                  Read read) {
  const toml::node* node = find(key);
  if (left_out(key) || (node == nullptr && (unread_ || !is_faulty(key)))) return std::nullopt;
  return or_else(key, placeholder, [&] { return Value(read(*node)); });
}

const toml::node* TomlReader::find(const char* key) {
  known_.insert(key);
  const toml::node* node = table_->get(key);
  if (node != nullptr) document_->places[path(key)] = place(node->source());
  return left_out(key) ? nullptr : node;
}

const toml::node* TomlReader::given(const char* key) const {
  return left_out(key) ? nullptr : table_->get(key);
}

const toml::node& TomlReader::require(const char* key, const std::string& example) {
  const toml::node* node = find(key);
  if (node != nullptr) return *node;
  refuse_misspelt(key);
  refuse_below_header(key);
  fail(key, "", "is missing: add " + example);
}

void TomlReader::refuse_below_header(const char* key) const {
  if (!path_.empty() || !(is_of_file(key) || key == std::string_view("start"))) return;
  for (const auto& [name, section] : *table_) {
    const toml::array* const all = section.as_array();
    const std::size_t count = all == nullptr ? 1 : all->size();
    for (std::size_t i = 0; i < count; ++i) {
      const toml::node& one = all == nullptr ? section : *all->get(i);
      const toml::node* const node = one.is_table() ? one.as_table()->get(key) : nullptr;
      const bool possible = is_of_file(key) || name.str() == "segment";
      if (node == nullptr || !possible || !header_of(*node, key).empty()) continue;
      const std::string index = all == nullptr ? "" : "[" + std::to_string(i + 1) + "]";
      const auto at = place(node->source());
      const std::string section_key = std::string(name.str()) + index + "." + key;
      throw InputError(section_key, shown(*node), below_header)
          .at(document_->name, at.line, at.column);
    }
  }
}

void TomlReader::refuse_misspelt(const char* key) const {
  const std::string wanted = key;
  for (const auto& [other, node] : *table_)
    if (!known_.contains(std::string(other.str())) &&
        !nearest(other.str(), std::span(&wanted, 1)).empty())
      throw unknown(other, node,
                    "here: did you mean " + bracketed(node, path(wanted), wanted) + "?");
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
  const double value = or_else(key, no_number, [&] {
    const std::string measure = unit.empty() || unit == "1" ? "" : ", in " + unit;
    return read_number(require(key, std::string(key) + " = NUMBER" + measure), path(key), unit);
  });
  return std::isnan(value) ? errors_->number(path(key), unit) : value;
}

std::optional<double> TomlReader::optional_number(const char* key, const std::string& unit) {
  know(key, unit);
  auto value = optional_or_else(
      key, no_number, [&](const toml::node& node) { return read_number(node, path(key), unit); });
  if (value && std::isnan(*value)) value = errors_->number(path(key), unit);
  return value;
}

std::optional<double> TomlReader::optional_positive(const char* key, const std::string& unit) {
  know(key, unit);
  return optional_or_else(key, 1.0, [&](const toml::node& node) {
    const double value = read_number(node, path(key), unit);
    if (!(value > 0)) fail(key, jounce::number(value), "must be greater than 0");
    return value;
  });
}

void TomlReader::know(const std::string& key, const std::string& unit) {
  document_->known.emplace(path(key), unit);
}

std::optional<std::string> TomlReader::optional_quantity(const char* key) {
  return optional_or_else(key, std::string("1"), [&](const toml::node& node) {
    if (const auto text = node.value_exact<std::string>(); text && printable(*text) == *text)
      return *text;
    if (!node.is_number()) fail(key, shown(node), "must be a number, or a quantity in quotes");
    return shown(node);
  });
}

std::optional<std::size_t> TomlReader::optional_count(const char* key) {
  return optional_or_else(key, std::size_t{1}, [&](const toml::node& node) {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 1)
      fail(key, shown(node),
           std::string("must be a whole number of at least 1") + without_quotes(node));
    return static_cast<std::size_t>(*value);
  });
}

std::optional<std::int64_t> TomlReader::optional_whole(const char* key) {
  return optional_or_else(key, std::int64_t{1}, [&](const toml::node& node) {
    const auto value = node.value_exact<std::int64_t>();
    if (!value)
      fail(key, shown(node), std::string("must be a whole number") + without_quotes(node));
    return *value;
  });
}

std::int64_t TomlReader::whole(const char* key) {
  return or_else(key, std::int64_t{1}, [&] {
    require(key, std::string(key) + " = WHOLE NUMBER");
    return optional_whole(key).value_or(1);
  });
}

std::optional<bool> TomlReader::optional_flag(const char* key) {
  return optional_or_else(key, errors_ != nullptr && errors_->flag(), [&](const toml::node& node) {
    if (!node.is_boolean())
      fail(key, shown(node), std::string("must be true or false") + without_quotes(node));
    return *node.value<bool>();
  });
}

std::string TomlReader::text(const char* key, const char* word) {
  return or_else(key, path(key), [&] {
    require(key, std::string(key) + " = \"" + word + '"');
    return optional_text(key).value_or(path(key));
  });
}

std::optional<std::string> TomlReader::optional_text(const char* key) {
  return optional_or_else(key, path(key), [&](const toml::node& node) {
    const auto value = node.value_exact<std::string>();
    if (!value) fail(key, shown(node), "must be a string in quotes");
    if (!is_printable(*value))
      fail(key, '"' + printable(*value) + '"', "must not contain control characters");
    return *value;
  });
}

/// `hint`: receives the permitted word that is meant, if there is one.
std::size_t TomlReader::read_choice(const char* key, std::span<const std::string> permitted,
                                    std::string& hint, const char* unknown) {
  const toml::node& node =
      require(key, std::string(key) + " = \"WORD\", where WORD is one of " + listed(permitted));
  const auto given = node.value_exact<std::string>();
  if (!given) fail(key, shown(node), "must be a string in quotes");
  if (!is_printable(*given))
    fail(key, '"' + printable(*given) + '"', "must not contain control characters");
  for (std::size_t i = 0; i < permitted.size(); ++i)
    if (permitted[i] == *given) return i;
  hint = nearest(*given, permitted);
  if (hint.empty()) hint = contained(*given, permitted);
  fail(key, '"' + *given + '"', rule_of_choice(permitted, hint, unknown));
}

std::size_t TomlReader::choice(const char* key, std::span<const std::string> permitted,
                               const char* unknown) {
  std::string hint;
  const std::size_t chosen =
      or_else(key, permitted.size(), [&] { return read_choice(key, permitted, hint, unknown); });
  if (chosen < permitted.size()) return chosen;
  const auto meant = std::find(permitted.begin(), permitted.end(), hint);
  return meant != permitted.end() ? static_cast<std::size_t>(meant - permitted.begin())
                                  : errors_->choice(permitted.size());
}

std::optional<std::size_t> TomlReader::optional_choice(const char* key,
                                                       std::span<const std::string> permitted,
                                                       const char* unknown) {
  if (find(key) == nullptr) return std::nullopt;
  return choice(key, permitted, unknown);
}

std::size_t TomlReader::variant(const char* key, std::span<const std::string> permitted) {
  if (is_faulty(key)) throw PartEnded{};
  std::string hint;
  std::size_t chosen = permitted.size();
  try {
    chosen = read_choice(key, permitted, hint);
  } catch (const InputError& error) {
    report(error);
    const auto meant = std::find(permitted.begin(), permitted.end(), hint);
    if (meant == permitted.end()) throw PartEnded{};
    chosen = static_cast<std::size_t>(meant - permitted.begin());
  }
  describe(std::string(key) + " = \"" + permitted[chosen] + '"');
  return chosen;
}

TomlReader TomlReader::unread_table(const std::string& name) const {
  static const toml::table nothing;
  TomlReader reader(nothing, name, *document_, errors_);
  reader.unread_ = true;
  errors_->ignore(name + '.');
  errors_->use();
  return reader;
}

TomlReader TomlReader::table(const char* key, const std::string& example) {
  try {
    if (unread_) return unread_table(path(key));
    require(key, !example.empty()
                     ? example
                     : "the section [" + path(key) + "]" + example_of(*table_, path(key)));
  } catch (const InputError& error) {
    report(error);
    return unread_table(path(key));
  }
  auto given = optional_table(key);
  return given ? std::move(*given) : unread_table(path(key));
}

std::optional<TomlReader> TomlReader::optional_table(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_table()) return TomlReader(*node->as_table(), path(key), *document_, errors_);
  try {
    if (node->is_array_of_tables() && !node->as_array()->front().as_table()->is_inline())
      throw single_brackets(*document_, path(key), place(node->as_array()->front().source()));
    fail(key, shown(*node), std::string("must be a table: ") + key + " = { KEY = VALUE, ... }");
  } catch (const InputError& error) {
    report(error);
    return unread_table(path(key));
  }
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
    if (element.is_table()) {
      readers.emplace_back(*element.as_table(), name, *document_, errors_);
      continue;
    }
    const auto at = place(element.source());
    report(InputError(name, shown(element), "must be a table: { KEY = VALUE, ... }")
               .at(document_->name, at.line, at.column));
    readers.push_back(unread_table(name));
  }
  return readers;
}

std::optional<std::pair<double, double>> TomlReader::optional_pair(const char* key,
                                                                   const std::string& unit) {
  return optional_or_else(key, std::pair{0.0, 1.0}, [&](const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 2)
      fail(key, shown(node), std::string("must be two numbers: ") + key + " = [least, greatest]");
    return std::pair{read_number(*array->get(0), path(key), unit),
                     read_number(*array->get(1), path(key), unit)};
  });
}

std::optional<std::pair<double, double>> TomlReader::optional_range(const char* key,
                                                                    const std::string& unit) {
  const toml::node* node = find(key);
  if (node == nullptr || node->is_array()) return optional_pair(key, unit);
  const double value = or_else(key, 1.0, [&] { return read_number(*node, path(key), unit); });
  return std::pair{value, value};
}

bool TomlReader::holds_tables(const char* key) {
  const toml::node* node = find(key);
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  return array != nullptr && !array->empty() && array->front().is_table();
}

std::vector<double> TomlReader::numbers(const char* key, std::span<const std::string> units,
                                        const std::string& each, std::size_t least) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (!units.empty()) document_->units.emplace(path(key), units.front());
  return or_else(key, std::vector<double>(units.size(), 1.0), [&] {
    const toml::array* array = node->as_array();
    if (array == nullptr ||
        (array->size() != units.size() && (least == 0 || array->size() != least)))
      fail(key, shown(*node), "must be a list of " + counted(units.size(), "number") + each);
    std::vector<double> all;
    for (const std::string& unit : units.first(array->size()))
      all.push_back(element(key, *array, all.size(), unit));
    return all;
  });
}

std::vector<double> TomlReader::number_list(const char* key, const std::string& unit) {
  return or_else(key, std::vector<double>{1.0}, [&] {
    const toml::node& node = require(key, std::string(key) + " = [NUMBER, ...]");
    const toml::array* array = node.as_array();
    if (array == nullptr)
      fail(key, shown(node), std::string("must be a list of numbers: ") + key + " = [NUMBER, ...]");
    std::vector<double> all;
    while (all.size() < array->size()) all.push_back(element(key, *array, all.size(), unit));
    return all;
  });
}

double TomlReader::element(const char* key, const toml::array& array, std::size_t index,
                           const std::string& unit) {
  const std::string name = std::string(key) + "[" + std::to_string(index + 1) + "]";
  return or_else(name.c_str(), 1.0,
                 [&] { return read_number(*array.get(index), path(name), unit); });
}

bool TomlReader::is_text(const char* key) const {
  const toml::node* node = given(key);
  return node != nullptr && node->is_string();
}

bool TomlReader::is_table(const char* key) const {
  const toml::node* node = given(key);
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
  return or_else(key, std::vector<std::string>{}, [&] {
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
  });
}

void TomlReader::refuse_here(const char* key, const std::string& where) {
  const toml::node* node = table_->get(key);
  if (node == nullptr) return;
  known_.insert(key);
  const auto at = place(node->source());
  const std::string header = header_of(*node, path(key));
  report(InputError(header.empty() ? path(key) : header, header.empty() ? shown(*node) : "", where)
             .at(document_->name, at.line, at.column));
}

void TomlReader::finish() {
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& [key, node] : *table_) {
    if (known_.contains(std::string(key.str()))) continue;
    if (is_faulty(std::string(key.str()).c_str())) continue;  // has an error of its own
    if (!path_.empty() &&
        (is_of_file(key.str()) || (key.str() == "start" && path_.starts_with("segment[")))) {
      refuse_here(std::string(key.str()).c_str(), below_header);
      continue;
    }
    if (const std::string hint = nearest(key.str(), known); !hint.empty()) {
      if (errors_ != nullptr && !has(hint.c_str())) errors_->misspelled(path(hint));
      report(unknown(key, node, "here: did you mean " + bracketed(node, path(hint), hint) + "?"));
      continue;
    }
    report(unknown(key, node,
                   (what_.empty() ? "here" : "of " + what_) + "; possible keys" +
                       (path_.empty() ? " and sections: " : ": ") + listed(known)));
  }
}

}  // namespace jounce::spec_detail

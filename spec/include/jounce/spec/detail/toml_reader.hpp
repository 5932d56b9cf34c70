// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "jounce/base/document.hpp"

namespace jounce::spec_detail {

/// The errors of a document while it is read: a reader goes on after an error as far as the rest does not depend on it.
class ErrorList {
 public:
  /// Adds the error, unless it is there already: the same key at the same place.
  void add(const InputError& error);
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  /// Throws the last error again.
  [[noreturn]] void throw_last() const { throw all_.back(); }
  /// Throws the error if there is one, InputErrors if there are several.
  void throw_any() const;

 private:
  static constexpr std::size_t most = 1000;  ///< later ones are dropped
  std::vector<InputError> all_;
};

/// One table of a TOML document while it is read. Every getter records the key and its
/// place; finish() rejects all keys that no getter read.
///
/// With an ErrorList, an error of a number, a count or a flag and an unknown key are added to it, and reading goes on:
/// the getter returns a placeholder. Any other error is thrown, to the end of its part: see attempt().
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string path, Document& document,
             ErrorList* errors = nullptr);
  TomlReader(TomlReader&&) = default;  // moved only: a copy would forget what it has read
  TomlReader& operator=(TomlReader&&) = default;

  /// A number, or a quantity with unit in quotes, in `unit`.
  double number(const char* key, const std::string& unit);
  std::optional<double> optional_number(const char* key, const std::string& unit);
  /// A number or a quantity as written, if its unit is known only later.
  std::optional<std::string> optional_quantity(const char* key);
  std::optional<std::size_t> optional_count(const char* key);
  /// A whole number of any sign.
  std::optional<std::int64_t> optional_whole(const char* key);
  std::int64_t whole(const char* key);
  std::optional<bool> optional_flag(const char* key);
  /// The error of a missing key shows KEY = "word".
  std::string text(const char* key, const char* word = "TEXT");
  std::optional<std::string> optional_text(const char* key);
  /// The index of a text among the permitted ones.
  std::size_t choice(const char* key, std::span<const std::string> permitted);
  std::optional<std::size_t> optional_choice(const char* key,
                                             std::span<const std::string> permitted);

  std::optional<TomlReader> optional_table(const char* key);
  /// `example`: what the message of a missing table advises to add; by default, the section [key].
  TomlReader table(const char* key, const std::string& example = "");
  /// [[key]] or key = [{...}, ...]; empty if there is none. Counted from 1 in messages.
  std::vector<TomlReader> tables(const char* key);
  /// key = [a, b] of two numbers.
  std::optional<std::pair<double, double>> optional_pair(const char* key, const std::string& unit);
  /// key = a, the same as [a, a], or key = [a, b].
  std::optional<std::pair<double, double>> optional_range(const char* key, const std::string& unit);
  /// Reads a part on which no other part depends. With an ErrorList an error of it is added, and false returned. An
  /// error that is thrown after another one in the same part is dropped: a placeholder may have caused it.
  template <class Read>
  bool attempt(Read read) {
    if (errors_ == nullptr) {
      read();
      return true;
    }
    const std::size_t before = errors_->size();
    try {
      read();
      return true;
    } catch (const InputError& error) {
      if (errors_->size() == before) errors_->add(document_->located(error));
      return false;
    }
  }
  /// Calls read(reader) for each of tables(key). An error in one of them is thrown after the last: they are independent
  /// of each other, and the rest depends on all.
  template <class Read>
  void for_each(const char* key, Read read) {
    bool whole = true;
    for (TomlReader& each : tables(key)) whole = each.attempt([&] { read(each); }) && whole;
    if (!whole) errors_->throw_last();
  }
  /// True if key holds tables: [[key]] or key = [{...}, ...].
  bool holds_tables(const char* key);
  /// key = [a, b, ...]: one number for each unit; nothing if the key is missing.
  std::vector<double> numbers(const char* key, std::span<const std::string> units);
  /// key = [a, b, ...]: any number of numbers.
  std::vector<double> number_list(const char* key, const std::string& unit);
  std::vector<std::string> texts(const char* key);

  [[nodiscard]] const Document& document() const { return *document_; }
  /// Line of the table.
  [[nodiscard]] int line() const { return static_cast<int>(table_->source().begin.line); }
  [[nodiscard]] bool has(const char* key) const { return table_->contains(key); }
  [[nodiscard]] bool is_text(const char* key) const;
  [[nodiscard]] bool is_table(const char* key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The full name of a key, as messages show it: "segment[2].end.master".
  [[nodiscard]] std::string path(std::string_view key) const;
  /// Throws InputError if an unread key is a misspelling of `key`. Called before `key` is reported
  /// as missing.
  void refuse_misspelt(const char* key) const;
  [[noreturn]] void fail(const char* key, const std::string& value, const std::string& rule);
  void finish();

 private:
  const toml::node* find(const char* key);
  /// `example`: what the message of a missing key advises to add.
  const toml::node& require(const char* key, const std::string& example);
  [[nodiscard]] InputError unknown(const toml::key& key, const toml::node& node,
                                   const std::string& meant) const;
  double read_number(const toml::node& node, const std::string& key, const std::string& unit);
  void report(const InputError& error) const;
  template <class Value, class Read>
  Value or_else(Value placeholder, Read read);

  const toml::table* table_;
  std::string path_;
  Document* document_;
  ErrorList* errors_;
  std::set<std::string> known_;
};

/// The document as TOML. Throws InputError, placed: an empty file, a slip of the syntax.
toml::table parse_toml(const Document& document);

/// `jounce = 1`, at the start of every file.
void require_version(TomlReader& top);

/// The text of a value as written in the document, for messages.
std::string shown(const toml::node& node);

}  // namespace jounce::spec_detail

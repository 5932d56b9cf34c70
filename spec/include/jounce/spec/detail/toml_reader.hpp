// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <toml++/toml.h>

#include "jounce/base/document.hpp"

namespace jounce {

struct Spec;

namespace spec_detail {

/// Ends the reading of a part whose error is already in the ErrorList.
struct PartEnded {};

/// Ends the reading of a document that has ErrorList::most errors.
struct TooManyErrors {};

/// Collects all errors of a document, without those that only follow from others. For this purpose,
/// the document is read several times; see read_document().
///
/// A faulty value is replaced by a placeholder, and reading continues. An error that a reader
/// throws ends its part. In the next pass, its key has a placeholder too, so that the pass reaches
/// the next error. The passes end when they find no new error.
///
/// An error after a placeholder may follow from it. The passes are then repeated with other
/// placeholders: between the values of the neighbors in a list, without the key, great, small,
/// negative. The smallest result is reported, because a placeholder that fits causes no other
/// error.
class ErrorList {
 public:
  explicit ErrorList(const toml::table& root) : root_(&root) {}

  /// Adds the error, unless there is already an error with the same key at the same place. Throws
  /// TooManyErrors with the last error that the list takes.
  bool add(const InputError& error);
  /// Adds the error that ended a part. Its key has a placeholder in the next pass.
  void end_part(const InputError& error);
  /// Ignores all errors of the keys of this table, which could not be read.
  void ignore(const std::string& table) { ignored_.insert(table); }
  /// Leaves out the error that this key is missing: another key misspells it.
  void misspelled(const std::string& key) { misspelled_.insert(key); }
  /// Ends a pass. Returns true if another pass is necessary.
  bool again();
  /// Throws if there are errors: a single one as InputError, several as InputErrors.
  void throw_any() const;
  /// Throws the errors of the present pass, after TooManyErrors.
  [[noreturn]] void throw_all();

  /// True for the key of an error that ended a part.
  [[nodiscard]] bool is_faulty(const std::string& key) const { return faulty_.contains(key); }
  /// True if an optional key with an error is left out.
  [[nodiscard]] bool leaves_out() const { return guess_ % 2 == 1; }
  /// Placeholders for the value of `key`: a number in `unit`, and one of `count` words.
  double number(const std::string& key, const std::string& unit);
  std::size_t choice(std::size_t count);
  [[nodiscard]] bool flag() const { return guess_ % 2 == 1; }
  /// Number of placeholders that were used in this pass.
  [[nodiscard]] std::size_t placeholders() const { return placeholders_; }
  /// Counts a placeholder.
  void use() { ++placeholders_; }

 private:
  static constexpr std::size_t most = 1000;         ///< greatest number of errors
  static constexpr std::size_t least_guesses = 13;  ///< number of sets of placeholders
  static constexpr std::size_t most_passes = 1000;  ///< limit for all placeholders together

  /// The result of the passes with one set of placeholders. A part that could not be read may hide
  /// errors.
  struct Result {
    std::size_t unread = 0;
    std::vector<InputError> errors = {};
    /// Document, line, column and key of each error.
    std::set<std::tuple<std::string, int, int, std::string>> places = {};
  };

  const toml::table* root_;
  std::size_t guess_ = 0;                ///< number of the set of placeholders
  std::size_t guesses_ = least_guesses;  ///< number of sets; more if a word has an error
  std::size_t passes_ = 0;
  std::size_t placeholders_ = 0;
  bool ended_ = false;      ///< an error that was not known ended a part of this pass
  bool uncertain_ = false;  ///< an error may follow from a placeholder
  std::set<std::string> faulty_;
  std::set<std::string> ignored_;
  std::set<std::string> misspelled_;
  Result found_;  ///< result of the present placeholders
  std::optional<Result> best_;
};

/// Reads one table of a TOML document. Every getter records its key and the key's place. finish()
/// rejects all keys that no getter has read.
///
/// With an ErrorList, an error in a value, and an unknown key, are added to the list; the getter
/// then returns a placeholder, and reading continues. An error that fail() throws ends the part;
/// see attempt().
///
/// A getter `optional_...` returns nullopt for a missing key. Any other getter throws InputError if
/// the key is missing.
class TomlReader {
 public:
  /// `path`: the full name of the table, for messages.
  TomlReader(const toml::table& table, std::string path, Document& document,
             ErrorList* errors = nullptr);
  TomlReader(TomlReader&&) = default;  // not copied: a copy would not record keys
  TomlReader& operator=(TomlReader&&) = default;

  /// A number, or a text with a number and a unit; the result is in `unit`.
  double number(const char* key, const std::string& unit);
  std::optional<double> optional_number(const char* key, const std::string& unit);
  /// A number greater than 0.
  std::optional<double> optional_positive(const char* key, const std::string& unit);
  /// Records the unit of a number that a library requires, for the error of a missing key.
  void know(const std::string& key, const std::string& unit);
  /// A number or a quantity as written, for a unit that is known only later.
  std::optional<std::string> optional_quantity(const char* key);
  std::optional<std::size_t> optional_count(const char* key);
  /// A whole number of any sign.
  std::optional<std::int64_t> optional_whole(const char* key);
  std::int64_t whole(const char* key);
  std::optional<bool> optional_flag(const char* key);
  /// A text. The error of a missing key shows KEY = "word".
  std::string text(const char* key, const char* word = "TEXT");
  std::optional<std::string> optional_text(const char* key);
  /// Returns the index of the key's text in `permitted`. `unknown`: rule for a text that is near none of
  /// them; by default, the rule lists all.
  std::size_t choice(const char* key, std::span<const std::string> permitted,
                     const char* unknown = nullptr);
  std::optional<std::size_t> optional_choice(const char* key,
                                             std::span<const std::string> permitted,
                                             const char* unknown = nullptr);
  /// Like choice(), for the text that determines the other keys of the table: see describe().
  std::size_t variant(const char* key, std::span<const std::string> permitted);
  /// Describes the table in the errors of finish(): `is not a key of WHAT`.
  void describe(const std::string& what) { what_ = what; }

  std::optional<TomlReader> optional_table(const char* key);
  /// `example`: what the message for a missing table proposes to add; default: the section [key].
  TomlReader table(const char* key, const std::string& example = "");
  /// Returns the tables of [[key]] or key = [{...}, ...]; empty if there are none. Messages count
  /// them from 1.
  std::vector<TomlReader> tables(const char* key);
  /// Two numbers: key = [a, b].
  std::optional<std::pair<double, double>> optional_pair(const char* key, const std::string& unit);
  /// Two numbers: key = [a, b]; or one, key = a, which means [a, a].
  std::optional<std::pair<double, double>> optional_range(const char* key, const std::string& unit);
  /// Reads a part on which no other part depends. With an ErrorList, the function adds an error of
  /// the part to the list and returns false.
  template <class Read>
  bool attempt(Read read) {
    if (errors_ == nullptr) {
      read();
      return true;
    }
    try {
      read();
      return true;
    } catch (const PartEnded&) {
    } catch (const InputError& error) {
      end_part(error);
    }
    return false;
  }
  /// Calls read(reader) for each of tables(key). An error in one of them ends the part after the
  /// last one, because the tables do not depend on each other, but the rest of the part depends on
  /// all of them.
  template <class Read>
  void for_each(const char* key, Read read) {
    bool whole = true;
    for (TomlReader& each : tables(key)) whole = each.attempt([&] { read(each); }) && whole;
    if (!whole) throw PartEnded{};
  }
  /// True if the key contains tables: [[key]] or key = [{...}, ...].
  bool holds_tables(const char* key);
  /// Returns the numbers of key = [a, b, ...], one for each unit; empty if the key is missing.
  /// `each`: end of the error for another count, such as ", one for each axis". `least`: another
  /// count that is possible; the list then ends there.
  std::vector<double> numbers(const char* key, std::span<const std::string> units,
                              const std::string& each = "", std::size_t least = 0);
  /// Returns the numbers of key = [a, b, ...], in `unit`.
  std::vector<double> number_list(const char* key, const std::string& unit);
  std::vector<std::string> texts(const char* key);  ///< the texts of key = ["a", "b", ...]

  /// Number of placeholders that were used so far, instead of faulty values of the document.
  [[nodiscard]] std::size_t placeholders() const {
    return errors_ == nullptr ? 0 : errors_->placeholders();
  }
  /// True for a key with an error that ended its part in an earlier pass, and for all keys of a
  /// table that could not be read.
  [[nodiscard]] bool is_faulty(const char* key) const;
  /// One of `words` as the placeholder of a key with an error; nullopt for any other key.
  std::optional<std::string> placeholder(const char* key, std::span<const char* const> words);
  [[nodiscard]] const Document& document() const { return *document_; }
  /// Line of the table in the document.
  [[nodiscard]] int line() const { return static_cast<int>(table_->source().begin.line); }
  [[nodiscard]] bool has(const char* key) const { return given(key) != nullptr; }
  /// Records that an error of the number `key` concerns the number `given` of the text, which is
  /// `factor` times as great.
  void convert(const char* key, const char* given, double factor) {
    document_->converted[path(key)] = {path(given), factor};
  }
  /// Records files that the document names, in Document::files.
  void record_files(const std::vector<std::string>& files) const {
    document_->files.insert(document_->files.end(), files.begin(), files.end());
  }
  /// Calls `read`, which reads the file `file` that `key` names, and records this file and those
  /// that it names. If the file cannot be read, the error gets the place of the key.
  template <class Read>
  auto file_of(const char* key, const std::string& file, Read read) const {
    try {
      auto made = read();
      record_files({file});
      if constexpr (requires { made.document.files; }) record_files(made.document.files);
      return made;
    } catch (const InputError& error) {
      throw document_->naming(path(key), file, error);
    }
  }
  /// Records the unit of a quantity that rules name by this word: Document::nouns.
  void name_quantity(const char* noun, const std::string& unit) { document_->nouns[noun] = unit; }
  /// Names a key that is possible here, whether or not it is read: finish() lists it.
  void may_have(const char* key) { known_.insert(key); }
  [[nodiscard]] bool is_text(const char* key) const;
  [[nodiscard]] bool is_table(const char* key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// Returns the full name of a key in messages: "segment[2].end.master".
  [[nodiscard]] std::string path(std::string_view key) const;
  /// Throws InputError if a key that was not read is a misspelling of `key`. Call it before
  /// reporting `key` as missing.
  void refuse_misspelt(const char* key) const;
  /// Throws InputError if a key of the whole file, such as `kind`, stands in one of the sections of this table.
  void refuse_below_header(const char* key) const;
  /// Throws or adds an InputError for a key, with its place.
  [[noreturn]] void fail(const char* key, const std::string& value, const std::string& rule);
  /// Like fail(), for a key that determines the meaning of all others: they are not read.
  [[noreturn]] void fail_all(const char* key, const std::string& value, const std::string& rule);
  /// Ends the reading of the document with this error, without a search for further ones.
  [[noreturn]] void end_all(const InputError& error) const;
  void finish();  ///< rejects all keys that were not read
  /// Rejects a key that belongs in another table; `where`: "belongs in the segment, beside end".
  void refuse_here(const char* key, const std::string& where);

 private:
  /// The value of a key, and its place; nullptr if the key is missing, or left out because of its
  /// error.
  const toml::node* find(const char* key);
  [[nodiscard]] const toml::node* given(const char* key) const;
  /// `example`: what the message for a missing key proposes to add.
  const toml::node& require(const char* key, const std::string& example);
  [[nodiscard]] InputError unknown(const toml::key& key, const toml::node& node,
                                   const std::string& rule) const;
  double read_number(const toml::node& node, const std::string& key, const std::string& unit);
  /// Reads an element of a list of numbers.
  double element(const char* key, const toml::array& array, std::size_t index,
                 const std::string& unit);
  std::size_t read_choice(const char* key, std::span<const std::string> permitted,
                          std::string& hint, const char* unknown = nullptr);
  void report(const InputError& error) const;
  void end_part(const InputError& error) const;
  [[nodiscard]] bool left_out(const char* key) const;
  template <class Value, class Read>
  Value or_else(const char* key, const Value& placeholder, Read read);
  template <class Value, class Read>
  std::optional<Value> optional_or_else(const char* key, const Value& placeholder, Read read);
  /// The reader of a table that could not be read: it returns placeholders, and reports no errors.
  [[nodiscard]] TomlReader unread_table(const std::string& name) const;

  const toml::table* table_;
  std::string path_;
  Document* document_;
  ErrorList* errors_;
  std::set<std::string> known_;
  std::string what_ = {};  ///< description of the table; "": none
  bool unread_ = false;    ///< the table is missing, or is no table
};

/// Returns the result of read(errors), which reads a document into a value of its own with this
/// ErrorList. Calls `read` again if the document has errors. Throws all of them, in their order,
/// but not those that only follow from others.
template <class Read>
auto read_document(const toml::table& root, const Read& read) {
  ErrorList errors(root);
  try {
    while (true) {
      auto value = read(errors);
      if (errors.again()) continue;
      errors.throw_any();
      return value;
    }
  } catch (const TooManyErrors&) {
    errors.throw_all();
  }
}

/// Parses a document as TOML. Throws InputError, with the place, for an empty file and for an error
/// of syntax.
toml::table parse_toml(const Document& document);

/// Reads a spec to which another spec refers. Throws its first error: further ones would multiply
/// the passes of both files.
Spec parse_source(std::string text, std::string name);

/// Requires the key `jounce = 1`, which every file contains.
void require_version(TomlReader& top);

/// Returns a value as it is written in the document, for messages.
std::string shown(const toml::node& node);

}  // namespace spec_detail
}  // namespace jounce

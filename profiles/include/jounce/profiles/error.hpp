// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <exception>
#include <string>

namespace jounce {

/// Returns the shortest decimal text that reads back as the same double: 0.1, 1e-09, 232.361666.
std::string number(double value);

/// An error in the input, in one sentence: its place, its value, and the rule that it breaks.
///
/// Jounce throws no other exception for input. A generator gives the key, the value and the rule;
/// the reader of the document adds the place with at(). An expected outcome, such as a broken limit
/// or an optimum that was not reached, is a returned value, not an exception. A programming error
/// fails an assertion.
///
///     cams/feeder.toml:9:17: segment[2].end.master = 60: must be greater than 75, the knot before
class InputError : public std::exception {
 public:
  /// `key`: name of the parameter; `value`: its value as text or number; `rule`: "must be ...".
  InputError(std::string key, std::string value, std::string rule);
  InputError(std::string key, double value, std::string rule);

  /// Returns this error with its place in a document. Line and column count from 1; 0 means
  /// unknown.
  [[nodiscard]] InputError at(std::string document, int line = 0, int column = 0) const;

  /// The whole sentence.
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }
  /// The parts of the sentence. An empty document, and a line or column of 0, mean that this part
  /// is unknown.
  [[nodiscard]] const std::string& document() const { return document_; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] int column() const { return column_; }
  [[nodiscard]] const std::string& key() const { return key_; }
  [[nodiscard]] const std::string& value() const { return value_; }
  [[nodiscard]] const std::string& rule() const { return rule_; }

 private:
  void compose();

  std::string document_;
  int line_ = 0;
  int column_ = 0;
  std::string key_, value_, rule_;
  std::string text_;
};

/// Throw InputError unless the value is: finite; finite and > 0; finite and >= 0.
void require_finite(const char* key, double value);
void require_positive(const char* key, double value);
void require_not_negative(const char* key, double value);
/// Throws InputError unless a span has the expected number of entries.
void require_size(const char* key, std::size_t size, std::size_t expected);

}  // namespace jounce

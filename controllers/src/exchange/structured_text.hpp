// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "controllers/src/exchange/exchange_parts.hpp"

namespace jounce::controllers_detail {

/// Reads Structured Text (IEC 61131-3) token by token and counts lines. Comments and pragmas are
/// skipped. Words are compared without regard to case, as the language defines.
///
///     StReader code(text, place);
///     for (std::string word = code.next(); !word.empty(); word = code.next()) ...
///     code.expect(":=");
///     const double x = code.number("dX");                  // -40, - 40, LREAL#1.0, 1_000.5
class StReader {
 public:
  /// A place in the text.
  struct Mark {
    std::size_t at = 0;
    int line = 1;
  };

  StReader(const std::string& text, const Place& place);

  /// Returns the next token: a word in lower case, a string with its quotes, `:=`, `..` or a sign;
  /// "" at the end.
  std::string next();
  /// Returns the next token without consuming it.
  std::string peek();
  /// Consumes the next token; fails if it is another one.
  void expect(const std::string& wanted);
  /// Reads a number literal with its signs, without its type. Calls fail() with `key` for anything
  /// else.
  double number(const std::string& key);
  /// Returns the next word in its original letter case.
  std::string name();
  /// Skips a value, up to the `,` or the closing bracket that ends it; these are not consumed.
  void skip_value();

  [[noreturn]] void fail(const std::string& key, std::string_view value,
                         const std::string& rule) const;
  [[nodiscard]] int line() const { return here_.line; }
  [[nodiscard]] Mark here() const { return here_; }
  /// Continues at this place.
  void go_to(const Mark& mark) { here_ = mark; }

 private:
  std::string_view token();
  [[nodiscard]] bool is_word(std::size_t i) const;

  std::string text_;
  const Place& place_;
  Mark here_ = {};
};

}  // namespace jounce::controllers_detail

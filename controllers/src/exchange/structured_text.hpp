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
  struct Mark {
    std::size_t at = 0;
    int line = 1;
  };

  StReader(const std::string& text, const Place& place);

  /// The next word in lower case, string with its quotes as it is, `:=`, `..` or sign; empty at the end.
  std::string next();
  /// The next token, without consuming it.
  std::string peek();
  void expect(const std::string& wanted);
  /// A number literal with its signs and without its type. fail() with `key` for anything else.
  double number(const std::string& key);
  /// The next word as it stands in the file, such as a name.
  std::string name();
  /// Reads on to the `,` or the closing bracket that ends a value, and stays in front of it.
  void skip_value();

  [[noreturn]] void fail(const std::string& key, std::string_view value,
                         const std::string& rule) const;
  [[nodiscard]] int line() const { return here_.line; }
  [[nodiscard]] Mark here() const { return here_; }
  void go_to(const Mark& mark) { here_ = mark; }

 private:
  std::string_view token();
  [[nodiscard]] bool is_word(std::size_t i) const;

  std::string text_;
  const Place& place_;
  Mark here_ = {};
};

}  // namespace jounce::controllers_detail

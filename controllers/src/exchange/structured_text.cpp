// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/structured_text.hpp"

#include <algorithm>
#include <cctype>

namespace jounce::controllers_detail {
namespace {

/// End of the comment or pragma that begins at `i`; `i` where none begins. Comments nest.
std::size_t end_of_comment(const std::string& text, std::size_t i) {
  if (text.compare(i, 2, "//") == 0) return std::min(text.find('\n', i), text.size());
  if (text[i] == '{') {
    const auto end = text.find('}', i);
    return end == text.npos ? text.size() : end + 1;
  }
  if (text.compare(i, 2, "(*") != 0) return i;
  for (int depth = 0; i < text.size();) {
    const bool opens = text.compare(i, 2, "(*") == 0;
    const bool closes = !opens && text.compare(i, 2, "*)") == 0;
    depth += opens ? 1 : closes ? -1 : 0;
    i += opens || closes ? 2 : 1;
    if (depth == 0) return i;
  }
  return text.size();
}

/// End of the string that begins at `i`; `$` escapes the next character.
std::size_t end_of_string(const std::string& text, std::size_t i) {
  const char quote = text[i];
  for (++i; i < text.size() && text[i] != quote && text[i] != '\n'; ++i)
    if (text[i] == '$') ++i;
  return std::min(i + 1, text.size());
}

bool is_quote(char c) {
  return c == '\'' || c == '"';
}

/// The text with blanks for its comments and pragmas, as long and with the same lines.
std::string without_comments(std::string text) {
  for (std::size_t i = 0; i < text.size();) {
    if (is_quote(text[i])) {
      i = end_of_string(text, i);
      continue;
    }
    const std::size_t end = std::max(end_of_comment(text, i), i + 1);
    if (end_of_comment(text, i) > i)
      std::replace_if(
          text.begin() + static_cast<std::ptrdiff_t>(i),
          text.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
    i = end;
  }
  return text;
}

bool is_sign(std::string_view text) {
  return text == "-" || text == "+";
}

}  // namespace

StReader::StReader(const std::string& text, const Place& place)
    : text_(without_comments(text)), place_(place) {}

/// Letters, digits, points and the `#` of typed literals; not the `..` of a range. A sign belongs to
/// the word where it is that of an exponent.
bool StReader::is_word(std::size_t i) const {
  const char c = text_[i];
  if (c == '.') return text_.compare(i, 2, "..") != 0 && (i == 0 || text_[i - 1] != '.');
  if (is_sign({&c, 1})) {
    const bool exponent =
        i > 1 && std::tolower(static_cast<unsigned char>(text_[i - 1])) == 'e' &&
        (std::isdigit(static_cast<unsigned char>(text_[i - 2])) != 0 || text_[i - 2] == '.');
    return exponent || (i > 0 && text_[i - 1] == '#');
  }
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '#';
}

std::string_view StReader::token() {
  auto& [at, line] = here_;
  while (at < text_.size() && std::isspace(static_cast<unsigned char>(text_[at])) != 0)
    line += text_[at++] == '\n' ? 1 : 0;
  const std::size_t first = at;
  if (at == text_.size()) return {};
  if (is_quote(text_[at])) {
    at = end_of_string(text_, at);
  } else if (!is_sign({&text_[at], 1}) && is_word(at)) {
    while (at < text_.size() && is_word(at)) ++at;
  } else {
    const bool pair = text_.compare(at, 2, ":=") == 0 || text_.compare(at, 2, "..") == 0;
    at += pair ? 2 : 1;
  }
  return std::string_view(text_).substr(first, at - first);
}

std::string StReader::next() {
  const std::string_view word = token();
  return !word.empty() && is_quote(word.front()) ? std::string(word) : lower(word);
}

std::string StReader::name() {
  return std::string(token());
}

std::string StReader::peek() {
  const Mark mark = here_;
  std::string word = next();
  here_ = mark;
  return word;
}

void StReader::expect(const std::string& wanted) {
  if (const std::string found = next(); found != wanted)
    fail("", "",
         "needs `" + wanted + "`" +
             (found.empty() ? ": is the file complete?" : " before `" + found + "`"));
}

double StReader::number(const std::string& key) {
  double sign = 1;
  std::string word = name();
  for (; is_sign(word); word = name()) sign = word == "-" ? -sign : sign;
  const auto mark = word.find('#');
  if (mark != word.npos && std::isdigit(static_cast<unsigned char>(word.front())) != 0)
    fail(key, word, "must be a decimal number");
  std::string digits = mark == word.npos ? word : word.substr(mark + 1);
  std::erase(digits, '_');
  return sign * place_.number(here_.line, key, digits);
}

void StReader::skip_value() {
  for (int depth = 0;;) {
    const std::string word = peek();
    if (word.empty() || (depth == 0 && (word == "," || word == ")" || word == "]"))) return;
    depth += word == "(" || word == "[" ? 1 : word == ")" || word == "]" ? -1 : 0;
    static_cast<void>(next());
  }
}

void StReader::fail(const std::string& key, std::string_view value, const std::string& rule) const {
  place_.fail(here_.line, key, value, rule);
}

}  // namespace jounce::controllers_detail

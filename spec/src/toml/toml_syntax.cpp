// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/toml_syntax.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/printable.hpp"

namespace jounce::spec_detail {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// True for the text of a key file: hexadecimal digits only.
bool is_key_file(std::string_view text) {
  const std::string_view all = trimmed(text.substr(0, text.find('\n')));
  return all.size() == 64 && all.find_first_not_of("0123456789abcdefABCDEF") == all.npos;
}

std::string_view line_of(std::string_view text, int line) {
  for (; line > 1 && !text.empty(); --line) {
    const auto end = text.find('\n');
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// The `key = value` in which a place of a line lies. Without an = before the place, both are
/// empty.
struct Pair {
  std::string key, value;
};

Pair pair_at(std::string_view line, std::size_t at) {
  const auto equal = line.substr(0, at).rfind('=');
  if (equal == std::string_view::npos) return {};
  const auto before = trimmed(line.substr(0, equal));
  const auto begin = before.find_last_of(" \t{,");
  const auto key = begin == std::string_view::npos ? before : before.substr(begin + 1);
  auto value = line.substr(equal + 1);
  value = value.substr(0, value.find('#'));
  if (line.substr(0, equal).find('{') != std::string_view::npos)
    value = value.substr(0, value.find_first_of(",}"));
  return {printable(std::string(key)), printable(std::string(trimmed(value)))};
}

bool is_decimal_comma(const std::string& value) {
  const auto comma = value.find(',');
  return comma != std::string::npos && value.find(',', comma + 1) == std::string::npos &&
         std::all_of(value.begin(), value.end(),
                     [](char c) { return is_digit(c) || c == ',' || c == '-'; });
}

/// The rule for a number with a comma. Three digits after the comma can be thousands.
std::string rule_of_comma(const Pair& pair) {
  const auto comma = pair.value.find(',');
  const std::string before = pair.value.substr(0, comma);
  const std::string after = pair.value.substr(comma + 1);
  if (after.empty()) return "remove the comma after the number";
  const std::string point = pair.key + " = " + before + '.' + after;
  if (after.size() != 3 || before.empty() || before.find_first_not_of("-0") == before.npos)
    return "a number has a decimal point: " + point;
  return "a number has no comma: write " + pair.key + " = " + before + after + ", or " + point;
}

/// True for a number with the letter O or l in place of a digit: 5O, 1l, 1O.5.
bool has_letter_for_digit(const std::string& value) {
  const auto like_digit = [](char c) { return c == 'O' || c == 'o' || c == 'l' || c == 'I'; };
  return is_digit(value[0]) && std::any_of(value.begin(), value.end(), like_digit) &&
         std::all_of(value.begin(), value.end(),
                     [&](char c) { return is_digit(c) || c == '.' || like_digit(c); });
}

/// The rule for a value that is neither a number nor a text in quotes.
std::string rule_of_value(const Pair& pair) {
  const std::string& value = pair.value;
  std::string lower = value;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* word : {"true", "false"})
    if (lower == word) return "must be true or false, in lower case";
  for (const char* word : {"yes", "no", "on", "off"})
    if (lower == word) return "must be true or false";
  if (is_decimal_comma(value)) return rule_of_comma(pair);
  if (has_letter_for_digit(value))
    return "is a letter here a digit? The letters O and l look like 0 and 1";
  if (std::isinf(std::strtod(value.c_str(), nullptr)))
    return "must be less than 1.8e308 in magnitude";
  if (value.find_first_not_of("0123456789+-.eE_") == std::string::npos)
    return "is not a number: check its digits, its decimal point and its exponent";
  const std::string quoted = pair.key + " = \"" + value + '"';
  const bool number = !value.empty() && (is_digit(value[0]) || value[0] == '-' || value[0] == '+');
  return (number ? "a number with a unit needs quotes: " : "text needs quotes: ") + quoted;
}

/// The header of a section: [name] or [[name]].
struct Header {
  std::string name;
  bool is_array = false;
  Document::Place at = {};
};

std::optional<Header> header_of(std::string_view line) {
  std::string_view text = trimmed(line.substr(0, line.find('#')));
  if (!text.starts_with('[') || !text.ends_with(']')) return std::nullopt;
  const bool array = text.starts_with("[[") && text.ends_with("]]");
  const std::size_t brackets = array ? 2 : 1;
  text = trimmed(text.substr(brackets, text.size() - 2 * brackets));
  return Header{printable(std::string(text)), array};
}

/// All headers of this name.
std::vector<Header> headers_of(std::string_view text, const std::string& name) {
  std::vector<Header> all;
  for (int line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    const std::string_view content = text.substr(0, end);
    if (auto header = header_of(content); header && header->name == name) {
      header->at = {line, static_cast<int>(content.find('[')) + 1};
      all.push_back(*header);
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return all;
}

/// True for a section of which a spec can have several. [axis] is one section in a spec of kind "axis", and a list in
/// other kinds.
bool is_list(const std::string& name, const std::string& text) {
  constexpr std::array<std::string_view, 26> lists{
      "ceiling", "change",     "command",  "corridor",     "inputs", "joint",  "knot",
      "mass",    "number",     "override", "parameter",    "point",  "points", "reference",
      "request", "require",    "segment",  "shift",        "switch", "sync",   "then",
      "track",   "velocities", "zone",     "follow.table", "axis"};
  const std::string last = name.substr(name.rfind('.') + 1);
  const bool known = std::find(lists.begin(), lists.end(), name) != lists.end() ||
                     std::find(lists.begin(), lists.end(), last) != lists.end();
  return known && !(name == "axis" && text.find("kind = \"axis\"") != std::string::npos);
}

/// The error of a section that is given again with single or double brackets.
InputError repeated(const Document& document, const Header& again, int line, int column) {
  const bool list = is_list(again.name, document.text);
  for (const Header& header : headers_of(document.text, again.name))
    if (header.is_array != list)
      return list ? double_brackets(document, header.name, header.at)
                  : single_brackets(document, header.name, header.at);
  const bool is_key = headers_of(document.text, again.name).size() < 2;
  return InputError("[" + again.name + "]", "",
                    is_key ? "is also given as a key: keep the section, and remove the key"
                           : "is given twice: keep one section, with the keys of both")
      .at(document.name, line, column);
}

/// The name of a table in the header of its section: segment[2].points -> segment.points.
std::string header_name(const std::string& path) {
  std::string name;
  for (std::size_t at = 0; at < path.size(); ++at) {
    if (path[at] == '[')
      at = std::min(path.find(']', at), path.size() - 1);
    else
      name += path[at];
  }
  return name;
}

}  // namespace

InputError double_brackets(const Document& document, const std::string& name, Document::Place at) {
  const std::string header = "[" + header_name(name) + "]";
  return InputError(header, "",
                    "needs double brackets: write [" + header + "], because there can be several")
      .at(document.name, at.line, at.column);
}

InputError single_brackets(const Document& document, const std::string& name, Document::Place at) {
  const std::string header = "[" + header_name(name) + "]";
  return InputError("[" + header + "]", "",
                    "needs single brackets: write " + header + ", because there is only one")
      .at(document.name, at.line, at.column);
}

InputError syntax_error(const Document& document, int line, int column,
                        const std::string& description) {
  const std::string_view text = line_of(document.text, line);
  const auto at = static_cast<std::size_t>(std::max(column, 1) - 1);
  const Pair pair = pair_at(text, at);
  const auto error = [&](const std::string& key, const std::string& value,
                         const std::string& rule) {
    return InputError(key, value, rule).at(document.name, line, column);
  };
  const auto has = [&](const char* words) { return description.find(words) != std::string::npos; };
  const bool at_end = trimmed(text.substr(std::min(at, text.size()))).empty();
  const bool bare = !pair.value.empty() &&
                    (is_letter(pair.value[0]) || is_digit(pair.value[0]) || pair.value[0] == '-') &&
                    pair.value.find_first_of("=\"'{}[]") == std::string::npos;

  if (has("utf-8")) return error("", "", "is not text in UTF-8 here: save the file in UTF-8");
  if (has("after '\\r'"))
    return error("", "",
                 "ends with a carriage return alone: save the file with line ends LF or CRLF");
  if (has("control characters") && at_end)
    return error(pair.key, pair.value, "the closing quote is missing");
  if (const auto header = header_of(text); header && has("cannot redefine"))
    return repeated(document, *header, line, column);
  if (has("cannot redefine") && column == 1 &&
      line > 1)  // the parser names the line behind a header
    if (const auto header = header_of(line_of(document.text, line - 1)))
      return repeated(document, *header, line - 1, column);
  if (has("cannot redefine"))
    return error(pair.key, pair.value, "is given twice: remove one of the two");
  if (has("expected value") && pair.value.empty() && !pair.key.empty())
    return error(pair.key, "", "has no value: write " + pair.key + " = VALUE");
  if (is_key_file(document.text))
    return error("", "", "looks like a key file (`jounce new key`), not a spec");
  if (has("expected '='") || (has("key-value pair") && has("end-of-file")))
    return error(printable(std::string(trimmed(text.substr(0, at)))), "",
                 "needs a = between the key and its value");
  if (has("table header") && has("expected ']'"))
    return error(printable(std::string(trimmed(text.substr(0, text.find('#'))))), "",
                 "needs a closing ] at the end of the section header");
  if (has("closing '}'") && (at_end || text[at] == '#'))
    return error(pair_at(text, text.substr(0, at).rfind('{')).key, "",
                 "needs its closing } on the same line");
  if (bare && !csv_number(pair.value)) return error(pair.key, pair.value, rule_of_value(pair));
  if (has("expected comma or closing '}'"))
    return error(pair.key, "", "needs a comma or the closing } after its value");
  if (has("expected comma or closing ']'"))
    return error(pair.key, "", "needs a comma or the closing ] after a value");
  if (has("end-of-file"))
    return error(pair.key, "",
                 "is not complete: the file ends before the closing quote or bracket");
  if (has("blank bare keys"))
    return error("", "", "the name of the section is missing between its brackets");
  if (has("saw '='")) return error("", "", "the name of the key is missing before the =");
  const std::string_view raw = trimmed(text.substr(std::min(text.find('=') + 1, text.size())));
  for (const char* dash : {"\u2212", "\u2013", "\u2014"})
    if (raw.starts_with(dash))
      return error(pair.key, "", "begins with a dash or a typographic minus: write the sign as -");
  for (const char* quote : {"\u201c", "\u201d", "\u201e", "\u00ab", "\u2018", "\u2019"})
    if (raw.starts_with(quote))
      return error(pair.key, "", "has typographic quotes: write straight ones, \"...\"");
  if (has("expected a comment") && !pair.key.empty())
    return error(pair.key, "",
                 "has more text after its value: check the quotes, and begin a comment with #");
  if (pair.value.starts_with('=')) return error(pair.key, "", "has a second =: remove it");
  if (has("expected keys, tables") && at < text.size())
    return error("", "",
                 "the line begins with " + printable(std::string(text.substr(at, 1))) +
                     ", but must begin with a key, a section or a comment (#): check the brackets "
                     "and quotes on the lines above");
  if (pair.value.size() > 1 && pair.value[0] == '.' && is_digit(pair.value[1]))
    return error(pair.key, pair.value, "needs a digit before its decimal point: 0" + pair.value);
  if (pair.value.starts_with('('))
    return error(pair.key, "", "needs braces or brackets, not parentheses: { ... } or [ ... ]");
  const std::string prefix = "Error while parsing ";
  return error(
      "", "",
      "is not valid TOML, the format of a spec: " +
          (description.starts_with(prefix) ? description.substr(prefix.size()) : description));
}

}  // namespace jounce::spec_detail

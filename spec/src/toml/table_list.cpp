// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/table_list.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/text_edit.hpp"

#include "spec/src/toml/toml_editor.hpp"

namespace jounce::spec_detail {
namespace {

/// The end of the last value in a node.
toml::source_position last_of(const toml::node& node) {
  toml::source_position last = node.source().end;
  const auto take = [&](const toml::node& part) { last = std::max(last, last_of(part)); };
  if (const toml::table* table = node.as_table())
    for (const auto& [key, value] : *table) take(value);
  else if (const toml::array* array = node.as_array())
    for (const toml::node& each : *array) take(each);
  return last;
}

/// The text of a document, and one of its lists of tables.
class TableList {
 public:
  TableList(const std::string& text, const std::string& key)
      : text_(text), root_(toml::parse(std::string_view(text))), tables_(tables_at(root_, key)) {}

  [[nodiscard]] std::size_t size() const { return tables_.size(); }
  /// True for knot = [{...}, ...], false for [[knot]].
  [[nodiscard]] bool is_inline() const { return tables_[0].as_table()->is_inline(); }

  /// The beginning of a table: its {, or the line of its [[knot]].
  [[nodiscard]] std::size_t begin(std::size_t i) const {
    const std::size_t at = offset(tables_[i].source().begin);
    return is_inline() ? at : line_of(text_.rfind("[[", at + 1));
  }
  /// The end of a table: behind its }, or behind the line of its last value.
  [[nodiscard]] std::size_t end(std::size_t i) const {
    if (is_inline()) return offset(tables_[i].source().end);
    const std::size_t line = text_.find('\n', offset(last_of(tables_[i])));
    return line == std::string::npos ? text_.size() : line + 1;
  }
  /// The beginning of the comment above a table, if there is one without an empty line between.
  [[nodiscard]] std::size_t comment(std::size_t i) const {
    std::size_t at = begin(i);
    while (at > 0) {
      const std::size_t above = line_of(at - 1);
      const std::size_t word = text_.find_first_not_of(" \t", above);
      if (text_[word] != '#') break;
      at = above;
    }
    return at;
  }
  /// The indent of a table that begins its line; "" otherwise.
  [[nodiscard]] std::optional<std::string> indent(std::size_t i) const {
    const std::size_t at = begin(i);
    const std::string_view before = std::string_view(text_).substr(line_of(at), at - line_of(at));
    if (before.find_first_not_of(" \t") != std::string_view::npos) return std::nullopt;
    return std::string(before);
  }
  /// The place behind the comma that follows, or `at` without a comma.
  [[nodiscard]] std::size_t behind_comma(std::size_t at) const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at);
    return next < text_.size() && text_[next] == ',' ? next + 1 : at;
  }
  [[nodiscard]] std::size_t line_of(std::size_t at) const {
    return at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
  }
  [[nodiscard]] bool is_blank_line(std::size_t at) const {
    const std::size_t word = text_.find_first_not_of(" \t\r", at);
    return word == std::string::npos || text_[word] == '\n';
  }

 private:
  [[nodiscard]] std::size_t offset(const toml::source_position& place) const {
    return spec_detail::offset(text_, place);
  }

  static const toml::array& tables_at(const toml::table& root, const std::string& key) {
    const toml::node* node = node_at(root, key);
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    if (array == nullptr || array->empty() || !array->front().is_table())
      throw InputError(key, "", "is not a list of tables in the text");
    return *array;
  }

  const std::string& text_;
  toml::table root_;
  const toml::array& tables_;
};

std::string with_line_ends_of(const std::string& text, std::string block) {
  if (text.find("\r\n") == std::string::npos) return block;
  for (std::size_t at = 0; (at = block.find('\n', at)) != std::string::npos; at += 2)
    block.insert(at, 1, '\r');
  return block;
}

/// knot = [{...}, ...]
std::string with_inline_table(const std::string& text, const TableList& list, std::size_t at,
                              const std::string& entry) {
  std::string out = text;
  const bool last = at == list.size();
  const auto indent = list.indent(last ? at - 1 : at);
  const std::string gap = indent ? with_line_ends_of(text, "\n") + *indent : " ";
  if (last) return out.insert(list.end(at - 1), "," + gap + entry);
  return out.insert(list.begin(at), entry + "," + gap);
}

/// The header of a list of tables: "follow.table" for follow.table[2].
std::string list_header(std::string key) {
  for (std::size_t at = 0; (at = key.find('[')) != std::string::npos;)
    key.erase(at, key.find(']', at) - at + 1);
  return key;
}

}  // namespace

std::string with_table(const std::string& text, const std::string& key, std::size_t at,
                       const std::vector<std::string>& entries) {
  const TableList list(text, key);
  assert(at <= list.size());
  if (list.is_inline())
    return with_inline_table(text, list, at, fmt::format("{{ {} }}", fmt::join(entries, ", ")));
  std::string block = fmt::format("[[{}]]\n", list_header(key));
  for (const std::string& entry : entries) block += entry + "\n";
  std::string out = text;
  if (at < list.size()) return out.insert(list.comment(at), with_line_ends_of(text, block + "\n"));
  const std::size_t end = list.end(at - 1);
  const bool open = end > 0 && text[end - 1] != '\n';
  return out.insert(end, with_line_ends_of(text, (open ? "\n\n" : "\n") + block));
}

std::string without_table(const std::string& text, const std::string& key, std::size_t at) {
  const TableList list(text, key);
  assert(at < list.size() && list.size() > 1);
  std::size_t begin = list.begin(at);
  std::size_t end = list.end(at);
  std::string out = text;
  if (list.is_inline()) {
    const std::size_t behind =
        std::min(text.find_first_not_of(" \t", list.behind_comma(end)), text.size());
    if (list.indent(at) && list.is_blank_line(behind)) {  // the whole line
      begin = list.line_of(begin);
      end = std::min(text.find('\n', behind), text.size() - 1) + 1;
    } else if (at + 1 == list.size() && list.behind_comma(end) == end) {
      begin = list.end(at - 1);  // the comma before it, too
    } else {
      end = behind;
    }
    return out.erase(begin, end - begin);
  }
  const bool blank_above = begin == 0 || list.is_blank_line(list.line_of(begin - 1));
  if (blank_above)
    while (end < text.size() && list.is_blank_line(end))
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return out.erase(begin, end - begin);
}

std::size_t tables_in(const std::string& text, const std::string& key) {
  return TableList(text, key).size();
}

}  // namespace jounce::spec_detail

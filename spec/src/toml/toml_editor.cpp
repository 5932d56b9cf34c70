// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/toml_editor.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "jounce/profiles/error.hpp"

namespace jounce::spec_detail {

std::string tidy(double value) {
  return number(std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr));
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20U)
      out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out + '"';
}

const toml::node* node_at(const toml::table& root, std::string_view key) {
  const toml::node* node = &root;
  while (node != nullptr && !key.empty()) {
    if (key.front() == '[') {
      std::size_t index = 0;
      const std::size_t close = std::min(key.find(']'), key.size());
      std::from_chars(key.data() + 1, key.data() + close, index);
      const toml::array* array = node->as_array();
      node = array == nullptr || index == 0 ? nullptr : array->get(index - 1);
      key.remove_prefix(std::min(close + 1, key.size()));
      if (key.starts_with('.')) key.remove_prefix(1);
      continue;
    }
    const std::size_t end = std::min(key.find_first_of(".["), key.size());
    const toml::table* table = node->as_table();
    node = table == nullptr ? nullptr : table->get(key.substr(0, end));
    key.remove_prefix(end < key.size() && key[end] == '.' ? end + 1 : end);
  }
  return node;
}

std::size_t TomlEditor::offset(const toml::source_position& place) const {
  return spec_detail::offset(text_, place);
}

void TomlEditor::replace(const toml::table& table, const char* key, std::string value) {
  replace(*table.get(key), std::move(value));
}

void TomlEditor::replace(const toml::node& node, std::string value) {
  const toml::source_region& at = node.source();
  edits_.push_back({offset(at.begin), offset(at.end), std::move(value)});
}

void TomlEditor::add_beside(const toml::table& table, const char* beside, const char* key,
                            const std::string& value) {
  // The line of the other entry has the indent and, with dotted keys, the prefix.
  const std::string entry = std::string(key) + " = " + value;
  const toml::source_region& source = table.get(beside)->source();
  const std::size_t other = text_.rfind(beside, offset(source.begin));
  const std::size_t before = text_.find_last_of("{,\n", other);
  const std::size_t begin = text_.find_first_not_of(" \t", before + 1);
  const std::string prefixed = text_.substr(begin, other - begin) + entry;
  if (text_[before] != '\n') {
    edits_.push_back({begin, begin, prefixed + ", "});
    return;
  }
  const std::size_t end = std::min(text_.find('\n', offset(source.end)), text_.size());
  edits_.push_back({end, end, text_.substr(before, begin - before) + prefixed});
}

void TomlEditor::add(const toml::table& table, const char* beside, const char* key,
                     const std::string& value) {
  if (!table.is_inline()) {
    add_beside(table, beside, key, value);
    return;
  }
  const std::size_t brace = text_.rfind('}', offset(table.source().end) - 1);
  const std::size_t last = text_.find_last_not_of(" \t", brace - 1) + 1;
  edits_.push_back({last, last, ", " + std::string(key) + " = " + value});  // never the first entry
}

void TomlEditor::erase_tables(const toml::array& tables) {
  for (const toml::node& each : tables) {
    const std::size_t head = text_.rfind("[[", offset(each.source().begin) + 1);
    const std::size_t begin = text_.find_last_of('\n', head) + 1;
    std::size_t end = text_.find('\n', head);
    while (end < text_.size() && text_.find_first_not_of(" \t", end + 1) < text_.size() &&
           text_[text_.find_first_not_of(" \t", end + 1)] != '[')
      end = text_.find('\n', end + 1);
    edits_.push_back({begin, std::min(end, text_.size() - 1) + 1, ""});
  }
}

void TomlEditor::erase(const toml::table& table, const char* key) {
  const auto entry = table.find(key);
  if (entry == table.end()) return;
  const toml::array* array = entry->second.as_array();
  if (array != nullptr && !array->empty() && array->front().is_table() &&
      !array->front().as_table()->is_inline()) {
    erase_tables(*array);
    return;
  }
  std::size_t begin = offset(entry->first.source().begin);
  std::size_t end = offset(entry->second.source().end);
  const std::size_t after = text_.find_first_not_of(" \t", end);
  if (table.is_inline()) {
    if (after < text_.size() && text_[after] == ',')
      end = text_.find_first_not_of(" \t", after + 1);
    else
      begin = text_.find_last_of(',', begin);  // the last of several entries
  } else {                                     // the whole line, with a comment at its end
    begin = text_.find_last_of('\n', begin) + 1;
    end = std::min(text_.find('\n', end), text_.size() - 1) + 1;
  }
  edits_.push_back({begin, end, ""});
}

std::string TomlEditor::result() const {
  return edited(text_, edits_);
}

}  // namespace jounce::spec_detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "jounce/spec/detail/text_edit.hpp"

namespace jounce::spec_detail {

/// Returns a number without the rounding of its last digits: 0.3, not 0.30000000000000004.
std::string tidy(double value);
/// Returns a text in the quotes of TOML.
std::string quoted(const std::string& text);
/// Returns the node with a full key, such as "segment[2].end.master"; null: there is none.
const toml::node* node_at(const toml::table& root, std::string_view key);

/// Changes values in the text of a TOML document and keeps everything else: comments,
/// order, layout. Tables and nodes are those parsed from this text, which must outlive the editor.
class TomlEditor {
 public:
  explicit TomlEditor(const std::string& text) : text_(text) {}

  /// Replaces a value by this text.
  void replace(const toml::node& node, std::string value);
  /// Replaces a value by this text. The key must exist.
  void replace(const toml::table& table, const char* key, std::string value);
  /// Adds an entry after the entry `beside`, on a new line unless the table is inline.
  void add_beside(const toml::table& table, const char* beside, const char* key,
                  const std::string& value);
  /// Adds an entry at the end of an inline table, otherwise below `beside`.
  void add(const toml::table& table, const char* beside, const char* key, const std::string& value);
  /// Removes an entry if it exists; for [[key]] all its tables.
  void erase(const toml::table& table, const char* key);

  [[nodiscard]] std::string result() const;

 private:
  [[nodiscard]] std::size_t offset(const toml::source_position& place) const;
  void erase_tables(const toml::array& tables);

  const std::string& text_;
  std::vector<Edit> edits_;
};

}  // namespace jounce::spec_detail

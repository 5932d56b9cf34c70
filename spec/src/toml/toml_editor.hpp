// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "jounce/spec/detail/text_edit.hpp"

namespace jounce::detail {

/// Changes values in the text of a TOML document and leaves everything else as it stands: comments,
/// order, layout. Tables and nodes are those parsed from this text, which must outlive the editor.
class TomlEditor {
 public:
  explicit TomlEditor(const std::string& text) : text_(text) {}

  /// Another value, as it is to stand in the text. The key exists.
  void replace(const toml::table& table, const char* key, std::string value);
  /// A further entry: beside the entry `beside`, on a line below it unless the table is inline.
  void add_beside(const toml::table& table, const char* beside, const char* key,
                  const std::string& value);
  /// A further entry at the end of an inline table, or else below `beside`.
  void add(const toml::table& table, const char* beside, const char* key, const std::string& value);
  /// Takes the entry out, if there is one; of [[key]] all its tables.
  void erase(const toml::table& table, const char* key);

  [[nodiscard]] std::string result() const;

 private:
  [[nodiscard]] std::size_t offset(const toml::source_position& place) const;
  void erase_tables(const toml::array& tables);

  const std::string& text_;
  std::vector<Edit> edits_;
};

}  // namespace jounce::detail

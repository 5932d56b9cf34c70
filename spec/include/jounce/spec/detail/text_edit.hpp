// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace jounce::spec_detail {

/// A replacement: `text` replaces the bytes [begin, end) of a document.
struct Edit {
  std::size_t begin;
  std::size_t end;
  std::string text;
};

/// Returns the byte offset of a place that TOML gives as line and column (in code points), both
/// from 1.
std::size_t offset(const std::string& text, const toml::source_position& place);

/// Returns the text with all edits. Edits must not overlap. Of two insertions at the same place,
/// the later one comes first.
std::string edited(std::string text, std::vector<Edit> edits);

}  // namespace jounce::spec_detail

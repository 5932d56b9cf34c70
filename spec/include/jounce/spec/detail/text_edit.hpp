// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace jounce::spec_detail {

/// Bytes [begin, end) of a document that become `text`.
struct Edit {
  std::size_t begin;
  std::size_t end;
  std::string text;
};

/// Byte offset of a place that TOML counts in lines and code points, both from 1.
std::size_t offset(const std::string& text, const toml::source_position& place);

/// The text with all edits made; they do not overlap. Of two insertions at one place, the later one
/// comes first.
std::string edited(std::string text, std::vector<Edit> edits);

}  // namespace jounce::spec_detail

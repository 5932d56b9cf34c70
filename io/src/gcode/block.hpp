// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce::io_detail {

/// A word of a block: "X12.5".
struct GcodeWord {
  std::string letters;  ///< upper case: "X", "FF"
  double value = 0;
  std::string text;  ///< the number as written
  int column = 0;    ///< from 1
};

/// One line: its words in order; none for an empty line, a comment or a `%`.
struct GcodeBlock {
  std::vector<GcodeWord> words;
  int line = 0;

  /// The word with these letters, or nullptr.
  [[nodiscard]] const GcodeWord* find(std::string_view letters) const;
};

/// Throws InputError with line and column, without a document: text that is no word, a letter twice (but G and M).
GcodeBlock read_block(std::string_view line, int number);

}  // namespace jounce::io_detail

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
  double value = 0;     ///< its number
  std::string text;     ///< the number as written
  int column = 0;       ///< from 1
};

/// One line of a program, with its words in order. There are none for an empty line, a comment or a
/// `%`.
struct GcodeBlock {
  std::vector<GcodeWord> words;
  int line = 0;  ///< number of the line, from 1

  /// Returns the word with these letters; null if there is none.
  [[nodiscard]] const GcodeWord* find(std::string_view letters) const;
};

/// Reads a line. Throws InputError with line and column, but without a document, for text that is
/// not a word, and for a letter that occurs twice (except G and M).
GcodeBlock read_block(std::string_view line, int number);

}  // namespace jounce::io_detail

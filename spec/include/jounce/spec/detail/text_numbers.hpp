// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/base/document.hpp"

/// The numbers in the text of a spec of any kind, and their changes, as an editor makes them. Only
/// the text of the change is different in the result: comments, order and formatting stay.
namespace jounce {

/// A number in the text of a spec.
struct TextNumber {
  std::string key = {};   ///< full key, such as "knot[3].time" or "command[2].to[1]"
  double value = 0;       ///< in `unit`
  std::string unit = {};  ///< unit in which the spec reads it
  int line = 0;           ///< line in the text, from 1
};

/// Returns the numbers of a document that parse_spec() has read, in the order of the text.
std::vector<TextNumber> numbers_of(const Document& document);

/// Another value of a number; nullopt removes it.
struct NumberChange {
  std::string key = {};
  std::optional<double> value = {};
};

/// Returns the text with other values of these numbers. A number keeps the unit that the text gives
/// to it ("12.5 cm"). A number that the spec can have but the text does not have is added to its
/// table. Computed numbers have at most 12 significant digits. Throws InputError for a key that is
/// not the key of a number of the spec, and for a number in another file.
std::string with_numbers(const Document& document, const std::vector<NumberChange>& changes);

/// Returns the text with one more table in the list `list` ("knot", "segment[2].points"), at the
/// index `at`, from 0. `entries`: the lines of the table, such as "time = 2". Throws InputError if
/// the text does not have the list.
std::string with_row(const std::string& text, const std::string& list, std::size_t at,
                     const std::vector<std::string>& entries);

/// Returns the text without the table `row` of a list, such as "knot[3]". Throws InputError if the
/// text does not have it, and if it is the only one.
std::string without_row(const std::string& text, const std::string& row);

/// Return an entry of a table: "time = 2", or "to = [1, 2]".
std::string entry_text(const std::string& key, double value);
std::string entry_text(const std::string& key, const std::vector<double>& values);

}  // namespace jounce

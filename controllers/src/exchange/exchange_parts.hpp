// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/controllers/exchange/exchange.hpp"

/// Parts that the formats of other makers share.
namespace jounce::controllers_detail {

/// A line of a file, counted from 1.
struct Line {
  int number = 0;
  std::string_view text;  ///< without white space around it
};

/// Returns the lines that are not blank.
std::vector<Line> lines_of(std::string_view text);

/// Returns the number of the line at an offset, from 1; 1 for an unknown offset.
int line_at(const std::string& text, std::ptrdiff_t offset);

std::string_view trimmed(std::string_view text);
std::string lower(std::string_view text);

/// A value from a comment `# key: value` or `// key: value` that Jounce wrote.
struct Note {
  std::string value;  ///< the value
  int line = 0;       ///< number of its line
};
using Notes = std::map<std::string, Note>;
Notes notes_of(const std::vector<Line>& lines);
bool is_comment(std::string_view line);

/// Returns the comments for a table. Each line begins with `mark`.
std::string notes_text(const TableFile& file, const std::string& mark);

/// One cam as it was read. `columns` and `lines` have one entry for each knot.
struct Exchanged {
  std::string name = {};  ///< name of the cam; "" if the format has no names
  Interpolation rule = Interpolation::quintic_hermite;
  Units units = {};                      ///< units that the format defines or states
  Columns columns = {};                  ///< columns of its table
  std::vector<int> lines = {};           ///< line of each knot
  Notes notes = {};                      ///< comments that Jounce wrote
  bool repeats = false;                  ///< true if the file states that the motion repeats
  std::vector<std::string> unread = {};  ///< parts of the file other than the knots
};

/// A file, for errors with a place in it.
class Place {
 public:
  /// `name`: name of the file. `decimal_comma`: true if a comma is the decimal separator.
  Place(std::string name, bool decimal_comma)
      : name_(std::move(name)), decimal_comma_(decimal_comma) {}
  /// Throws InputError for this line, key and value.
  [[noreturn]] void fail(int line, const std::string& key, std::string_view value,
                         const std::string& rule) const;
  /// Returns a finite number; calls fail() for any other text.
  [[nodiscard]] double number(int line, const std::string& key, std::string_view text) const;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  bool decimal_comma_;
};

}  // namespace jounce::controllers_detail

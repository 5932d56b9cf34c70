// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// The lines that are not blank.
std::vector<Line> lines_of(std::string_view text);

std::string_view trimmed(std::string_view text);
std::string lower(std::string_view text);

/// The comments `# key: value` or `// key: value` that Jounce wrote.
struct Note {
  std::string value;
  int line = 0;
};
using Notes = std::map<std::string, Note>;
Notes notes_of(const std::vector<Line>& lines);
bool is_comment(std::string_view line);

/// The comments themselves, each line begun with `mark`.
std::string notes_text(const TableFile& file, const std::string& mark);

/// One cam as read: a column entry and a line for each knot.
struct Exchanged {
  std::string name = {};  ///< empty where the format has no names of cams
  Interpolation rule = Interpolation::quintic_hermite;
  Columns columns = {};
  std::vector<int> lines = {};
  Notes notes = {};
  std::vector<std::string> unread = {};  ///< parts of the file other than the knots
};

/// Place of an error in a file.
class Place {
 public:
  Place(std::string name, bool decimal_comma)
      : name_(std::move(name)), decimal_comma_(decimal_comma) {}
  [[noreturn]] void fail(int line, const std::string& key, std::string_view value,
                         const std::string& rule) const;
  /// A finite number, or fail().
  [[nodiscard]] double number(int line, const std::string& key, std::string_view text) const;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  bool decimal_comma_;
};

}  // namespace jounce::controllers_detail

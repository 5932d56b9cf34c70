// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Units and names for the numbers of a report.
struct Labels {
  Units units = {};          ///< units of the time or master position (x) and of the position
  bool over_master = false;  ///< true: over a master; false: over time
  std::vector<std::string> segments =
      {};  ///< one for each piece of the curve: "2 sync"; may be empty

  /// Returns the unit of "position", "geo_velocity", "acceleration", ...; "" for an unknown
  /// quantity.
  [[nodiscard]] std::string unit_of(const std::string& quantity) const;
  /// Returns the unit of the value of a finding; "" if it has none.
  [[nodiscard]] std::string unit_of(const Finding& finding) const;
  /// Returns the name of the segment of a finding; "" if it has none.
  [[nodiscard]] std::string segment_of(const Finding& finding) const;
  /// Returns the number of the segment, from 1, to which a piece of the curve belongs (index from
  /// 0). Adjacent pieces with the same name form one segment.
  [[nodiscard]] std::size_t number_of_segment(std::size_t piece) const;
};

/// Adjacent pieces of a curve that have the same name: the pieces of one law.
struct SegmentGroup {
  std::string label = {};  ///< name; a range for combined groups: "1 to 5000"
  std::size_t first = 0;   ///< index of the first piece
  std::size_t last = 0;    ///< index of the last piece
};
/// Returns the groups of a curve with this number of pieces. If there are more than `most` groups,
/// neighbors are combined as evenly as possible.
std::vector<SegmentGroup> groups(std::size_t segments, const Labels& labels,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());
/// Greatest number of rows of a table in a text.
constexpr std::size_t rows_for_people = 60;

/// Returns a number as six_digits() does (jounce/profiles/detail/six_digits.hpp).
std::string rounded(double value);
/// Like rounded(), but 0 for a value that is only rounding beside `scale`, the magnitude of the
/// quantity: 1.3e-10 mm of a travel of 50 mm.
std::string rounded(double value, double scale);
/// Returns "3.5 mm"; "3.5" without a unit.
std::string with_unit(double value, const std::string& unit);

/// Returns one sentence: the number of broken findings and the worst finding or, if none is broken,
/// the smallest margin.
std::string one_line(const Report& report, const Labels& labels);

/// True if the finding is the peak of a derivative that has no limit, see add_not_limited()
/// (jounce/design/input.hpp).
bool is_unlimited(const Finding& finding);

/// True if the report has a finding that compares the motion with a limit of the machine. Findings
/// on breaks, tables or other computations do not count.
bool has_limits(const Report& report);

/// Returns "not limited: geo_acceleration (up to 0.16 mm/deg^2), geo_jerk (up to 0.02 mm/deg^3)";
/// "" if the report has no finding for which is_unlimited() is true.
std::string not_limited_text(const Report& report, const Labels& labels);

/// Returns a finding as a sentence: "geo_velocity -3.39227 pulse/pulse at 241.898 pulse (segment 3
/// return) exceeds the limit -3 by 13.1 %".
std::string sentence(const Finding& finding, const Labels& labels);

/// Returns one line for each finding; broken findings are marked and have advice. Only the first
/// `most` findings are listed; the others are counted.
std::string full_text(const Report& report, const Labels& labels, std::size_t most = 10);

/// Returns {"ok": ..., "findings": [...]}, with all digits of each number. In a finding, `segment`
/// is the number of its entry in extrema_json(), from 1, and `piece` the number of its piece of the
/// curve. If the finding has no limit, `limit` and `margin` are null.
std::string to_json(const Report& report, const Labels& labels);

/// Returns the exact extrema of each segment as a table for people, with at most rows_for_people
/// rows.
template <class Over>
std::string extrema_text(const Curve<Over>& curve, const Labels& labels);
/// Returns the exact extrema of each segment as a JSON list.
template <class Over>
std::string extrema_json(const Curve<Over>& curve, const Labels& labels);
/// Like the functions above, for a table.
std::string extrema_text(const Table& table, const Labels& labels);
std::string extrema_json(const Table& table, const Labels& labels);

/// Combines the JSON objects of the axes of a file, given by name. The object of a single axis is
/// returned unchanged; for several, the result is {"ok": ..., "axes": {"x": ..., "y": ...}}. `ok`
/// is true if it is true for all axes; it is omitted if the objects have no `ok`.
std::string axes_json(const std::vector<std::pair<std::string, std::string>>& axes);

}  // namespace jounce

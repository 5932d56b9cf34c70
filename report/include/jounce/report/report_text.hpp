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

/// Names and units of the numbers of a report.
struct Labels {
  Units units;
  bool over_master = false;
  std::vector<std::string> segments;  ///< "2 sync", one per segment of the curve; may be empty

  /// Unit of "position", "geo_velocity", "acceleration", ...; "" for an unknown quantity.
  [[nodiscard]] std::string unit_of(const std::string& quantity) const;
  /// Unit of a finding's value, and the name of its segment: "" if there is none.
  [[nodiscard]] std::string unit_of(const Finding& finding) const;
  [[nodiscard]] std::string segment_of(const Finding& finding) const;
  /// The number, from 1, of the segment of a piece of the curve (from 0): adjacent pieces with the
  /// same label are one segment.
  [[nodiscard]] std::size_t number_of_segment(std::size_t piece) const;
};

/// The segments of a curve that share a label: the pieces of one law. If there are more than
/// `most`, they are combined as evenly as possible: "1 to 5000".
struct SegmentGroup {
  std::string label;
  std::size_t first = 0;
  std::size_t last = 0;
};
std::vector<SegmentGroup> groups(std::size_t segments, const Labels& labels,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());
/// Greatest number of rows in text output.
constexpr std::size_t rows_for_people = 60;

/// A number for people: six significant digits.
std::string rounded(double value);

/// One sentence: how many findings and the worst, or the smallest margin.
std::string one_line(const Report& report, const Labels& labels);

/// True if it is the peak of a derivative that has no limit: see add_not_limited().
bool is_unlimited(const Finding& finding);

/// True if a finding compares the motion with a limit of the machine: not with a joint, a table or another computation.
bool has_limits(const Report& report);

/// "not limited: geo_acceleration (up to 0.16 mm/deg^2), geo_jerk (up to 0.02 mm/deg^3)": "" if no
/// finding is_unlimited().
std::string not_limited_text(const Report& report, const Labels& labels);

/// One finding as a sentence: "geo_velocity -3.39227 pulse/pulse at 241.898 pulse (segment 3
/// return) exceeds the limit -3 by 13.1 %".
std::string sentence(const Finding& finding, const Labels& labels);

/// One line for each finding, broken ones marked and with advice. Findings beyond `most` are only
/// counted.
std::string full_text(const Report& report, const Labels& labels, std::size_t most = 10);

/// {"ok": ..., "findings": [...]}, every number in full. A finding's `segment` counts the entries
/// of extrema_json() from 1, `piece` those of the curve; `limit` and `margin` are null if it has no
/// limit.
std::string to_json(const Report& report, const Labels& labels);

/// The exact extrema of every segment as a table for people (at most rows_for_people), and as a
/// JSON list.
template <class Over>
std::string extrema_text(const Curve<Over>& curve, const Labels& labels);
template <class Over>
std::string extrema_json(const Curve<Over>& curve, const Labels& labels);
std::string extrema_text(const Table& table, const Labels& labels);
std::string extrema_json(const Table& table, const Labels& labels);

/// The JSON objects of the axes of a file, by name, as one: that of one axis unchanged; of several
/// {"ok": ..., "axes": {"x": ..., "y": ...}}. `ok` is true if it is true for all axes, and is left
/// out if they have none.
std::string axes_json(const std::vector<std::pair<std::string, std::string>>& axes);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/cam/design/runs.hpp"
#include "jounce/io/points.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// The points of a segment from the CSV file that its key `points` names. The first and the last
/// point are the knots that the spec leaves out.
struct CamPointFile {
  Points file;
  std::vector<CamPoint> points;  ///< one for each row of the file
  Units units;                   ///< units of the points

  /// Returns the first or the last point as a knot.
  [[nodiscard]] static CamKnot knot_of(const CamPoint& point);
  /// Returns the points that belong inside the segment from `from` to `to`. A point on one of these
  /// knots must have its slave position, within the tolerance of the point. Throws InputError, with
  /// the line of the file.
  [[nodiscard]] std::vector<CamPoint> within(Law law, const CamKnot& from, const CamKnot& to) const;
};

/// Reads the points of a segment. Returns nullopt if its key `points` is not the name of a file.
/// Throws InputError if the law takes no points, for a column that the law does not take, and for
/// masters that do not ascend.
std::optional<CamPointFile> read_cam_points(TomlReader& segment, Law law, const Units& units);

/// Returns the masters of the first and the last point of the file; nullopt without a file.
std::optional<MasterSpan> span_of_points(TomlReader& segment, const Units& units);

}  // namespace jounce::spec_detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/profiles/curve/difference.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

/// One of two versions of a curve, with its properties. The curve may come from a spec, from a
/// table, or from a program.
struct Version {
  std::string name = {};                ///< name of the version, such as its file
  std::variant<Cam, Trajectory> curve;  ///< the curve
  Labels labels = {};                   ///< its units and the names of its segments
  std::vector<double> knots = {};       ///< places of the knots; empty: the breaks of the curve
  /// A name for each knot, such as "end of 2 in step"; may be empty.
  std::vector<std::string> knot_names = {};
  std::optional<Limits> limits = {};  ///< limits of the version; nullopt if it cannot have limits,
                                      ///< such as a table
  /// The table that is made from the curve; nullopt if `curve` is the curve of the table.
  std::optional<Table> table = {};
  std::string table_options = {};  ///< the requirements for this table, as text
};

/// Tolerances within which two versions count as equal.
///
/// Without any value, only rounding is permitted. `share` permits a share of the range of each
/// quantity. `of` permits a difference of one quantity, in its unit. If `of` has a value for any
/// quantity, and `share` has none, the other quantities are shown but not judged.
struct Tolerance {
  std::optional<double> share = {};              ///< share of the range of each quantity
  std::array<std::optional<double>, 4> of = {};  ///< for position, velocity, acceleration, jerk
};

/// Returns the greatest permitted difference of a quantity (order: 0 position to 3 jerk), in its
/// unit. Without a tolerance, this is rounding. Returns nullopt if the quantity is not judged.
std::optional<double> permitted(const Change& change, std::size_t order,
                                const Tolerance& tolerance);

/// A property in which two versions differ: "periodic", "unit of position", "limit geo_velocity".
/// An empty text means that the version does not have the property.
struct Remark {
  std::string what = {};    ///< name of the property
  std::string before = {};  ///< value in the earlier version
  std::string after = {};   ///< value in the later version
};

/// The differences between two versions. Numbers are in the units of `after`.
struct Comparison {
  std::string before = {};  ///< name of the earlier version
  std::string after = {};   ///< name of the later version
  Labels labels = {};       ///< units and segments of the later version
  Changes changes = {};     ///< differences of the curves
  /// For position, velocity, acceleration, jerk: true if the tolerance is exceeded.
  std::array<bool, 4> beyond{};
  std::vector<KnotChange> knots = {};               ///< changes of the knots: shown, but not judged
  std::vector<std::string> knot_names_before = {};  ///< names of the earlier knots
  std::vector<std::string> knot_names_after = {};   ///< names of the later knots
  std::vector<Remark> remarks = {};  ///< differences of interval, units, policy outside and limits

  /// True if no difference exceeds the tolerance, and there are no remarks.
  [[nodiscard]] bool equal() const;
};

/// Compares two versions: their curves exactly (see difference.hpp), their interval, policy outside
/// and units, and their limits if both have limits. If both have a table, and their requirements
/// differ, the tables are compared as well: a difference beyond the tolerance is a remark. `before`
/// is converted to the units of `after`, unless one of them has no units. Throws InputError if one
/// version is over time and the other over a master, if units do not convert, or if the curves have
/// no common interval.
Comparison compare(const Version& before, const Version& after, const Tolerance& tolerance = {});

/// Returns the version in other units: curve, knots and limits. If the old or the new unit is
/// unknown, the numbers stay. Throws InputError (key "unit") if two units do not convert.
Version in_units(Version version, const Units& units);

/// Returns a text for people: one line for each quantity with its peaks and its largest difference,
/// then knots and remarks. Only the first `most` knots are listed; the others are counted. The
/// first line of equal curves also has `besides`, a statement about differences outside the curves.
std::string to_text(const Comparison& comparison, std::size_t most = 10,
                    const std::string& besides = "");

/// Returns {"equal": ..., "changes": {...}, "knots": [...], "remarks": [...]}, with all digits of
/// each number.
std::string to_json(const Comparison& comparison);

/// Returns a tolerance from texts. Each text is a share of every range ("1e-6"), or KEY=VALUE for
/// one quantity ("position=0.01", "position=10 um"). Throws InputError (key "tolerance") for any
/// other text.
Tolerance tolerance_of(const std::vector<std::string>& texts, const Labels& labels);

/// False for a tolerance KEY=VALUE of other motions: the key is a quantity of the other domain, or
/// its unit is one of another quantity ("position=1 um" for an axis in deg). True for any other
/// text, even if it is invalid.
bool tolerance_fits(const std::string& text, const Labels& labels);

}  // namespace jounce

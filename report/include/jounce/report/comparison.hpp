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

/// One of two versions of a curve, with its properties: a spec, a table, or anything made in
/// a program.
struct Version {
  std::string name;
  std::variant<Cam, Trajectory> curve;
  Labels labels;
  std::vector<double> knots = {};            ///< places on the axis; empty: the breaks of the curve
  std::vector<std::string> knot_names = {};  ///< one for each, "end of 2 in step"; may be empty
  std::optional<Limits> limits = {};         ///< none: a kind without limits, such as a table
};

/// Tolerances for equal versions.
///
/// By default only rounding. A share refers to the range of each quantity. A quantity with its own
/// number, in its unit, may differ by that. If there is such a number, quantities without a number
/// and without a share are shown but not judged.
struct Tolerance {
  std::optional<double> share = {};
  std::array<std::optional<double>, 4> of = {};  ///< position, velocity, acceleration, jerk
};

/// Greatest difference of a quantity (0 position to 3 jerk) that a tolerance permits, in the unit of the quantity:
/// rounding if there is no tolerance; nothing if the quantity is not judged.
std::optional<double> permitted(const Change& change, std::size_t order,
                                const Tolerance& tolerance);

/// A property in which two versions differ: "periodic", "unit of position",
/// "limit geo_velocity". An empty text: not given.
struct Remark {
  std::string what;
  std::string before;
  std::string after;
};

/// Changes from one version to another. Numbers are in the units of `after`.
struct Comparison {
  std::string before;  ///< names
  std::string after;
  Labels labels;  ///< labels of `after`
  Changes changes;
  std::array<bool, 4> beyond{};   ///< true for those that exceed the tolerance
  std::vector<KnotChange> knots;  ///< listed, but not judged: the curve is
  std::vector<std::string> knot_names_before;
  std::vector<std::string> knot_names_after;
  std::vector<Remark> remarks;  ///< interval, units, policy outside, limits: each a difference

  /// True if nothing exceeds the tolerance and nothing else was changed.
  [[nodiscard]] bool equal() const;
};

/// Compares the curves exactly (see difference.hpp), and their properties: the interval, the policy
/// outside, units, and limits if both have some. `before` is converted into the units of `after`,
/// unless one has none. Throws InputError if one runs over time and the other over a master, if
/// units do not convert, or if there is no common stretch.
Comparison compare(const Version& before, const Version& after, const Tolerance& tolerance = {});

/// The version converted to other units of its axis and its position: curve, knots and limits.
/// Units unknown on either side stay. Throws InputError (key "unit") if two units do not convert.
Version in_units(Version version, const Units& units);

/// For people: one line for each quantity with its peaks and the largest difference, then knots and
/// remarks. Knots beyond `most` are only counted.
std::string to_text(const Comparison& comparison, std::size_t most = 10);

/// {"equal": ..., "changes": {...}, "knots": [...], "remarks": [...]}, every number in full.
std::string to_json(const Comparison& comparison);

/// The tolerance of some texts, each a share of every range ("1e-6") or KEY=VALUE for one quantity
/// ("position=0.01", "position=10 um"). Throws InputError (key "tolerance").
Tolerance tolerance_of(const std::vector<std::string>& texts, const Labels& labels);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/shape_spec.hpp"
#include "jounce/spec/spec.hpp"

/// Converts the texts of [optimize] about shapes to figures over the master.
namespace jounce::spec_detail {

/// Data for figures in addition to their text.
struct ShapeWords {
  Units units;
  std::string time_unit;
  std::optional<double> speed;     ///< speed of the master: master units in one unit of time
  double seconds = 1;              ///< length of a unit of time, s
  const LoadSpec* load = nullptr;  ///< nullptr: no load
};

/// A quantity at one place, and its unit: "slave", "geo_jerk", "velocity", "torque". `reader` and
/// `key` are its place in the document, for messages.
struct NamedQuantity {
  LinearQuantity quantity;
  std::string unit;
};
NamedQuantity quantity_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words);

/// The figure with a name alone: "peak torque", "rms geo_jerk", "motor heating".
ShapeFigureSpec figure_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words);

/// The same from a table with the key `figure`; for a residual vibration, also `at` and `damping`.
ShapeFigureSpec read_figure(TomlReader& table, const ShapeWords& words);

}  // namespace jounce::spec_detail

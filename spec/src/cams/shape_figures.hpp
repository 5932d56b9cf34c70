// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/shape_spec.hpp"
#include "jounce/spec/spec.hpp"

/// From the words of [optimize] on shapes to figures over the master.
namespace jounce::spec_detail {

/// Data for figures beside their own words.
struct ShapeWords {
  Units units;
  std::string time_unit;
  std::optional<double> speed;     ///< speed of the master, x a time unit
  double seconds = 1;              ///< a time unit
  const LoadSpec* load = nullptr;  ///< nullptr: none
};

/// A quantity at one place and its unit: "slave", "geo_jerk", "velocity", "torque". `reader` and `key`
/// give its place for messages.
struct NamedQuantity {
  LinearQuantity quantity;
  std::string unit;
};
NamedQuantity quantity_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words);

/// A figure by its name alone: "peak torque", "rms geo_jerk", "motor heating".
ShapeFigureSpec figure_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words);

/// The same from a table with `figure`, and `at` and `damping` of a residual.
ShapeFigureSpec read_figure(TomlReader& table, const ShapeWords& words);

}  // namespace jounce::spec_detail

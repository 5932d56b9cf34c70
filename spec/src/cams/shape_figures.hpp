// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/shape_spec.hpp"
#include "jounce/spec/spec.hpp"

/// The words of [optimize] about shapes -> what they mean over the master.
namespace jounce::detail {

/// What figures need to know beside their own words.
struct ShapeWords {
  Units units;
  std::string time_unit;
  std::optional<double> speed;     ///< speed of the master, x a time unit
  double seconds = 1;              ///< a time unit
  const LoadSpec* load = nullptr;  ///< where there is one
};

/// A quantity at one place and its unit: "slave", "geo_jerk", "velocity", "torque". `reader` and `key`
/// are where it stands, for messages.
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

}  // namespace jounce::detail

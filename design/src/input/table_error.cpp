// SPDX-License-Identifier: Apache-2.0
#include "design/src/input/table_error.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_value;

// Default tolerances of a table with equal intervals and of others, as shares of the stroke.
constexpr double coarse_share = 1e-6;
constexpr double fine_share = 1e-9;

}  // namespace

std::optional<double> table_tolerance(const Input& input) {
  if (!input.error) return std::nullopt;
  if (design_detail::is_best_of_so_many(input)) return input.error->position;
  const Range travel =
      std::visit([](const auto& curve) { return extrema(curve, 0); }, *input.curve);
  const double stroke = travel.max.value - travel.min.value;
  const double asked = input.options.tolerance.value_or(
      (input.options.intervals ? coarse_share : fine_share) * (stroke > 0 ? stroke : 1));
  return std::max(asked + input.fit, rounded_value * std::abs(travel.peak().value));
}

namespace design_detail {

bool is_best_of_so_many(const Input& input) {
  return input.options.target && !input.options.tolerance;
}

Finding table_error(const Input& input) {
  const double allowed = *table_tolerance(input);
  const bool broken = input.error->position > allowed;
  return {.rule = "table/position",
          .axis = "table",
          .quantity = "position",
          .where = input.error->where,
          .value = input.error->position,
          .limit = allowed,
          .margin = (allowed - input.error->position) / allowed,
          .broken = broken,
          .segment = std::nullopt,
          .advice = broken ? "give [table] a tolerance, or more intervals" : ""};
}

}  // namespace design_detail
}  // namespace jounce

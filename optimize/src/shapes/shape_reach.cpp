// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/shapes/shape_reach.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/src/program/equalities.hpp"
#include "optimize/src/program/shape_rows.hpp"
#include "optimize/src/search/findings.hpp"

namespace jounce::optimize_detail {
namespace {

bool apart(const ShapeModel& model, const Coordinates& z) {
  return !(worst_equality(model, z) <= hopeless);
}

}  // namespace

bool contradictory(const ShapeModel& model, const Coordinates& z) {
  return apart(model, as_fixed(model, z));
}

std::optional<std::string> broken_where_fixed(const ShapeModel& model, const Coordinates& z) {
  std::optional<Coordinates> fixed;  // z need not keep the fixed values
  for (const ShapeConstraint& constraint : model.constraints)
    for (const Form& f : constraint.start) {
      if (model.freedom(f) > no_freedom) continue;
      if (!fixed) fixed = as_fixed(model, z);
      if (apart(model, *fixed)) return {};
      const double excess = f.at(*fixed) / constraint.scale;
      if (excess > hopeless)
        return "the fixed values break " + constraint.rule + " by " + brief(100 * excess) + " %";
    }
  return {};
}

std::string worst_constraints(const ShapeModel& model, const Coordinates& z, double slack) {
  const auto shape = model.space.segments(z);
  std::string names;
  for (const ShapeConstraint& constraint : model.constraints) {
    if (constraint.beyond(shape, 0.999 * slack).empty()) continue;
    if (names.find(constraint.rule) != std::string::npos) continue;
    names += (names.empty() ? "" : " and ") + constraint.rule;
  }
  return names.empty() ? "the limits" : names;
}

}  // namespace jounce::optimize_detail

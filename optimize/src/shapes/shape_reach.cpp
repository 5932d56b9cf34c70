// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/shapes/shape_reach.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/src/program/shape_rows.hpp"
#include "optimize/src/search/findings.hpp"

namespace jounce::optimizer {
namespace {

/// Of an equality of size one, and of a wall that nothing changes: as far as as_fixed() can say.
constexpr double hopeless = 1e-7;
constexpr int rounds = 3;

/// A shape near z that has what is fixed and kept exactly: least squares, so that equalities may be said
/// twice.
Coordinates as_fixed(const ShapeModel& model, Coordinates z) {
  ConvexProgram p{std::vector<double>(model.space.size(), 0), {}, {}, {}};
  for (int round = 0; round < rounds; ++round) {
    p.squares = model.equalities;
    for (std::size_t k = 0; k < z.size(); ++k) p.squares.push_back({-1e-5 * z[k], {{k, 1e-5}}});
    z = solve(p, z).x;
  }
  return z;
}

bool apart(const ShapeModel& model, const Coordinates& z) {
  const auto off = [&](const Form& f) { return !(std::abs(f.at(z)) <= hopeless); };
  return std::any_of(model.equalities.begin(), model.equalities.end(), off);
}

}  // namespace

bool contradictory(const ShapeModel& model, const Coordinates& z) {
  return apart(model, as_fixed(model, z));
}

std::optional<std::string> broken_where_fixed(const ShapeModel& model, const Coordinates& z) {
  std::optional<Coordinates> fixed;  // not z: that need not keep what is fixed
  for (const Wall& wall : model.walls)
    for (const Form& f : wall.start) {
      if (model.freedom(f) > no_freedom) continue;
      if (!fixed) fixed = as_fixed(model, z);
      if (apart(model, *fixed)) return {};
      const double excess = f.at(*fixed) / wall.scale;
      if (excess > hopeless)
        return "what is fixed breaks " + wall.rule + " by " + brief(100 * excess) + " %";
    }
  return {};
}

std::string worst_walls(const ShapeModel& model, const Coordinates& z, double slack) {
  const auto shape = model.space.segments(z);
  std::string names;
  for (const Wall& wall : model.walls) {
    if (wall.beyond(shape, 0.999 * slack).empty()) continue;
    if (names.find(wall.rule) != std::string::npos) continue;
    names += (names.empty() ? "" : " and ") + wall.rule;
  }
  return names.empty() ? "the limits" : names;
}

}  // namespace jounce::optimizer

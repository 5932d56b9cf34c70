// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/shape.hpp"

/// Shape problems that several tests ask.
namespace jounce::test_optimize {

/// From rest at 0 to rest at 1 over [0, 1], derivatives up to `order` - 1 zero at both ends.
inline ShapeProblem rest_to_rest_shape(int order) {
  ShapeProblem p;
  ShapeEnd rest{.velocity = 0.0};
  if (order > 2) rest.acceleration = 0.0;
  if (order > 3) rest.jerk = 0.0;
  if (order > 4) rest.jounce = 0.0;
  p.from = p.to = rest;
  p.from.value = 0.0;
  p.to.value = 1.0;
  return p;
}

/// |q| <= most over the whole shape.
inline Corridor within(const LinearQuantity& q, double most, const ShapeProblem& p) {
  return {q, p.begin, p.end, Edge{-most, -most}, Edge{most, most}};
}

}  // namespace jounce::test_optimize

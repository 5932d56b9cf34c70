// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/program/shape_model.hpp"

/// The equalities of a shape: continuity between its pieces, fixed ends, values that are kept
/// exactly.
namespace jounce::optimize_detail {

/// Returns the greatest residual of an equality at z; NaN if a residual is NaN.
double worst_equality(const ShapeModel& model, const Coordinates& z);

/// Returns the coordinates nearest to z that meet the equalities to rounding. Fixed values at an
/// end are exact to the last bit.
///
/// The solver of a program leaves residuals of 1e-9 and more, but the written cam joins its pieces
/// exactly: an error e of a position at one end of a piece of length h changes its jerk by
/// 60 e / h^3.
Coordinates as_fixed(const ShapeModel& model, Coordinates z);

}  // namespace jounce::optimize_detail

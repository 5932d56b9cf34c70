// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "controllers/src/exchange/knot_arrays.hpp"

namespace jounce::controllers_detail {

/// A point of a cam of CODESYS SoftMotion: dX (master), dY (slave), dV = dY/dX and dA = d2Y/dX2.
extern const KnotType cam_xyva;

/// The calls that couple the axes, as comments of a declaration `Cam` with its array `CamPoints`.
std::string coupling_calls(const TableFile& file);

}  // namespace jounce::controllers_detail

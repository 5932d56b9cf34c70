// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jounce {

/// Greatest number of dimensions of sobol().
inline constexpr std::size_t sobol_dimensions = 21;

/// Returns coordinate `dimension` (from 0) of the point `number` of Sobol's sequence, times 2^32.
/// Any 2^k successive points, from a multiple of 2^k on, have one point in each of 2^k equal
/// intervals of every coordinate.
///
/// Sources: I. M. Sobol, USSR Comput. Math. Math. Phys. 7 (1967). Primitive polynomials and
/// direction numbers: S. Joe, F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional
/// projections", SIAM J. Sci. Comput. 30 (2008), table new-joe-kuo-6. A test compares the sequence
/// with the sequence of SciPy. The points are in the order of the sequence, not of a Gray code.
std::uint32_t sobol(std::uint32_t number, std::size_t dimension);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jounce {

/// Number of dimensions of sobol().
inline constexpr std::size_t sobol_dimensions = 21;

/// Coordinate `dimension` of the point `number` of Sobol's sequence, times 2^32. Any 2^k points from a
/// multiple of 2^k on have one in each of 2^k equal intervals of every coordinate.
///
/// I. M. Sobol, USSR Comput. Math. Math. Phys. 7 (1967); primitive polynomials and direction numbers: S. Joe,
/// F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci. Comput. 30
/// (2008), table new-joe-kuo-6. Pinned by a test against SciPy's. Points are in the sequence's own order, not
/// in Gray code's.
std::uint32_t sobol(std::uint32_t number, std::size_t dimension);

}  // namespace jounce

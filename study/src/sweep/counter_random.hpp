// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace jounce {

/// Random numbers without a state. A number depends only on its address (a Draw), not on earlier
/// numbers or on the caller.
///
///     const Draw d{.seed = 1, .stream = stream_of("drive.load_inertia"), .sample = 17};
///     uniform(d);                                                      // (0, 1)
///     normal(d);                                                       // mean 0, sigma 1
///
/// Method: Philox 4x32 with 10 rounds (J. K. Salmon, M. A. Moraes, R. O. Dror and D. E. Shaw,
/// "Parallel random numbers: as easy as 1, 2, 3", SC11, 2011). Tests compare it with the authors'
/// known answers.
struct Draw {
  std::uint64_t seed = 1;    ///< seed of all numbers
  std::uint64_t stream = 0;  ///< number of the stream, see stream_of()
  std::uint64_t sample = 0;  ///< number of the sample in the stream
};

/// Returns the number of the stream for a name. Each name has its own stream, so an additional
/// parameter does not change the numbers of the others.
std::uint64_t stream_of(std::string_view name);

/// Returns a number between 0 and 1, uniform, ends excluded.
double uniform(const Draw& draw);

/// Returns a standard normal number from the same address (G. E. P. Box and M. E. Muller, 1958).
double normal(const Draw& draw);

/// Returns the output of the generator Philox 4x32 for a counter and a key.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Distribution of the samples of a Monte Carlo analysis over the ranges of its random parameters.
enum class Design {
  random,           ///< samples are independent
  latin_hypercube,  ///< N samples: one in each of N equal shares of the distribution of each
                    ///< parameter
  sobol,  ///< Sobol's sequence: for N = 2^k like latin_hypercube, and also evenly spread over
          ///< several parameters at once
};

/// The numbers between 0 and 1 from which the samples are made.
///
///     const SampleDesign design(Design::sobol, 1, {"drive.mass[1].inertia", "move.velocity"}, 256);
///     design.at(0, 17);                        // of the first parameter in the eighteenth sample
///
/// **Latin hypercube**: for each parameter, a permutation of the N shares, and a place within each
/// share. The random stream of the parameter determines both (M. D. McKay, R. J. Beckman, W. J.
/// Conover, Technometrics 21, 1979).
///
/// **Sobol**: each coordinate is combined (XOR) with random bits of its parameter. This random
/// digital shift preserves the uniformity of the sequence (P. L'Ecuyer, C. Lemieux, Recent advances
/// in randomized quasi-Monte Carlo methods, 2002). The coordinates are assigned to the parameters
/// in the order of the names.
class SampleDesign {
 public:
  SampleDesign() = default;  ///< Design::random
  /// `names`: names of the parameters. `samples`: number of samples N. Throws InputError (key
  /// "design") if there are more names than Sobol's sequence has dimensions.
  SampleDesign(Design design, std::uint64_t seed, std::vector<std::string> names,
               std::size_t samples);

  /// The distribution.
  [[nodiscard]] Design design() const { return design_; }

  /// Returns the number between 0 and 1 for a parameter (its index) in a sample. Not for
  /// Design::random; its numbers are drawn by Draw.
  [[nodiscard]] double at(std::size_t parameter, std::size_t sample) const;

 private:
  Design design_ = Design::random;
  std::uint64_t seed_ = 1;
  std::vector<std::string> names_;
  std::vector<std::vector<std::uint32_t>>
      order_;  ///< for a Latin hypercube: index of the interval, by parameter and sample
};

/// Returns the u-quantile of the standard normal distribution; 0 < u < 1.
double normal_quantile(double u);

}  // namespace jounce

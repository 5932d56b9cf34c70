// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace jounce {

/// Distribution of the samples of a Monte Carlo analysis over the ranges of its random parameters.
enum class Design {
  random,           ///< independently
  latin_hypercube,  ///< N samples, one in each N-th of every parameter's distribution
  sobol,  ///< Sobol's sequence: the same for powers of two, and even over several parameters at once
};

/// The numbers in (0, 1) that samples are made of.
///
///     const SampleDesign design(Design::sobol, 1, {"drive.mass[1].inertia", "move.velocity"}, 256);
///     design.at(0, 17);                        // of the first parameter in the eighteenth sample
///
/// Latin hypercube: a permutation for each parameter, and a place within the N-th, both from the parameter's
/// own random stream (M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21, 1979). Sobol: each
/// coordinate XORed with random bits of its parameter, a random digital shift, which keeps the sequence as
/// even as it is (P. L'Ecuyer, C. Lemieux, Recent advances in randomized quasi-Monte Carlo methods, 2002).
/// The coordinates go to the parameters in the order of the names.
class SampleDesign {
 public:
  SampleDesign() = default;  ///< random
  /// Throws InputError for more names than Sobol's sequence has dimensions (key "design").
  SampleDesign(Design design, std::uint64_t seed, std::vector<std::string> names,
               std::size_t samples);

  [[nodiscard]] Design design() const { return design_; }

  /// Not for Design::random, whose numbers come from Draw.
  [[nodiscard]] double at(std::size_t parameter, std::size_t sample) const;

 private:
  Design design_ = Design::random;
  std::uint64_t seed_ = 1;
  std::vector<std::string> names_;
  std::vector<std::vector<std::uint32_t>>
      order_;  ///< order of a Latin hypercube: which N-th, by parameter and sample
};

/// The standard normal's quantile of u in (0, 1).
double normal_quantile(double u);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/design/key_figures.hpp"
#include "jounce/study/sample_design.hpp"
#include "jounce/study/spec_numbers.hpp"

namespace jounce {

/// All of these values: a list, or a grid of equal steps.
struct Values {
  std::vector<double> all;
};

/// Drawn for each sample of the Monte Carlo analysis.
struct UniformSpread {
  double from = 0;
  double to = 0;
};
struct NormalSpread {
  double mean = 0;
  double sigma = 0;
};

/// A number of the spec that takes several values, in the unit of the spec at that place.
struct SweepParameter {
  std::string key;   ///< key in SpecNumbers
  std::string unit;  ///< unit in the spec; "" if there is none
  std::variant<Values, UniformSpread, NormalSpread> how;

  [[nodiscard]] bool random() const { return !std::holds_alternative<Values>(how); }
};

struct SweepObjective {
  std::string figure;
  bool greatest = false;  ///< to be maximized
};

/// A figure that must not exceed a value, in the unit that the figure has.
struct SweepLimit {
  std::string figure;
  double at_most = 0;
};

/// A sweep file: the numbers of a spec that vary, their values, and the figures of interest.
///
///     jounce = 1
///     kind = "sweep"
///     spec = "cam.toml"                       # beside this file
///     figures = ["peak torque", "residual"]   # omitted: all that the spec has
///     optima = true                           # each case is optimised first, as by `jounce optimize`
///     minimize = ["duration", "peak torque"]  # for the Pareto front; also maximize = [...]
///     [[parameter]]
///     key = "segment[1].end.master"
///     values = [100, 110, 120]                # or from, to, count
///     [[parameter]]
///     key = "drive.load_inertia"
///     tolerance = "10 %"                      # or uniform = { from, to }, normal = { mean, sigma }
///     [monte_carlo]
///     samples = 1000
///     design = "sobol"                        # or "latin_hypercube"; omitted: "random"
///     [limits]
///     "peak torque" = 2.5                     # in addition to those of the spec
///
/// **Cases**: every combination of the listed values, each with all samples, numbered from 0. The
/// samples change fastest, then the last listed parameter. The numbers of a case depend only on the
/// seed, the key and the number of the sample: each combination gets the same samples, so
/// combinations can be compared. `tolerance` is a share of the number in the spec: uniform about
/// it.
struct SweepSpec {
  static constexpr std::size_t most_cases = 10'000'000;

  Document document;
  std::string name;
  SpecNumbers base;  ///< the spec as given
  std::vector<SweepParameter> parameters;
  std::size_t samples = 1;  ///< 1 if nothing is random
  std::uint64_t seed = 1;
  SampleDesign design = {};
  bool optima =
      false;  ///< each case is optimized by the [optimize] of the spec, before its figures are computed
  std::size_t chosen =
      0;  ///< number of figures with `optima`, last in `given`, that each case chooses itself
  std::vector<KeyFigure> given;  ///< the figures of interest, of the spec as given
  bool given_ok = false;         ///< true if it is within all limits
  std::vector<SweepObjective> objectives;
  std::vector<SweepLimit> limits;

  [[nodiscard]] bool random() const;
  /// True if the samples are independent, so that shares among them have an interval.
  [[nodiscard]] bool independent() const { return design.design() == Design::random; }
  [[nodiscard]] std::size_t cases() const;
  /// The numbers of a case, in the order of the parameters.
  [[nodiscard]] std::vector<SpecNumbers::Change> numbers(std::size_t number) const;
  /// SHA-256 of everything on which the results depend: both texts, the result of the spec as given
  /// (so also the files that it names), and this program.
  [[nodiscard]] Sha256 identity() const;

 private:
  /// Value of the random parameter number `which` in a sample.
  [[nodiscard]] double drawn(const SweepParameter& p, std::size_t which, std::size_t sample) const;
};

/// Reads a sweep file and the spec that it names, and assesses that spec as it is given. Throws
/// InputError like read_spec(), for a spec that is impossible, and for a key, figure or unit that
/// it does not have.
SweepSpec read_sweep(const std::string& path);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/design/key_figures.hpp"
#include "jounce/study/detail/sample_design.hpp"
#include "jounce/study/spec_numbers.hpp"

namespace jounce {

/// The values of a listed parameter, from a list or from a grid of equal steps.
struct Values {
  std::vector<double> all = {};
};

/// A random parameter with a uniform distribution from `from` to `to`.
struct UniformSpread {
  double from = 0;
  double to = 0;
};
/// A random parameter with a normal distribution.
struct NormalSpread {
  double mean = 0;   ///< mean value
  double sigma = 0;  ///< standard deviation
};

/// A number of the spec that varies, in the unit that the spec has at that place.
struct SweepParameter {
  std::string key = {};   ///< key of the number, see SpecNumbers
  std::string unit = {};  ///< unit of the number in the spec; "" if it has none
  std::variant<Values, UniformSpread, NormalSpread> how =
      {};  ///< values or distribution of the number

  /// True if the parameter is random.
  [[nodiscard]] bool random() const { return !std::holds_alternative<Values>(how); }
};

/// A figure to be minimized or maximized, for the Pareto front.
struct SweepObjective {
  std::string figure = {};  ///< name of the figure
  bool greatest = false;    ///< true: maximize it
};

/// A figure that must not exceed a value, in the unit of the figure.
struct SweepLimit {
  std::string figure = {};  ///< name of the figure
  double at_most = 0;       ///< greatest permitted value
};

/// A sweep file: the numbers of a spec that vary, their values, and the figures that are computed.
///
///     jounce = 1
///     kind = "sweep"
///     spec = "cam.toml"                       # in the same folder
///     figures = ["peak torque", "residual"]   # omitted: all that the spec has
///     optima = true                           # each case is optimized first, as by `jounce optimize`
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
///     "peak torque" = 2.5                     # in addition to the limits of the spec
///
/// **Cases** are all combinations of the listed values, each with all samples. The cases are
/// numbered from 0: the sample changes fastest, then the last listed parameter. A random number
/// depends only on the seed, the key and the number of the sample. So every combination has the
/// same samples, and combinations can be compared. `tolerance` is a share of the number in the
/// spec; it gives a uniform distribution around this number.
struct SweepSpec {
  static constexpr std::size_t most_cases = 10'000'000;  ///< greatest number of cases

  Document document = {};                       ///< the sweep file
  std::string name = {};                        ///< name of the sweep
  SpecNumbers base;                             ///< the given spec
  std::vector<SweepParameter> parameters = {};  ///< the numbers that vary
  std::size_t samples = 1;                      ///< number of samples; 1 if no parameter is random
  std::uint64_t seed = 1;                       ///< seed of the random numbers
  SampleDesign design = {};                     ///< distribution of the samples
  bool optima = false;  ///< true: each case is first optimized by the [optimize] of the spec
  /// Number of the values that the optimizer chooses in each case (`optima`). They are the last
  /// entries of `given`.
  std::size_t chosen = 0;
  /// The figures that are computed, with their values for the given spec.
  std::vector<KeyFigure> given = {};
  bool given_ok = false;                        ///< true if the given spec is within all limits
  std::vector<SweepObjective> objectives = {};  ///< objectives of the Pareto front
  std::vector<SweepLimit> limits = {};          ///< limits in addition to the limits of the spec

  /// True if at least one parameter is random.
  [[nodiscard]] bool random() const;
  /// True if the samples are independent, so that a share of them has a confidence interval.
  [[nodiscard]] bool independent() const { return design.design() == Design::random; }
  /// Number of cases.
  [[nodiscard]] std::size_t cases() const;
  /// Returns the numbers of a case, in the order of the parameters.
  [[nodiscard]] std::vector<SpecNumbers::Change> numbers(std::size_t number) const;
  /// Returns the SHA-256 of everything on which the results depend: the texts of the sweep file and
  /// of the spec, this program, and the result of the given spec (which depends on the files that
  /// the spec names).
  [[nodiscard]] Sha256 identity() const;

 private:
  /// Returns the value of the random parameter number `which` in a sample.
  [[nodiscard]] double drawn(const SweepParameter& p, std::size_t which, std::size_t sample) const;
};

/// Reads a sweep file and its spec, and computes the figures of the given spec. Throws InputError
/// like read_spec(), for a spec from which no motion can be made, and for a key, figure or unit
/// that the spec does not have.
SweepSpec read_sweep(const std::string& path);
/// Like read_sweep(), for the text of a file.
SweepSpec parse_sweep(std::string text, const std::string& path);

}  // namespace jounce

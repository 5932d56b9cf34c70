// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/key_figures.hpp"

namespace jounce {

/// A number that was chosen, in the unit that it has in the file.
struct TunedNumber {
  std::string key = {};   ///< key in the spec
  std::string unit = {};  ///< unit in the file; "1" for a pure number
  double given = 0;       ///< value in the given spec
  double reached = 0;     ///< chosen value
  double lower = 0;       ///< lower bound
  double upper = 0;       ///< upper bound
  bool at_bound = false;  ///< true if the chosen value is at a bound
};

/// A figure that is optimized, or that must stay within bounds.
struct TunedFigure {
  std::string name = {};  ///< name of the figure
  std::string unit = {};  ///< its unit
  /// Value for the given spec; nullopt if the given spec has no motion.
  std::optional<double> given = {};
  double reached = 0;                   ///< value for the chosen numbers
  std::optional<double> at_least = {};  ///< required lower bound
  std::optional<double> at_most = {};   ///< required upper bound
};

/// Result of tune().
struct TuneOutcome {
  SearchOutcome search = {};              ///< result of the search
  std::vector<TunedNumber> numbers = {};  ///< the chosen numbers, in the order of the spec
  /// The objective, followed by the required figures; empty if no choice is possible.
  std::vector<TunedFigure> figures = {};
  std::vector<std::string> active = {};  ///< the limits that are reached or broken, as sentences
  Report report = {};     ///< findings of the best choice, for every limit in the spec
  std::string text = {};  ///< text of the spec with the best numbers, otherwise unchanged

  /// True if the best choice satisfies all limits.
  [[nodiscard]] bool usable() const { return search.usable(); }
};

/// Chooses the numbers in [[optimize.parameter]] of a spec so that a key figure becomes minimal or
/// maximal. The result satisfies every limit of the spec (the limits of check and, if the spec has
/// a [drive], of the drive) and the requirements in [[optimize.require]], if any choice does;
/// otherwise usable() is false.
///
///     TuneOutcome best = tune(read_spec("shear.toml"));
///     if (best.usable()) write_file("faster.toml", best.text);
///
/// **Rounding.** The best numbers are rounded to as few digits as possible. All limits remain
/// satisfied, and the figure loses at most half the tolerance.
///
/// **Constraints.** Each rule of the report is a separate constraint; for a limit of a curve, each
/// bound on each segment is a separate constraint. If the generator rejects a choice close to the
/// best one, the outcome has its reason, because it limits the best choice.
///
/// **Errors.** Throws InputError, with the place in the document, if the spec has no
/// [[optimize.parameter]], for a figure that the spec does not have, for a bound without the unit
/// of the figure, and for a number outside its range.
TuneOutcome tune(const Spec& spec, const KeepGoing& keep_going = {});

/// Returns the indices of the parameters on which neither the figure nor a limit depends, while the
/// other parameters keep their present values. The function makes the spec for a few values of each
/// parameter, over its range. Empty if the present spec cannot be made.
std::vector<std::size_t> idle_parameters(const Spec& spec);

/// Returns the numbers that `jounce optimize` chooses for a path without [[optimize.parameter]]:
/// each `corner`, for the least duration. A corner may vary from a hundredth of its value in the
/// spec up to this value, so no corner is larger than the spec permits. Throws InputError, with the
/// place in the document, if the path has no corner, or more than 20.
ParametersSpec corner_parameters(const Spec& spec);
/// True if the path has corners that corner_parameters() can choose.
bool has_corner_parameters(const Spec& spec);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/key_figures.hpp"

namespace jounce {

/// A number that was chosen, in the unit of the file.
struct TunedNumber {
  std::string key;
  std::string unit;  ///< "1" for a pure number
  double given = 0;
  double reached = 0;
  double lower = 0;
  double upper = 0;
  bool at_bound = false;
};

/// A figure that is optimized, or held within bounds.
struct TunedFigure {
  std::string name;
  std::string unit;
  std::optional<double> given = {};  ///< none: the spec as given is impossible
  double reached = 0;
  std::optional<double> at_least = {};
  std::optional<double> at_most = {};
};

struct TuneOutcome {
  SearchOutcome search;
  std::vector<TunedNumber> numbers;  ///< in the order of the spec
  std::vector<TunedFigure>
      figures;  ///< the objective, then the required figures; empty: no choice is possible
  std::vector<std::string> active;  ///< active limits, or missed ones: sentences
  Report report;                    ///< report of the best: every limit that the spec states
  std::string text;                 ///< the spec with the numbers of the best, otherwise unchanged

  [[nodiscard]] bool usable() const { return search.usable(); }
};

/// Chooses the numbers that the spec's [[optimize.parameter]] names, for the key figure that it minimizes
/// or maximizes, such that every limit of the spec holds (check, and the drive where there is a
/// [drive]) and what [[optimize.require]] demands.
///
///     TuneOutcome best = tune(read_spec("shear.toml"));
///     if (best.usable()) write("faster.toml", best.text);
///
/// **Rounding.** A few digits are enough for a machine: the numbers of the best are rounded as far
/// as all limits still hold and the figure gets worse by no more than half the tolerance.
///
/// Each rule of the report is a separate constraint; a limit of a curve is one for each bound and
/// segment. If the generator refuses a choice, its reason is kept: it limits the best choice near
/// it. Throws InputError, placed in the document, if the spec has no [[optimize.parameter]], for a
/// figure that it does not have, for a bound without the figure's unit, and for a number outside
/// its range.
TuneOutcome tune(const Spec& spec, const KeepGoing& keep_going = {});

/// The numbers that `jounce optimize` chooses for a path without [[optimize.parameter]]: every number of a `corner`,
/// from a hundredth of it up to it, for the least duration. So no corner is larger than the spec permits. Throws
/// InputError, placed in the document, if there is none, or more than 20.
ParametersSpec corner_parameters(const Spec& spec);

}  // namespace jounce

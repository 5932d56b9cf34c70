// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Findings of a synchronous slave besides its limits: those of its generator, with their units.
/// Empty for all other kinds of spec.
Report check_sync(const Spec& spec);

/// A number of such a spec for a report: its name, its value with the unit, and its meaning.
struct SyncFigure {
  std::string name;  ///< "longest cut"
  double value = 0;
  std::string unit;
  std::string meaning;  ///< "without a stop"; may be empty
};
std::vector<SyncFigure> sync_figures(const Spec& spec);

/// True if the slave's cam follows from one speed of the master (a shear's does): for another speed
/// another cam would do.
bool is_made_for_a_speed(const Spec& spec);

/// True if the slave of this spec stays in gear beyond its table, behind a live master.
bool stays_in_gear(const Spec& spec);

}  // namespace jounce

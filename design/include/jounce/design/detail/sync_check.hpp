// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Returns the findings of the generator of a synchronous slave, with their units. The findings do
/// not depend on the limits of the slave. Empty for all other kinds of spec.
Report check_sync(const Spec& spec);

/// A figure of a synchronous slave for a report.
struct SyncFigure {
  std::string name = {};     ///< name, such as "longest cut"
  double value = 0;          ///< in `unit`
  std::string unit = {};     ///< unit of the value
  std::string meaning = {};  ///< explanation, such as "without a stop"; may be empty
};
/// Returns the figures of a synchronous slave.
std::vector<SyncFigure> sync_figures(const Spec& spec);

/// True if the slave's cam is made for one speed of the master, as the cam of a shear is. Another
/// speed needs another cam.
bool is_made_for_a_speed(const Spec& spec);

/// True if the slave of a live master stays in gear beyond the end of its table.
bool stays_in_gear(const Spec& spec);

}  // namespace jounce

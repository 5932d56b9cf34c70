// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// Returns the slave of a cam as a motion over the spec's unit of time, for the [master] of the
/// spec. Its limits are [limits.slave], and the position limits of [limits]. Its table has the rule
/// and the tolerance of [table]; the other requirements of [table] count in the unit of the master,
/// so they do not apply. The sync zones of the result are the times at which the master passes the
/// sync zones of the cam (no zones if there would be more than about 200). The result has no spec.
/// Its curve is exact, or within 1e-9 of the stroke; the error of the table includes this
/// deviation. Throws InputError (key "input") for a motion over time and for a table, and like
/// make_master() for a spec without [master].
Input over_time(const Input& input);

/// Returns the speed of [master] with its unit, as the spec gives it: "72 m/min". `spec` must have
/// a [master].
std::string master_speed_text(const Spec& spec);

/// Returns the input for `jounce ... --over WHAT`: "time" gives over_time(); "master" and "" give
/// the input itself. Throws InputError (key "over") if the input cannot be shown over `what`.
Input over(const std::string& what, Input input);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {

/// Gives finished tables the spec from which they were made. check_all() then compares each table
/// with the curve and with all limits of the spec, including the limits over time at the speed of
/// its [master].
///
/// The tables get the units of the spec; a table without units is in these units already. A table
/// whose file does not state whether the motion repeats behaves outside its interval as the spec
/// does. A table over time of a cam is compared with the motion of the slave over time. The limits
/// apply to the table itself, at each knot and between the knots.
///
/// `tolerance`: the greatest permitted deviation of the position, as a share of its range or in its
/// unit. Without it, the tolerance of [table] is permitted or, for the format of a controller, the
/// default tolerance of `jounce convert` if it is greater.
///
/// `tables`: the axes of one file, paired with the axes of the spec by name. Throws InputError (key
/// "against") for a file that is no spec with a motion, for `tables` with a spec of their own, an
/// axis without a partner, units that do not convert, and a table with another interval.
void set_against(std::vector<Input>& tables, const std::string& spec_path,
                 const std::vector<std::string>& tolerance = {});

/// Gives a table of Jounce the limits of the spec that its header names, like set_against(), but
/// without the comparison with the curve. Nothing happens if the spec is not found, has another
/// text now, or does not fit the table.
void set_limits_of_header(Input& table);

/// True for a table whose header names this spec (a path relative to the current folder or to the
/// folder of the table), or no spec. False for an input with a spec of its own.
bool may_be_made_from(const Input& table, const std::string& spec_path);

/// Returns the spec that the header of a table of Jounce names, if this file exists and its text
/// has changed since; otherwise "". With `same`, returns this spec if its text has not changed. The
/// path in the header is relative to the current folder or to the folder of the table.
/// `table_path`: the file of the table.
std::string newer_spec(const Provenance& provenance, const std::string& table_path,
                       bool same = false);

/// The command that makes a table file again from its spec: "jounce design cam.toml -o cam.csv".
std::string renewal(const Input& table, const std::string& spec_path);

}  // namespace jounce

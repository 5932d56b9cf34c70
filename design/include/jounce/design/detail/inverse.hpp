// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/algebra/inverse.hpp"
#include "jounce/design/input.hpp"

namespace jounce {

/// The inverse of a cam: the master as a function of the slave. Functions for `jounce inverse`.
/// Each throws InputError (key "input") for a motion over time.

/// A quantity of the command line as text, such as "25 mm"; "": not given.
struct InverseTexts {
  std::string at = {};         ///< master position inside the branch
  std::string from = {};       ///< first slave position of the table
  std::string to = {};         ///< last slave position of the table
  std::string tolerance = {};  ///< greatest error, in the unit of the master
};

/// A place at which the slave has a given position.
struct MasterPlace {
  MasterSpan master = {};    ///< the position of the master, or a range of a dwell
  std::string segment = {};  ///< name of the segment
};

/// Returns all places at which the slave has a position, such as "25 mm". Throws InputError (key
/// "slave") for a text that is not a position.
std::vector<MasterPlace> places_of_slave(const Input& input, const std::string& slave);

/// Returns one branch of the inverse as a cam, with its table. The error of the table includes the
/// error of the fit. The master of the result has the unit of the slave of `input`, and the slave
/// of the result the unit of its master. Default: the only branch, from its start to its end,
/// within 1e-9 of the length of the cam. Throws InputError with the names of the members of
/// InverseTexts, and key "from" or "to" if the slave is at rest at an end of the range.
Input inverse_of(const Input& input, const InverseTexts& texts);

/// The answer of `jounce inverse`.
struct InverseAnswer {
  std::string text = {}, json = {};
  bool found = true;  ///< false: the slave is never at the given position
  std::optional<TableFile> table = {};
};

/// Returns one of three answers. If `slave` is given: its places_of_slave(). Otherwise, if the name
/// of a file `table` is given: the table of inverse_of(). Otherwise: the branches of the inverse,
/// and the findings of inverted().
InverseAnswer inverse_answer(const Input& input, const std::string& slave, const std::string& table,
                             const InverseTexts& texts);

}  // namespace jounce

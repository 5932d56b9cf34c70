// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "jounce/stream/sender/client.hpp"

namespace jounce::web {

/// A command of an operator on the live page to an axis, as JSON: {"axis": "feeder", "what":
/// "override", "value": 0.5}.
///
/// The words of `what`:
/// - stop, hold, resume, override (`value`: factor on the velocity, 0 to 2): permitted at any time,
///   even if a session owns the axis;
/// - enable, disable, reset, move (`value`: position in the unit of the axis; the move uses the
///   configured limits): rejected while a session owns the axis;
/// - jog (`value`: velocity in the unit of the axis) and release: a hold-to-run jog, which the page
///   repeats (jogs.hpp). Both have the number of the jog in `hold`.
struct PageCommand {
  std::string axis{};     ///< name of the axis
  std::string what{};     ///< the command
  double value = 0;       ///< its value; 0 if it has none
  std::int64_t hold = 0;  ///< number of the jog; 0 for other commands
};

/// Reads a command from JSON. Throws InputError for JSON that is not such an object, an unknown key
/// or word, and a value that is missing, not expected, or out of range.
PageCommand read_command(std::string_view json);

/// Sends a command to the axis, except jog and release, and waits for the answer, like `jounce
/// order` and `jounce stop`. `link`: a link for this call only. Throws TransportError.
CallOutcome give(Transport& link, const PageCommand& command, const std::optional<wire::Key>& key);

}  // namespace jounce::web

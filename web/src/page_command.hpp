// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "jounce/stream/sender/client.hpp"

namespace jounce::web {

/// A command of an operator to an axis: {"axis": "feeder", "what": "override", "value": 0.5}.
///
/// `what` is stop, hold, resume, override (value: velocity factor 0 to 2), which take effect in
/// every session; or enable, disable, reset, move (value: position in the axis's unit, at its
/// configured limits), which are rejected while a streamer owns it. The page repeats a hold-to-run
/// jog (jogs.hpp): jog (value: velocity in the axis's unit), and release; both have the number of
/// the jog as `hold`.
struct PageCommand {
  std::string axis{};
  std::string what{};
  double value = 0;
  std::int64_t hold = 0;
};

/// Parses JSON. Throws InputError for JSON that is not such an object, an unknown key or word, and
/// a value that is missing, superfluous or out of range.
PageCommand read_command(std::string_view json);

/// Sends any command except jog and release to the axis, over a separate link for this call,
/// like `jounce order` and `jounce stop`, and waits for its answer. Throws TransportError.
CallOutcome give(Transport& link, const PageCommand& command, const std::optional<wire::Key>& key);

}  // namespace jounce::web

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
/// every session; or enable, disable, reset, move (value: position in the axis's unit, at the limits
/// it is configured with), which are refused while a streamer owns it. The page repeats a hold-to-run jog
/// (jogs.hpp): jog (value: velocity in the axis's unit), and release; both have the number of the jog as `hold`.
struct Instruction {
  std::string axis{};
  std::string what{};
  double value = 0;
  std::int64_t hold = 0;
};

/// From JSON. Throws InputError: no such object, an unknown key or word, a value that is missing,
/// too much, or out of range.
Instruction read_instruction(std::string_view json);

/// Gives all but jog and release to the axis, over a link for this call alone, as `jounce order` and `jounce stop`
/// do, and waits for its answer. Throws TransportError.
CallOutcome give(Transport& link, const Instruction& instruction,
                 const std::optional<wire::Key>& key);

}  // namespace jounce::web

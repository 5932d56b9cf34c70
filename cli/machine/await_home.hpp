// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/stream/sender/client.hpp"

#include "cli/machine/link.hpp"

namespace jounce::cli {

/// Waits until a homing that the axis has accepted is over, and keeps the client's session meanwhile. Ctrl-C
/// stops the axis. An axis that is not homed then has refused, with the cause of its fault or stop.
CallOutcome await_home(const std::string& executor, Client& client, Link& link);

}  // namespace jounce::cli

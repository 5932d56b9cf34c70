// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/machine/link.hpp"

namespace jounce::cli {

/// True if every machine of a network can command the axes of this address: the address leaves this machine, and there
/// is no key.
bool is_open(const LinkOptions& options);

/// Why that is dangerous, and what to do.
inline constexpr const char* open_warning =
    "this --url reaches other machines and there is no --key, so every machine of that network can "
    "move and stop these axes. Make a key with `jounce new key -o line.key`";

}  // namespace jounce::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/machine_spec.hpp"

#include "cli/machine/machine.hpp"

namespace jounce::cli {

/// Makes the master of a machine's spec, and what follows it does then. One that plays a table becomes one
/// more axis, a virtual one, behind those that are there. Throws InputError, placed in the document.
Follow add_machine_master(const MachineMasterSpec& spec, const Document& document,
                          const MachineOptions& options, MachineParts& parts);

}  // namespace jounce::cli

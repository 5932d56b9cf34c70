// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/machine/machine_parts.hpp"
#include "jounce/spec/machine_spec.hpp"

namespace jounce::machine_detail {

/// Makes the master of a machine's spec, and what follows it does then. One that plays a table becomes one
/// more axis, a virtual one, behind those that are there. Throws InputError, placed in the document.
Follow add_machine_master(const MachineMasterSpec& spec, const Document& document,
                          const MachineOptions& options, MachineParts& parts);

}  // namespace jounce::machine_detail

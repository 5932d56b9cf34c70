// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/machine/machine_parts.hpp"
#include "jounce/spec/machine_spec.hpp"

namespace jounce::machine_detail {

/// Makes the master of a machine spec, and returns how an axis follows it. A master that plays a
/// table becomes an additional, virtual axis after the others. Throws InputError with its place in
/// the document.
Follow add_machine_master(const MachineMasterSpec& spec, const Document& document,
                          const MachineOptions& options, MachineParts& parts);

}  // namespace jounce::machine_detail

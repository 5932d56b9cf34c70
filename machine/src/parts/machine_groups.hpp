// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/machine/machine_parts.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/machine_spec.hpp"

namespace jounce::machine_detail {

/// Adds a group of a machine spec as a further, virtual axis after the others, and plans its program
/// within the limits of its axes. Throws InputError with its place in the document.
void add_machine_group(const MachineSpec::Group& spec, const Document& document,
                       const MachineOptions& options, MachineParts& parts);

/// Returns an error about a group ("plotter.axes") with its place in the machine spec, and its
/// tolerance with its unit; any other error is returned unchanged.
InputError in_group(const MachineSpec& machine, const MachineParts& parts, const InputError& error);

}  // namespace jounce::machine_detail

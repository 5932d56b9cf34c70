// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// A spec of kind "drive": every number of the drive that is not zero, its limits and its settling
/// time, in the units that numbers() has. `head` comes first as a comment; `beside` are comments by the
/// key of a number ("mass[1].inertia"). Reading it back gives the same drive to the bit.
std::string drive_text(const DriveSpec& drive, const Units& units, const std::string& head,
                       const std::map<std::string, std::string>& beside = {});

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Writes a spec of kind "drive": every number of the drive that is not zero, its limits and its
/// settling time, in the units of numbers(). `head`: a comment at its beginning; `beside`: comments
/// by the key of a number ("mass[1].inertia"). Reading the result gives exactly the same drive.
std::string drive_text(const DriveSpec& drive, const Units& units, const std::string& head,
                       const std::map<std::string, std::string>& beside = {});

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Returns the text of a spec of kind "drive": every number of the drive that is not zero, its
/// limits and its settling time, in the units of numbers(). `head` is a comment at the beginning;
/// `beside` has comments by the key of a number ("mass[1].inertia"). Reading the text gives exactly
/// the same drive.
std::string drive_text(const DriveSpec& drive, const Units& units, const std::string& head,
                       const std::map<std::string, std::string>& beside = {});

}  // namespace jounce

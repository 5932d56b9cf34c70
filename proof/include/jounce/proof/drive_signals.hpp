// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Returns the samples of a drive's run as the contents of a file: NPY (one structured array) if
/// `path` ends in .npy, otherwise CSV. The columns have the names that `jounce identify` reads:
/// time, command (the reference), feedback (position of the motor), load, velocity (of the motor),
/// following error, torque and, if the motor has a torque constant, current.
std::string signals_file(const DriveResult& run, const Input& input, const std::string& path);

/// Throws InputError with this key unless the path ends in .csv or .npy, or is "-" (CSV).
void require_signals(const std::string& key, const std::string& path);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "jounce/validate/identify.hpp"

#include "validate/src/drive/drive_response.hpp"

namespace jounce::validate_detail {

inline constexpr std::array<const char*, outputs> quantities{"position", "velocity", "torque",
                                                             "load"};

/// Returns the recorded values of an output; empty: not recorded.
const std::vector<double>& recorded(const Recording& recording, std::size_t output);

/// Returns the number with this key. Throws InputError that lists all keys if there is none.
DriveNumber numbered(Drive& drive, const std::string& key);

/// Throw InputError as described for identify() and commanded_motion().
void require_times(const Recording& recording);
void require_valid(const Recording& recording);
void require_valid(const IdentifySpec& spec);

}  // namespace jounce::validate_detail

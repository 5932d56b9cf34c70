// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/report/messages.hpp"

namespace jounce {

/// Every fault and rejection of an axis, refusal of the stream, and rule of a check, in this order,
/// then the errors of controllers for a cam with their equivalents in Jounce.
std::vector<Message> all_messages();

}  // namespace jounce

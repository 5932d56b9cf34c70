// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/report/detail/messages.hpp"

namespace jounce {

/// Returns all messages, in this order: faults and rejections of an axis, refusals of the stream,
/// rules of a check, and errors of controllers for a cam with their equivalents in Jounce.
std::vector<Message> all_messages();

}  // namespace jounce

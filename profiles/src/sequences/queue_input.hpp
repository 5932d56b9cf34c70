// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/sequences/queue.hpp"

namespace jounce::profiles_detail {

/// Throws InputError for input that queue() rejects; keys count commands from 1.
void require_valid(const QueueSpec& spec);

}  // namespace jounce::profiles_detail

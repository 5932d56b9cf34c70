// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace jounce {

/// Returns the candidate that is nearest to `word`, for "did you mean" hints; "" if every candidate
/// differs by more than two edits. If the first letters differ, two edits are accepted only if
/// `word` is shorter than the candidate.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace jounce {

/// Returns the candidate that differs from `word` by at most two edits, for "did you mean" hints;
/// "" if there is none. If the first letters differ, two edits are accepted only if `word` is
/// shorter than the candidate.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace jounce

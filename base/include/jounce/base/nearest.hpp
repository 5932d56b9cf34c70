// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace jounce {

/// The candidate that differs from `word` by at most two edits, or "": for "did you mean" hints. If the first letter
/// differs, a second edit counts only if `word` is the shorter one.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// Replaces the advice of each broken limit of a derivative by an advice for its segment, with
/// numbers and units. Findings without a segment keep their advice.
void advise_on_limits(const Input& input, Report& report);
/// Like advise_on_limits() above, for a report on the cam `made`, whose shapes replace segments of
/// the cam `given`. The findings have the index of their segment in `given`.
void advise_on_limits(const CamSpec& given, const CamSpec& made, const Labels& labels,
                      Report& report);

/// Returns a sentence on the first broken limit of such a report that no law can satisfy with the
/// stroke and the length of the segment; "" if there is no such limit.
std::string impossible_limit(const CamSpec& given, const CamSpec& made, const Labels& labels,
                             const Report& report);

}  // namespace jounce

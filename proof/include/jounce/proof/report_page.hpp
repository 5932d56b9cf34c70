// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/plot/page.hpp"
#include "jounce/proof/proof.hpp"

namespace jounce {

/// The page of `jounce report`, and all findings on the page.
struct ReportPage {
  Page page;        ///< the page
  Report findings;  ///< findings of the exact check, then findings of the proof
};

/// Returns the page: the curve (if `before` is given, over its pale curve), the extrema of each
/// segment, limits and breaks, the proof, and the table. Throws InputError like prove(), and with
/// the key "before" if one input is over time and the other over a master.
ReportPage report_page(const Input& input, const std::optional<Input>& before,
                       const ProofOptions& options);

}  // namespace jounce

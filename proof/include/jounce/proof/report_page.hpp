// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/plot/page.hpp"
#include "jounce/proof/proof.hpp"

namespace jounce {

/// The page of `jounce report`, and all findings on it.
struct ReportPage {
  Page page;
  Report findings;  ///< findings of the exact check, then of the proof
};

/// The page: curve (over a paler one of `before`), extrema of each segment, limits and joints, proof, table. Throws
/// InputError as prove() does, and (key "before") if one input runs over time and the other over a master.
ReportPage report_page(const Input& input, const std::optional<Input>& before,
                       const ProofOptions& options);

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/plot/page.hpp"
#include "jounce/proof/proof.hpp"

namespace jounce {

/// Options of report_page().
struct ReportOptions {
  ProofOptions proof = {.drive_samples = 2000};  ///< options of the proof on the page
  std::string optimum = {};  ///< file with the output of `jounce optimize --json`; "": none
};

/// The page of `jounce report`, and all findings on the page.
struct ReportPage {
  Page page = {};        ///< the page
  Report findings = {};  ///< findings of the exact check, then findings of the proof
};

/// Returns the page: the curve (if `before` is given, over its pale curve), the extrema of each
/// segment, the result of the optimizer, the path or the disc, limits and breaks, the proof, the
/// table, and the spec with its findings. Throws InputError like prove(), with the key "before" if
/// one input is over time and the other over a master, and for a file `optimum` of another kind.
ReportPage report_page(const Input& input, const std::optional<Input>& before,
                       const ReportOptions& options = {});

/// Returns the page of the axes of a spec, at least two: the path, the sections of each axis, and
/// the spec with the findings of all axes. The charts of the axes have one cursor.
ReportPage report_page(const std::vector<Input>& axes, const ReportOptions& options = {});

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/executor/played.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/follower.hpp"
#include "jounce/validate/tolerances.hpp"
#include "jounce/validate/witness.hpp"

#include "cli/common/input.hpp"

namespace jounce::cli {

/// Everything that `validate` can prove of an input, and `report` can show.
struct Proof {
  Witness curve;                     ///< curve of the exact curve
  Witness table;                     ///< table of the table as the executor interpolates it
  std::optional<DriveResult> drive;  ///< if the spec has a [drive]
  std::optional<Played> played;      ///< if a tick log was given
  Report report;                     ///< all findings
  std::optional<ToleranceResult> tolerances = {};  ///< if the spec has [drive.tolerances]
  std::optional<FollowerResult> follower = {};     ///< if the spec has a [follower]
};

/// Integrates, drives, and compares with the executor's log if `log` is not empty.
Proof prove(const Input& input, const std::string& log, std::size_t drive_samples = 0);

/// The finding as a sentence, with the unit of its own.
std::string proof_text(const Proof& proof, const Input& input);

}  // namespace jounce::cli

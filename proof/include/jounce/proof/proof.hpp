// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "jounce/design/input.hpp"
#include "jounce/proof/played.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/follower.hpp"
#include "jounce/validate/tolerances.hpp"
#include "jounce/validate/witness.hpp"

namespace jounce {

/// The proof of an input: the result of `jounce validate`, which `jounce report` also shows.
///
///     const Input input = read_inputs("cam.toml").front();
///     const Proof proof = prove(input);
///     if (!proof.report.ok()) print(full_text(proof.report, input.labels));
struct Proof {
  Witness curve = {};  ///< integration of the exact curve
  Witness table = {};  ///< integration of the table, interpolated as in the executor
  std::optional<DriveResult> drive = {};  ///< result of the drive, if the spec has a [drive]
  std::optional<Played> played = {};      ///< comparison with a tick log, if one was given
  Report report = {};                     ///< all findings, with their units, sorted
  /// Result of [drive.tolerances], if the spec has them.
  std::optional<ToleranceResult> tolerances = {};
  /// Result of the follower, if the spec has a [follower].
  std::optional<FollowerResult> follower = {};
  /// True if the motion breaks a limit of its spec. The report contains no finding on these limits;
  /// for them, see check().
  bool breaks_limits = false;
};

/// Receives the share of the work that is done, 0 to 1.
using ProofProgress = std::function<void(double share)>;

/// Options of prove().
struct ProofOptions {
  std::string log = {};  ///< file with the tick log of an executor; "": none
  /// Number of equally spaced samples of drive and follower; 0: only the summary figures.
  std::size_t drive_samples = 0;
  /// Called by the calling thread while [drive.tolerances] is computed. An exception of the
  /// function ends the proof, and reaches the caller.
  ProofProgress progress = {};
};

/// Proves an input: integrates its curve and its table, simulates the [drive] and the [follower]
/// with the table, and compares the tick log with the curve and the table. Throws InputError for a
/// cam that has a [drive] or a [follower] but no [master], and for a file that is not a tick log.
Proof prove(const Input& input, const ProofOptions& options = {});

/// Returns the text of `jounce validate` for one input, without the findings.
std::string proof_text(const Proof& proof, const Input& input);

/// Returns the output of `jounce validate` for one input: the verdict, proof_text() and, if the
/// input is not proven, the findings.
std::string proof_answer(const Proof& proof, const Input& input);
/// Returns the result with all findings as a JSON object, with all digits of each number.
std::string proof_json(const Proof& proof, const Input& input);

}  // namespace jounce

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

/// The proof of an input: what `jounce validate` computes, and `jounce report` shows.
///
///     const Input input = read_inputs("cam.toml").front();
///     const Proof proof = prove(input);
///     if (!proof.report.ok()) print(full_text(proof.report, input.labels));
struct Proof {
  Witness curve;                     ///< witness of the exact curve
  Witness table;                     ///< witness of the table as the executor interpolates it
  std::optional<DriveResult> drive;  ///< if the spec has a [drive]
  std::optional<Played> played;      ///< if a tick log was given
  Report report;                     ///< all findings, with their units, sorted
  std::optional<ToleranceResult> tolerances = {};  ///< if the spec has [drive.tolerances]
  std::optional<FollowerResult> follower = {};     ///< if the spec has a [follower]
};

/// Receives the share of the work that is done, from 0 to 1.
using ProofProgress = std::function<void(double share)>;

struct ProofOptions {
  std::string log = {};  ///< file with the tick log of an executor; "": none
  std::size_t drive_samples =
      0;  ///< samples of drive and follower, equally spaced; 0: the figures alone
  ProofProgress progress =
      {};  ///< called by the calling thread while [drive.tolerances] is computed
};

/// Integrates the curve and its table, drives the [drive] and the [follower] with the table, and compares the log with
/// both. Throws InputError for a cam with a [drive] or a [follower] without a [master], and for a log that is not a
/// tick log.
Proof prove(const Input& input, const ProofOptions& options = {});

/// The numbers of a proof, one computation a line.
std::string proof_text(const Proof& proof, const Input& input);

/// The answer of `jounce validate` for one input: the verdict, proof_text(), and the findings if it is
/// not proven.
std::string proof_answer(const Proof& proof, const Input& input);

/// The answer with all findings as a JSON object, every number in full.
std::string proof_json(const Proof& proof, const Input& input);

}  // namespace jounce

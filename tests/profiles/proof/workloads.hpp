// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "profiles/proof/draw.hpp"

namespace jounce::proof {

/// Result of a workload.
struct Tally {
  std::int64_t cases = 0;
  std::int64_t failures = 0;
  /// Cases decided within rounding: the answer differs from the reference by more than 1e-9, but is
  /// the reference's for data that differ by `rounding` of their scale.
  std::int64_t ties = 0;
  double end_error = 0;  ///< worst, see Verdict
  double excess = 0;     ///< worst, see Verdict
  double longer = 0;     ///< worst, longer than the reference by this share of it, ties left out
  std::vector<std::string> examples = {};  ///< failures, the first `kept`
  std::size_t kept = 5;

  void fail(const std::string& why, const std::string& asked);
  void fail(const std::string& why, const Case& c);
  void note(const Verdict& verdict, const Case& c);
};

/// One experiment, done once with a case of its own drawing.
struct Workload {
  std::string name;
  std::string what;
  void (*once)(Random&, Tally&);  ///< null: check moves drawn by the draw of that name
  double weight = 100;            ///< share of a total, less if a case takes longer
};

const std::vector<Workload>& workloads();

Tally run(const Workload& workload, std::int64_t count, std::uint64_t seed, std::size_t kept = 5);

/// Uncertainty of the data of a problem in double precision, as a share of their scale.
constexpr double rounding = 64 * 0x1p-53;
/// Two durations are the same if they differ by no more than this share.
constexpr double same = 1e-9;

}  // namespace jounce::proof

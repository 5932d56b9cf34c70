// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// The optimum of a spec, as text and as a new spec.
struct SpecOptimum {
  std::string text = {};  ///< text for people: status, figures with their bounds, active limits
  std::string json =
      {};  ///< the contents of `text` as a JSON object, with all digits of each number
  /// The text of the spec with the best values, otherwise unchanged; nullopt if the best result
  /// breaks a limit.
  std::optional<std::string> spec = {};
};

/// Receives the share of the work that is done, 0 to 1, and the name of the present step. To stop
/// the optimizer with the best result so far, return false.
using OptimumProgress = std::function<bool(double done, const std::string& step)>;

/// Prepares a spec for optimum_of(). A path without [[optimize.parameter]] gets its corners as
/// parameters (corner_parameters() in tune.hpp), and its timing law is refined
/// (jounce/path/refine.hpp). `seconds` > 0: time limit, in place of the time limit of the spec.
/// Throws InputError like corner_parameters(), and with the key `seconds`.
void prepare_optimum(Spec& spec, std::optional<double> seconds = {});

/// Optimizes everything that a spec leaves free: the numbers of [[optimize.parameter]] if the spec
/// has any; otherwise the segments of free shape if it has any; otherwise the knots of a cam,
/// within their bounds.
///
///     const SpecOptimum best = optimum_of(read_spec("cam.toml"));
///     std::cout << best.text;
///     if (best.spec) write_file("better.toml", *best.spec);
///
/// Throws InputError, with the place in the document, unless the problem is complete and
/// consistent.
SpecOptimum optimum_of(const Spec& spec, const OptimumProgress& keep_going = {});

/// Optimizes segments of free shape for a drive that follows the cam (docs/optimize/against.md).
/// `drive` is a spec of kind "drive"; its unit of position must convert to the position unit of the
/// cam. Throws InputError like optimum_of(), and for a spec without a [master].
SpecOptimum optimum_against(const Spec& spec, const Spec& drive,
                            const OptimumProgress& keep_going = {});

/// Returns a comparison of the given and the optimized spec: their peaks and, for a path, the
/// duration with its proven lower bound.
std::string improvement_text(const Spec& given, const Spec& optimized);
/// Returns SpecOptimum::json with the peaks of the two specs.
std::string improvement_json(const SpecOptimum& best, const Spec& given, const Spec& optimized);

/// Returns the findings of `jounce check` that an optimized spec breaks, as text for people; "" if
/// it breaks none.
std::string broken_checks(const Spec& optimized);

}  // namespace jounce

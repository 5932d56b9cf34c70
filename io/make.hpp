#pragma once

#include <string>
#include <variant>
#include <vector>

#include "jounce/io/spec.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce {

/// What a spec makes: the exact curve, the table a controller gets, and how far they differ.
struct Made {
  std::variant<Cam, Trajectory> curve;
  std::vector<std::string> segments;  ///< a name for each segment of the curve, for reports
  Sampled sampled;
};

/// Spec -> generator -> curve -> table. Throws InputError, placed in the spec's document.
Made make(const Spec& spec);

/// The master's motion of a cam spec over time in *seconds*; without a [master] it is an InputError
/// that says what to add.
Trajectory make_master(const Spec& spec);

/// How many seconds one time unit of the spec is.
double seconds_per_unit(const Spec& spec);

/// The optimisation problem of a cam spec. Throws InputError, placed in the document, unless it is
/// well posed.
CamProblem make_problem(const Spec& spec);

}  // namespace jounce

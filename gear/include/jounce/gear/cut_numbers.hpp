// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/gear/cut_list.hpp"
#include "jounce/gear/cutter.hpp"

namespace jounce {

/// A cutter with its list, and its line: everything from which a CutTask is made.
struct CutJob {
  CutListSpec spec = {};
  CutLine line = {};
};

/// Returns the job as finite numbers, for a file.
std::vector<double> numbers_of(const CutJob& job);

/// Returns the job that numbers_of() has converted to these numbers. Throws InputError if the
/// numbers do not describe a job.
CutJob cut_job_of(std::span<const double> numbers);

}  // namespace jounce

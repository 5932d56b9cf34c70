// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "edit/src/jobs/job.hpp"

namespace jounce::edit_detail {

/// Starts the optimizer with the text of a spec. If it is stopped, the outcome is the best result so
/// far. `path`: name of the file. Throws InputError for a text that is not a complete spec.
std::unique_ptr<Job> optimum_job(const std::string& path, const std::string& text);

}  // namespace jounce::edit_detail

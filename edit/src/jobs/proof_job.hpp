// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "edit/src/jobs/job.hpp"

namespace jounce::edit_detail {

/// Starts `jounce validate` with the text of a spec. If it is stopped, the outcome has an error.
/// `path`: name of the file. Throws InputError for a text without a motion.
std::unique_ptr<Job> proof_job(const std::string& path, const std::string& text);

}  // namespace jounce::edit_detail

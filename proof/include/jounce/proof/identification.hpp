// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/figure.hpp"
#include "jounce/spec/spec.hpp"
#include "jounce/validate/identify.hpp"

/// The result of identify() as text, JSON, figure and drive file. `unit` is that of the position.
namespace jounce {

/// Start, fitted value and 95 % interval of each number, and the residual of each quantity.
std::string identification_text(const Identification& found, const std::string& unit);

/// The same as a JSON object, every number in full.
std::string identification_json(const Identification& found);

/// Each recorded quantity over the fitted model, and the residual below.
Figure identification_figure(const Identification& found, const Recording& run,
                             const std::string& title, const std::string& unit);

/// The text of a spec of kind "drive" with the fitted numbers; a comment beside each gives its
/// interval and its start. `remark` is the comment of the first line.
std::string fitted_drive_text(const Identification& found, DriveSpec drive, const Units& units,
                              const std::string& remark);

}  // namespace jounce

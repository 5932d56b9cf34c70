// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/figure.hpp"
#include "jounce/spec/spec.hpp"
#include "jounce/validate/identify.hpp"

/// The result of identify() as text, JSON, a figure and a drive file. `unit`: unit of the position.
namespace jounce {

/// Returns start, fitted value and 95 % interval of each parameter, and the residual of each
/// quantity, as text.
std::string identification_text(const Identification& found, const std::string& unit);

/// Returns the contents of identification_text() as a JSON object, with all digits of each number.
std::string identification_json(const Identification& found);

/// Returns a figure: each recorded quantity and the same quantity of the fitted model, with the
/// residual below.
Figure identification_figure(const Identification& found, const Recording& run,
                             const std::string& title, const std::string& unit);

/// Returns the text of a spec of kind "drive" with the fitted values. A comment next to each value
/// gives its interval and its value at the start of the fit. `remark` is the comment in the first
/// line.
std::string fitted_drive_text(const Identification& found, DriveSpec drive, const Units& units,
                              const std::string& remark);

}  // namespace jounce

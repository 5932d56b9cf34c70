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

/// Returns the text of the spec with the fitted values, otherwise unchanged. Comments at its
/// beginning give the interval of each value, its value at the start of the fit, and the recording
/// `log`. If a number is in another file, returns a spec of kind "drive" instead. The spec must
/// have a [drive].
std::string fitted_spec_text(const Identification& found, const Spec& spec, const std::string& log);

}  // namespace jounce

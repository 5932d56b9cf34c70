// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "validate/src/drive/drive_report.hpp"
#include "validate/src/exact/exact_figures.hpp"
#include "validate/src/linear/periodic.hpp"

namespace jounce {

std::optional<DriveResult> exact_through(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options) {
  require_valid(drive);
  require_valid(options, drive);
  validate_detail::require_within(options, reference.start(), reference.end());
  if (options.periodic) {
    validate_detail::require_steady(drive);
    if (auto unstable = validate_detail::without_steady_state(drive, reference.start()))
      return unstable;
  }
  if (nonlinearity(drive) || drive.controller.cycle > 0) return std::nullopt;
  std::optional<DriveResult> result = validate_detail::exact_figures(reference, drive, options);
  if (!result) return std::nullopt;
  const double duration = reference.length() + (options.periodic ? 0 : options.settle);
  std::vector<double> times;
  for (std::size_t i = 0; i < options.samples; ++i)
    times.push_back(reference.start() + (i == 0 ? 0
                                                : duration * static_cast<double>(i) /
                                                      static_cast<double>(options.samples - 1)));
  if (!times.empty())
    result->samples = options.periodic ? exact_period(reference, drive, times).samples
                                       : exact_run(reference, drive, times).samples;
  result->report = validate_detail::drive_report(*result, drive, options, reference.end());
  return result;
}

}  // namespace jounce

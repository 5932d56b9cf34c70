// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// A number of a drive that is known within a tolerance only.
struct NumberTolerance {
  std::string key;      ///< like numbers() names it: "mass[1].stiffness"
  double share = 0;     ///< share of its value, either way, >= 0: 0.1 is +-10 %
  double absolute = 0;  ///< in its own unit, either way, >= 0; both add up
  /// Otherwise every value is as likely. A normal one has its tolerance at three standard deviations,
  /// and none beyond.
  bool normal = false;
};

/// Distribution of the numbers.
///
///     ToleranceSpec spec{.numbers = {{.key = "mass[1].inertia", .share = 0.2},
///                                    {.key = "mass[1].stiffness", .share = 0.1}}};
///     const ToleranceResult worst = over_tolerances(table, drive, {.limits = limits}, spec);
///     worst.figures[0].worst.value;          // N m: the largest peak torque of any case
///     worst.figures[0].worst.numbers;        // and where: {"mass[1].inertia", 0.00024}, ...
struct ToleranceSpec {
  enum class Method {
    /// Each number at its least and at its greatest, all combinations. Of more than ten numbers each
    /// at both ends alone, and `cases` random combinations of ends.
    corners,
    monte_carlo,  ///< `cases` draws of all numbers at once
  };
  std::vector<NumberTolerance> numbers;
  Method method = Method::corners;
  std::size_t cases = 1000;  ///< 1 to 10 000 000
  std::uint64_t seed = 1;
};

/// One combination of the numbers, and the value of a figure for it.
struct ToleranceCase {
  double value = 0;
  std::vector<std::pair<std::string, double>> numbers;
};

/// A figure of the run over all cases, as a magnitude.
struct ToleranceSpread {
  /// "torque", "rms_torque", "following_error", "residual"; "settling_time" if a settling_band is
  /// given (a case that does not settle counts as the whole standstill, and as over the limit),
  /// "i2t" if the motor has a thermal_time, "driving_energy".
  std::string figure;
  std::string unit;    ///< "N m", "u": the reference's unit of position, "s", "1"
  double nominal = 0;  ///< value with the nominal numbers; NaN if that run failed
  double least = 0;
  double mean = 0;
  double deviation = 0;  ///< standard, of the sample; for corners it is not a statistic of machines
  double most_of_all = 0;  ///< the 99 % quantile of the cases
  ToleranceCase worst;     ///< the greatest
  std::size_t beyond = 0;  ///< cases over the limit, if there is one
};

struct ToleranceResult {
  std::size_t cases = 0;      ///< the nominal one not counted
  bool all_corners = false;   ///< every combination of ends was run
  std::size_t saturated = 0;  ///< cases that met a torque limit
  std::size_t failed = 0;     ///< cases whose integration did not end well
  std::size_t unstable = 0;   ///< cases whose loop is unstable (loop.hpp)
  std::vector<ToleranceSpread> figures;
  /// Findings in the unit of position leave theirs empty. "tolerance/torque",
  /// "tolerance/following_error", ...: the worst case against the limits given;
  /// "tolerance/integration" if a case failed, "tolerance/stability" if a case has an unstable
  /// loop.
  Report report;
};

/// Runs body(0) ... body(count - 1), each once, in any order and on any number of threads.
using ForEach =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

/// The run of drive_through() over all cases: the behaviour of machines that differ from the
/// nominal one.
///
/// The result does not depend on `for_each` (omitted: one after another), because every case has
/// its place. Corners find the worst case if a figure rises or falls monotonically with each
/// number, as it usually does; Monte Carlo can find a resonance between the ends.
///
/// Throws InputError like drive_through(), for a key that is unknown to numbers() or occurs twice,
/// and if a number at an end of its tolerance is not valid for the drive.
ToleranceResult over_tolerances(const SignalView& reference, const Drive& drive,
                                const DriveOptions& options, const ToleranceSpec& spec,
                                const ForEach& for_each = {});

/// The cases alone, one row per case, one column per number, in the order they are run.
std::vector<std::vector<double>> tolerance_cases(const Drive& drive, const ToleranceSpec& spec);

}  // namespace jounce

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

/// A number of a drive that is known only within a tolerance.
struct NumberTolerance {
  std::string key = {};  ///< key in numbers(): "mass[1].stiffness"
  double share = 0;  ///< tolerance in both directions, as a share of the value, >= 0: 0.1 is +-10 %
  /// Additional tolerance in both directions, in the unit of the number, >= 0.
  double absolute = 0;
  /// False: uniform distribution. True: normal distribution, cut off at the tolerance, which is
  /// three standard deviations.
  bool normal = false;
};

/// Numbers with tolerances, and the cases that are computed for them.
///
///     ToleranceSpec spec{.numbers = {{.key = "mass[1].inertia", .share = 0.2},
///                                    {.key = "mass[1].stiffness", .share = 0.1}}};
///     const ToleranceResult worst = over_tolerances(table, drive, {.limits = limits}, spec);
///     worst.figures[0].worst.value;          // N m: the largest peak torque of any case
///     worst.figures[0].worst.numbers;        // and where: {"mass[1].inertia", 0.00024}, ...
struct ToleranceSpec {
  /// Choice of the cases.
  enum class Method {
    /// All combinations of the least and the greatest value of each number. For more than ten
    /// numbers: each number alone at both ends, and `cases` random combinations of ends.
    corners,
    monte_carlo,  ///< `cases` random draws of all numbers
  };
  std::vector<NumberTolerance> numbers = {};  ///< the numbers
  Method method = Method::corners;            ///< choice of the cases
  std::size_t cases = 1000;                   ///< number of cases, 1 to 10 000 000
  std::uint64_t seed = 1;                     ///< seed of the random numbers
};

/// One case: the numbers, and the value of a figure for them.
struct ToleranceCase {
  double value = 0;                                          ///< value of the figure
  std::vector<std::pair<std::string, double>> numbers = {};  ///< keys and values of the numbers
};

/// Distribution of a figure, as a magnitude, over all cases.
struct ToleranceSpread {
  /// "torque", "rms_torque", "following_error", "residual", "driving_energy"; "i2t" if the motor
  /// has a thermal_time; "settling_time" if a settling_band is given. (A case that does not settle
  /// counts with the whole standstill as its time, and exceeds the limit.)
  std::string figure = {};
  std::string unit = {};  ///< "N m", "s", "1", or "u" for the unit of the reference
  double nominal = 0;     ///< value for the nominal numbers; NaN if the simulation with these
                          ///< numbers failed
  double least = 0;       ///< least value
  double mean = 0;        ///< mean
  /// Standard deviation over the cases. With corners, it is not a statistic of real machines.
  double deviation = 0;
  double most_of_all = 0;    ///< 99 % quantile of the cases
  ToleranceCase worst = {};  ///< the case with the greatest value
  std::size_t beyond = 0;    ///< number of cases that exceed the limit; 0 without a limit
};

/// Result of over_tolerances().
struct ToleranceResult {
  std::size_t cases = 0;                      ///< number of cases, without the nominal one
  bool all_corners = false;                   ///< true if all combinations of ends were computed
  std::size_t saturated = 0;                  ///< number of cases whose torque reached its limit
  std::size_t failed = 0;                     ///< number of cases whose integration failed
  std::size_t unstable = 0;                   ///< number of cases whose loop is unstable (loop.hpp)
  std::vector<ToleranceSpread> figures = {};  ///< the figures
  /// Findings: "tolerance/torque", "tolerance/following_error", ...: the worst case, for each given
  /// limit; "tolerance/integration" if a case failed; "tolerance/stability" if the loop of a case
  /// is unstable. If the value is in the unit of the position, Finding::unit is empty.
  Report report = {};
};

/// Calls body(0) to body(count - 1), each once. The calls may be in any order and in any number of
/// threads.
using ForEach =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

/// Computes drive_through() for all cases, to predict the behavior of machines that differ from the
/// nominal one.
///
/// Each case has a fixed place in the result, so the result does not depend on `for_each`. If
/// for_each is omitted, the cases are computed one after another. Corners find the worst case if a
/// figure rises or falls monotonically with each number, which is usual. Monte Carlo can find a
/// worse case between the ends, such as a resonance.
///
/// Throws InputError like drive_through(), for a `spec` without numbers, for a key that is not in
/// numbers() or occurs twice, and if an end of a tolerance is not valid for the drive.
ToleranceResult over_tolerances(const SignalView& reference, const Drive& drive,
                                const DriveOptions& options, const ToleranceSpec& spec,
                                const ForEach& for_each = {});

/// Returns the numbers of all cases: a row for each case, in the order of the cases, and a column
/// for each number.
std::vector<std::vector<double>> tolerance_cases(const Drive& drive, const ToleranceSpec& spec);

}  // namespace jounce

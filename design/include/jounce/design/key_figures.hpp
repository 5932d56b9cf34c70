// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/design/make.hpp"
#include "jounce/profiles/limits/limit_margins.hpp"

namespace jounce {

/// A key figure of a design.
struct KeyFigure {
  std::string name = {};             ///< "peak torque", ...
  double value = 0;                  ///< in `unit`
  std::string unit = {};             ///< "" for a pure number
  std::optional<double> limit = {};  ///< upper limit, if the spec has one
};

/// The key figures and the report of a complete design.
///
///     const Assessment all = assess(read_spec("cam.toml"));
///     for (const KeyFigure& f : all.figures) use(f.name, f.value, f.unit);
///     const Assessment one = assess(spec, {"peak torque"});
///     if (!one.report.ok()) ...
///
/// **Figures.** A figure is present if the spec has the data for it. Peaks and rms values are
/// magnitudes of the exact curve.
///
/// - "stroke", "knots" (of the table);
/// - for a motion, and for a cam with a [master]: "duration" (the spec's time unit), "peak
///   velocity", "peak acceleration", "peak jerk", and "rms velocity", ... (over the duration);
/// - for a cam: "peak geo_velocity", ... and "rms geo_velocity", ... (over the master);
/// - "master velocity", "cycle time" of a periodic cam, "fastest master" at which the slave is
///   within [limits.slave];
/// - figures of the generator: "longest cut", "fastest line",
///   "in step", ...;
/// - "predicted residual" of the first mode for which the spec has an operator, "predicted residual
///   2", ...;
/// - with a [drive]: "peak torque", "rms torque", "motor velocity", "following error", "end
///   following error", "residual", "residual frequency", "saturation time", "energy" (driving, J),
///   "regenerated energy"; if the drive has the data for them: "sync following error", "peak
///   current", "rms current", "settling time" (infinite: it does not settle), "swing" of a
///   pendulum, "i2t" (a share of the limit), "copper loss" (J);
/// - "margin": the smallest margin to all limits in the spec, as a share of the limit; negative: a
///   limit is broken; infinite: the spec has no limits.
///
/// Peaks do not include steps, which are in the report. If the spec has several axes, the name of
/// the axis is the prefix of each figure ("x peak velocity"), but the spec has only one "duration"
/// and one "margin".
struct Assessment {
  std::vector<KeyFigure> figures = {};  ///< requested figures; by default all, in the order above
  /// The findings on every limit in the spec: from check and, if the drive was simulated, from the
  /// drive.
  Report report = {};
  /// Margins of each segment; only from assess_by_segment(). The rules are the rules of `report`,
  /// followed by the name of the axis. Limits of a cam's slave over time have the rule
  /// "limit/master_velocity".
  std::vector<LimitMargin> margins = {};

  /// Returns the value of a figure; nullopt if it is not in `figures`.
  [[nodiscard]] std::optional<double> value(const std::string& name) const;
};

/// True if a finding is considered for "margin". The tolerance of a table and the continuity at
/// breaks are considered only if they are broken, because the design makes them no better than
/// necessary.
bool states_limit(const Finding& finding);

/// Makes the spec, checks it against its limits, and returns the figures in `names`; all figures if
/// `names` is empty. Simulates the [drive] of the spec only for "margin" and the figures of the
/// drive. Throws InputError like make(); for a name that is not a figure of this spec (the message
/// lists the figures); and if the integration of the drive does not reach the end. Thread-safe.
Assessment assess(const Spec& spec, const std::vector<std::string>& names = {});

/// Like assess(), with the margins of each segment (`margins`).
Assessment assess_by_segment(const Spec& spec, const std::vector<std::string>& names);

/// Returns the rule of a finding, followed by the name of its axis if it has one.
std::string rule_of(const Finding& finding);

}  // namespace jounce

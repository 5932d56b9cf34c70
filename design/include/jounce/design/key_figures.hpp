// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/design/make.hpp"
#include "jounce/profiles/limits/limit_margins.hpp"

namespace jounce {

/// One number for the quality of a design.
struct KeyFigure {
  std::string name;
  double value = 0;
  std::string unit;                  ///< "" for a pure number
  std::optional<double> limit = {};  ///< upper limit, if the spec states one
};

/// The assessment of a complete design.
///
///     const Assessment all = assess(read_spec("cam.toml"));
///     for (const KeyFigure& f : all.figures) print(f.name, f.value, f.unit);
///     const Assessment one = assess(spec, {"peak torque"});
///     if (!one.report.ok()) ...
///
/// **Figures**, each if the spec has the data for it; magnitudes, all of the exact curve:
///
/// - "stroke", "knots" of the table;
/// - of a motion, and of a cam with a [master]: "duration" (the spec's time unit), "peak velocity",
///   "peak acceleration", "peak jerk" and their "rms ..." (sqrt of the mean square over the duration);
/// - of a cam: "peak geo_velocity", ... and "rms geo_velocity", ... over the master;
/// - "master velocity", "cycle time" of a periodic cam, "fastest master" that [limits.slave] allows;
/// - figures of the generator (sync_figures): "longest cut", "fastest line", "in step" ...;
/// - "predicted residual" of the first mode that an operator was made for, "predicted residual 2" ...;
/// - with a [drive]: "peak torque", "rms torque", "motor velocity", "following error", "end following
///   error", "residual", "residual frequency", "saturation time", "energy" (driving, J), "regenerated
///   energy"; if the drive has the data for them, "sync following error", "peak current", "rms current",
///   "settling time" (infinite: never), "swing" of a pendulum, "i2t" (a share of the limit), "copper
///   loss" (J);
/// - "margin": the smallest margin of all limits in the spec, as a share of the limit; below 0: broken;
///   infinite if there are none.
///
/// Peaks exclude steps, which are in the report. A spec of several axes has them for each, with its
/// name as prefix ("x peak velocity"), but one "duration" and one "margin".
struct Assessment {
  std::vector<KeyFigure> figures;  ///< requested figures; by default in the order above
  Report report;  ///< every limit in the spec: check, and the drive if it was simulated
  /// Limits of the curves, segment by segment, if requested; rules as in `report`, followed by the
  /// axis. Those of a cam's slave over time are under "limit/master_velocity".
  std::vector<LimitMargin> rooms = {};

  [[nodiscard]] std::optional<double> value(const std::string& name) const;
};

/// True if a finding counts for the margin. The tolerance of a table and the continuity of joints
/// count only if they are broken: they hold as well as the design needs, and no better.
bool states_limit(const Finding& finding);

/// Makes the spec, checks it against its limits and simulates its [drive], if it has one and
/// `names` contains a figure of it or "margin". No names: everything. Throws InputError like
/// make(), for a name that is not a figure of this spec (the message lists them), and if the
/// drive's integration does not reach the end. Thread-safe.
Assessment assess(const Spec& spec, const std::vector<std::string>& names = {});

/// The same, and `rooms`.
Assessment assess_by_segment(const Spec& spec, const std::vector<std::string>& names);

/// A finding's rule, followed by its axis, if it has one.
std::string rule_of(const Finding& finding);

}  // namespace jounce

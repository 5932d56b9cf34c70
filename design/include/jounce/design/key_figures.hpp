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
  std::optional<double> limit = {};  ///< at most, where the spec states it
};

/// A design looked at as a whole.
///
///     const Assessment all = assess(read_spec("cam.toml"));
///     for (const KeyFigure& f : all.figures) print(f.name, f.value, f.unit);
///     const Assessment one = assess(spec, {"peak torque"});
///     if (!one.report.ok()) ...
///
/// **Figures**, each where the spec has what it is made of, magnitudes, all of the exact curve:
///
/// - "stroke", "knots" of the table;
/// - of a motion, and of a cam with a [master]: "duration" (the spec's time unit), "peak velocity",
///   "peak acceleration", "peak jerk" and their "rms ..." (sqrt of the mean square over the duration);
/// - of a cam: "peak geo_velocity", ... and "rms geo_velocity", ... over the master;
/// - "master velocity", "cycle time" of a periodic cam, "fastest master" that [limits.slave] allows;
/// - figures of the generator (sync_figures): "longest cut", "fastest line", "in step" ...;
/// - "predicted residual" of the first mode that an operator was made for, "predicted residual 2" ...;
/// - with a [drive]: "peak torque", "rms torque", "motor velocity", "following error", "end following
///   error", "residual", "residual frequency", "saturation time", "energy" (J that it drives with),
///   "regenerated energy"; where it has what they are made of "sync following error", "peak current",
///   "rms current", "settling time" (infinite: never), "swing" of a pendulum, "i2t" (a share of the
///   limit), "copper loss" (J);
/// - "margin": the smallest of all limits that the spec states, a share of the limit, below 0: broken;
///   infinite where it states none.
///
/// Peaks are those between steps, which the report has. A spec of several axes has them for each,
/// behind its name ("x peak velocity"), but one "duration" and one "margin".
struct Assessment {
  std::vector<KeyFigure> figures;  ///< requested figures; by default in the order above
  Report report;  ///< every limit that the spec states: check, and the drive where it was driven
  /// Limits of the curves, segment by segment, where they were asked for; rules as in `report`, with the
  /// axis behind them. Those of a cam's slave over time stand under "limit/master_velocity".
  std::vector<LimitMargin> rooms = {};

  [[nodiscard]] std::optional<double> value(const std::string& name) const;
};

/// True if a finding counts for the margin. A table meets its tolerance, and joints are as continuous as
/// they are: rules that hold as well as the design needs it to, and no better, only if they are broken.
bool states_limit(const Finding& finding);

/// Makes the spec, checks it against its limits and, where it has a [drive], drives it; the drive is
/// left out where `names` asks neither for a figure of it nor for "margin". No names: everything.
/// Throws InputError as make() does, for a name that this spec has no figure for (with those it has),
/// and where the drive's integration does not reach the end. Threads may call it at once.
Assessment assess(const Spec& spec, const std::vector<std::string>& names = {});

/// The same, and `rooms`.
Assessment assess_by_segment(const Spec& spec, const std::vector<std::string>& names);

/// A finding's rule with its axis behind it, where it has one.
std::string rule_of(const Finding& finding);

}  // namespace jounce

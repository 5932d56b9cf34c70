// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "jounce/profiles/detail/random.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce {
namespace {

constexpr std::size_t all_corners_up_to = 10;  // numbers: 1024 cases

/// The same cases on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}

  /// In [0, 1).
  double uniform() { return profiles_detail::uniform(state_); }

  /// In [-1, 1], three standard deviations to each side (Box & Muller 1958; beyond: drawn again).
  double normal() {
    for (;;) {
      const double radius = std::sqrt(-2 * std::log(1 - uniform()));
      const double x = radius * std::cos(2 * std::numbers::pi * uniform()) / 3;
      if (std::abs(x) <= 1) return x;
    }
  }

  double either() { return uniform() < 0.5 ? -1 : 1; }

 private:
  std::uint64_t state_;
};

double& number_of(Drive& drive, const std::string& key) {
  for (const DriveNumber& n : numbers(drive))
    if (n.key == key) return *n.value;
  throw InputError("tolerances.key", key, "names no number of this drive");
}

/// The varied numbers: middle and half width of each.
struct Band {
  std::string key;
  double middle;
  double half;
  bool normal;
};

std::vector<Band> bands_of(const Drive& drive, const ToleranceSpec& spec) {
  std::vector<Band> bands;
  Drive copy = drive;
  for (const NumberTolerance& t : spec.numbers) {
    require_not_negative("tolerances.share", t.share);
    require_not_negative("tolerances.absolute", t.absolute);
    const double middle = number_of(copy, t.key);
    for (const Band& b : bands)
      if (b.key == t.key) throw InputError("tolerances.key", t.key, "is given twice");
    bands.push_back({t.key, middle, t.share * std::abs(middle) + t.absolute, t.normal});
  }
  return bands;
}

Drive with(const Drive& drive, const std::vector<Band>& bands, const std::vector<double>& values) {
  Drive other = drive;
  for (std::size_t i = 0; i < bands.size(); ++i) number_of(other, bands[i].key) = values[i];
  return other;
}

/// Both ends of every number, alone, must make a drive.
void require_ends(const Drive& drive, const std::vector<Band>& bands) {
  for (const Band& b : bands)
    for (const double end : {b.middle - b.half, b.middle + b.half}) {
      Drive other = drive;
      number_of(other, b.key) = end;
      try {
        require_valid(other);
      } catch (const InputError& error) {
        throw InputError("tolerances." + b.key, end,
                         error.rule() + ", also at the end of its tolerance: give a smaller share");
      }
    }
}

using Rows = std::vector<std::vector<double>>;

std::vector<double> middles(const std::vector<Band>& bands) {
  std::vector<double> values;
  for (const Band& b : bands) values.push_back(b.middle);
  return values;
}

Rows every_corner(const std::vector<Band>& bands) {
  Rows rows;
  for (std::size_t bits = 0; bits < std::size_t{1} << bands.size(); ++bits) {
    std::vector<double> row = middles(bands);
    for (std::size_t i = 0; i < bands.size(); ++i)
      row[i] += ((bits >> i) & 1U) != 0 ? bands[i].half : -bands[i].half;
    rows.push_back(std::move(row));
  }
  return rows;
}

Rows some_corners(const std::vector<Band>& bands, const ToleranceSpec& spec) {
  Rows rows;
  for (std::size_t i = 0; i < bands.size(); ++i)
    for (const double sign : {-1.0, 1.0}) {
      rows.push_back(middles(bands));
      rows.back()[i] += sign * bands[i].half;
    }
  Draw draw(spec.seed);
  for (std::size_t k = 0; k < spec.cases; ++k) {
    rows.push_back(middles(bands));
    for (std::size_t i = 0; i < bands.size(); ++i) rows.back()[i] += draw.either() * bands[i].half;
  }
  return rows;
}

Rows draws(const std::vector<Band>& bands, const ToleranceSpec& spec) {
  Rows rows;
  Draw draw(spec.seed);
  for (std::size_t k = 0; k < spec.cases; ++k) {
    rows.push_back(middles(bands));
    for (std::size_t i = 0; i < bands.size(); ++i)
      rows.back()[i] += (bands[i].normal ? draw.normal() : 2 * draw.uniform() - 1) * bands[i].half;
  }
  return rows;
}

Rows rows_of(const std::vector<Band>& bands, const ToleranceSpec& spec) {
  if (spec.method == ToleranceSpec::Method::monte_carlo) return draws(bands, spec);
  return bands.size() <= all_corners_up_to ? every_corner(bands) : some_corners(bands, spec);
}

// ---- figures ------------------------------------------------------------------------------------

/// The recorded figures of a run, in the order of `figures` below.
struct FigureOf {
  const char* name;
  const char* unit;
  double (*value)(const DriveResult&);
  std::optional<double> DriveLimits::*limit = nullptr;
  bool (*there)(const Drive&, const DriveOptions&) = nullptr;  ///< left out: always
};

constexpr std::array figures{
    FigureOf{"torque", "N m", [](const DriveResult& r) { return std::abs(r.torque.value); },
             &DriveLimits::torque},
    FigureOf{"rms_torque", "N m", [](const DriveResult& r) { return r.rms_torque; },
             &DriveLimits::rms_torque},
    FigureOf{"following_error", "u",
             [](const DriveResult& r) { return std::abs(r.following_error.value); },
             &DriveLimits::following_error},
    FigureOf{"residual", "u", [](const DriveResult& r) { return std::abs(r.residual.value); },
             &DriveLimits::residual},
    FigureOf{
        "settling_time", "s", [](const DriveResult& r) { return r.settling_time.value_or(0); },
        &DriveLimits::settling_time,
        [](const Drive&, const DriveOptions& o) { return o.limits.settling_band.has_value(); }},
    FigureOf{"i2t", "1", [](const DriveResult& r) { return r.i2t.value; }, nullptr,
             [](const Drive& d, const DriveOptions&) { return d.motor.thermal_time > 0; }},
    FigureOf{"driving_energy", "J", [](const DriveResult& r) { return r.energy.driving; }},
};

struct Kept {
  std::array<double, figures.size()> values{};
  bool saturated = false;
  bool unsettled = false;  // within the watched standstill
  bool failed = false;
  bool unstable = false;
};

/// A figure of a run. A settling that did not end within the standstill counts as the whole standstill.
double value_of(const FigureOf& figure, const DriveResult& run, const DriveOptions& options) {
  if (!run.integration.ok()) return std::numeric_limits<double>::quiet_NaN();
  if (figure.limit == &DriveLimits::settling_time && !run.settling_time) return options.settle;
  return figure.value(run);
}

Kept keep(const DriveResult& run, const DriveOptions& options) {
  Kept kept;
  for (std::size_t i = 0; i < figures.size(); ++i)
    kept.values[i] = value_of(figures[i], run, options);
  kept.unsettled = !run.settling_time;
  kept.saturated = !run.saturation.empty();
  kept.failed = !run.integration.ok();
  kept.unstable = std::any_of(run.report.findings.begin(), run.report.findings.end(),
                              [](const Finding& f) { return f.rule == "drive/stability"; });
  return kept;
}

std::optional<double> limit_of(const FigureOf& figure, const DriveLimits& limits) {
  return figure.limit == nullptr ? std::nullopt : limits.*figure.limit;
}

ToleranceSpread spread(std::size_t figure, const std::vector<Kept>& cases, const Rows& rows,
                       const std::vector<Band>& bands, const DriveLimits& limits) {
  ToleranceSpread s;
  s.figure = figures[figure].name;
  s.unit = figures[figure].unit;
  const std::optional<double> limit = limit_of(figures[figure], limits);
  const bool times = figures[figure].limit == &DriveLimits::settling_time;
  std::vector<double> values;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].failed) continue;
    values.push_back(cases[i].values[figure]);
    if (cases[worst].failed || values.back() > cases[worst].values[figure]) worst = i;
    if (limit && (!(values.back() <= *limit) || (times && cases[i].unsettled))) ++s.beyond;
  }
  if (values.empty()) return s;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  s.least = values.front();
  s.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.deviation = values.size() > 1 ? std::sqrt(squares / (count - 1)) : 0;
  s.most_of_all = values[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1];
  s.worst.value = values.back();
  for (std::size_t i = 0; i < bands.size(); ++i)
    s.worst.numbers.emplace_back(bands[i].key, rows[worst][i]);
  return s;
}

std::string where(const ToleranceCase& c) {
  std::string text = "worst at ";
  for (std::size_t i = 0; i < c.numbers.size(); ++i)
    text += (i > 0 ? ", " : "") + c.numbers[i].first + " = " + number(c.numbers[i].second);
  return text;
}

Report report_of(const ToleranceResult& result, const DriveLimits& limits) {
  Report report;
  for (const ToleranceSpread& s : result.figures) {
    const FigureOf& figure = *std::find_if(figures.begin(), figures.end(),
                                           [&](const FigureOf& f) { return f.name == s.figure; });
    const std::optional<double> limit = limit_of(figure, limits);
    if (!limit || result.failed == result.cases) continue;
    Finding finding;
    finding.rule = Rule(RuleFamily::tolerance, s.figure);
    finding.quantity = s.figure;
    if (s.unit != "u") finding.unit = s.unit;
    finding.value = s.worst.value;
    finding.limit = *limit;
    finding.margin = (*limit - s.worst.value) / *limit;
    finding.broken = s.beyond > 0;
    if (finding.broken) finding.margin = std::min(finding.margin, 0.0);
    if (finding.broken)
      finding.advice = std::to_string(s.beyond) + " of " + std::to_string(result.cases) +
                       " cases exceed it; " + where(s.worst);
    report.findings.push_back(std::move(finding));
  }
  if (result.failed > 0) {
    Finding finding;
    finding.rule = "tolerance/integration";
    finding.quantity = "cases";
    finding.value = static_cast<double>(result.failed);
    finding.broken = true;
    finding.advice = "cases without a complete integration are excluded from the figures";
    report.findings.push_back(std::move(finding));
  }
  if (result.unstable > 0) {
    Finding finding;
    finding.rule = "tolerance/stability";
    finding.quantity = "unstable cases";
    finding.unit = "1";
    finding.value = static_cast<double>(result.unstable);
    finding.margin = -1e6;  // before the limits that these cases break
    finding.has_limit = false;
    finding.broken = true;
    finding.advice = "widen the gain margin of the drive, or narrow its tolerances";
    report.findings.push_back(std::move(finding));
  }
  sort(report);
  return report;
}

void require_valid(const ToleranceSpec& spec) {
  if (spec.numbers.empty())
    throw InputError("tolerances.number", "", "must name at least one number");
  if (spec.cases < 1 || spec.cases > 10'000'000)
    throw InputError("tolerances.cases", std::to_string(spec.cases),
                     "must be between 1 and 10000000");
}

}  // namespace

std::vector<std::vector<double>> tolerance_cases(const Drive& drive, const ToleranceSpec& spec) {
  require_valid(spec);
  return rows_of(bands_of(drive, spec), spec);
}

ToleranceResult over_tolerances(const SignalView& reference, const Drive& drive,
                                const DriveOptions& options, const ToleranceSpec& spec,
                                const ForEach& for_each) {
  require_valid(spec);
  DriveOptions quick = options;
  quick.samples = 0;
  // a drive with an exact solution is not integrated
  const std::optional<Trajectory> segments = reference.trajectory();
  const auto through = [&](const Drive& of) {
    if (auto exact = segments ? exact_through(*segments, of, quick) : std::nullopt) return *exact;
    return drive_through(reference, of, quick);
  };
  const DriveResult nominal = through(drive);  // or throws, before the rest
  const std::vector<Band> bands = bands_of(drive, spec);
  require_ends(drive, bands);
  const Rows rows = rows_of(bands, spec);
  std::vector<Kept> cases(rows.size());
  const auto run = [&](std::size_t i) {
    cases[i] = keep(through(with(drive, bands, rows[i])), quick);
  };
  if (for_each) {
    for_each(rows.size(), run);
  } else {
    for (std::size_t i = 0; i < rows.size(); ++i) run(i);
  }
  ToleranceResult result;
  result.cases = rows.size();
  result.all_corners =
      spec.method == ToleranceSpec::Method::corners && bands.size() <= all_corners_up_to;
  for (const Kept& c : cases) {
    result.saturated += c.saturated ? 1 : 0;
    result.failed += c.failed ? 1 : 0;
    result.unstable += c.unstable ? 1 : 0;
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (figures[i].there != nullptr && !figures[i].there(drive, options)) continue;
    result.figures.push_back(spread(i, cases, rows, bands, options.limits));
    result.figures.back().nominal = value_of(figures[i], nominal, quick);
  }
  result.report = report_of(result, options.limits);
  return result;
}

}  // namespace jounce

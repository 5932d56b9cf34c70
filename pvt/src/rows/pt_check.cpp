// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/pvt/pt.hpp"
#include "jounce/pvt/warnings.hpp"

// In a chain of normal segments b = 2 P/T - a: an error e of a rate becomes -e at the end of the
// segment, +e at the end of the next, and so on. So the rate goes up and down from point to point.
// Four such segments in a row count as an oscillation.

namespace jounce {
namespace {

constexpr std::size_t least_swings = 4;

bool is_chained(PtType type) {
  return type == PtType::normal || type == PtType::continued;
}

/// Segments first to last, each of which changes the rate in the opposite direction to the previous
/// one.
struct Swing {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t worst = 0;
};

/// All such runs of at least `least_swings` segments.
std::vector<Swing> swings(std::span<const PtPoint> points, const std::vector<PtRate>& rates,
                          double least) {
  const auto change = [&](std::size_t i) { return rates[i].end - rates[i].start; };
  std::vector<Swing> all;
  Swing run;
  const auto close = [&] {
    if (run.last - run.first + 1 >= least_swings) all.push_back(run);
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool turns = is_chained(points[i].type) && change(i) * change(i - 1) < 0 &&
                       std::min(std::abs(change(i)), std::abs(change(i - 1))) > least;
    if (turns) {
      run.last = i;
      if (std::abs(change(i)) > std::abs(change(run.worst))) run.worst = i;
    } else {
      close();
      run = {i, i, i};
    }
  }
  close();
  return all;
}

template <class Over>
Finding finding_of(const Swing& run, std::span<const PtPoint> points,
                   const std::vector<PtRate>& rates, double scale) {
  const PtRate& rate = rates[run.worst];
  Finding found;
  found.rule = "pt/oscillation";
  found.quantity = Over::names[1];
  found.where = points[run.worst].x;
  found.value = rate.end - rate.start;
  found.margin = -std::abs(found.value) / scale;
  found.segment = run.worst;
  found.severity = Severity::warning;
  found.advice = "the velocity goes up and down from segment " + std::to_string(run.first + 1) +
                 " to " + std::to_string(run.last + 1) +
                 ": a normal segment passes the error of its increment to the next one, with the "
                 "opposite sign. Give the first segment the increment of a start from rest, and do "
                 "not round the others";
  return found;
}

const char* advice_to(PtType type) {
  switch (type) {
    case PtType::even:
      return "an even segment runs at P/T (its travel by its time) from its first instant, which "
             "needs an infinite acceleration: let the previous segment end at P/T, or give this "
             "one type = \"normal\"";
    case PtType::stop:
      return "a stop segment always begins at 2P/T (twice its travel by its time), which needs an "
             "infinite acceleration: choose its travel P so that 2P/T is the velocity before";
    case PtType::normal:
    case PtType::continued:
      break;
  }
  return "the step needs an infinite acceleration: let the previous segment end at the velocity at "
         "which this one begins";
}

}  // namespace

template <class Over>
Report check_pt(std::span<const PtPoint> points, double start_rate, Extrapolation outside,
                double tolerance) {
  const Curve<Over> f = pt<Over>(points, start_rate, outside);
  const std::vector<PtRate> rates = pt_rates<Over>(points, start_rate);
  Report report = velocity_steps(f, tolerance);
  for (Finding& found : report.findings)
    if (found.rule == "pt/velocity_step") found.advice = advice_to(points[*found.segment].type);
  const double scale = std::abs(extrema(f, 1).peak().value);
  for (const Swing& run : swings(points, rates, tolerance * scale))
    report.findings.push_back(finding_of<Over>(run, points, rates, scale));
  sort(report);
  return report;
}

template Report check_pt<OverTime>(std::span<const PtPoint>, double, Extrapolation, double);
template Report check_pt<OverMaster>(std::span<const PtPoint>, double, Extrapolation, double);

}  // namespace jounce

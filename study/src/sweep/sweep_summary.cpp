// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sweep_summary.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "study/src/sweep/pareto.hpp"

namespace jounce {
namespace {

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half),
                   values.end());
  if (values.size() % 2 == 1) return values[half];
  const double below =
      *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half));
  return below == values[half] ? below
                               : below + (values[half] - below) / 2;  // both may be infinite
}

/// Mean and deviation in two passes: no cancellation. An infinite value makes them infinite; equal values
/// have no deviation.
void moments(const std::vector<double>& values, FigureSpread& spread) {
  const auto n = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (spread.least == spread.greatest) {
    spread.mean = spread.least;
    spread.deviation = 0;
    return;
  }
  if (!std::isfinite(spread.mean)) {
    spread.deviation = std::numeric_limits<double>::infinity();
    return;
  }
  double squares = 0;
  for (const double v : values) squares += (v - spread.mean) * (v - spread.mean);
  spread.deviation = values.size() > 1 ? std::sqrt(squares / (n - 1)) : 0;
}

FigureSpread spread_of(const SweepSpec& spec, const SweepResult& result, std::size_t column) {
  FigureSpread spread{.given = spec.given[column], .limit = spec.given[column].limit};
  for (const SweepLimit& limit : spec.limits)
    if (limit.figure == spread.given.name)
      spread.limit = std::min(limit.at_most, spread.limit.value_or(limit.at_most));
  std::vector<double> values;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    if (result.rows[i].verdict == Verdict::impossible) continue;
    const double value = result.rows[i].figures[column];
    if (values.empty() || value < spread.least) spread.least = value, spread.least_case = i;
    if (values.empty() || value > spread.greatest)
      spread.greatest = value, spread.greatest_case = i;
    values.push_back(value);
  }
  spread.median = median(values);
  moments(values, spread);
  return spread;
}

std::vector<std::size_t> front_of(const SweepSpec& spec, const SweepResult& result) {
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    if (result.rows[i].verdict != Verdict::within) continue;
    rows.push_back(i);
    auto& point = points.emplace_back();
    for (const SweepObjective& o : spec.objectives) {
      const double value = result.rows[i].figures[column_of(spec, o.figure)];
      point.push_back(o.greatest ? -value : value);
    }
  }
  std::vector<std::size_t> front;
  for (const std::size_t i : pareto_front(points)) front.push_back(rows[i]);
  const std::size_t along = column_of(spec, spec.objectives.front().figure);
  std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return result.rows[a].figures[along] < result.rows[b].figures[along];
  });
  return front;
}

}  // namespace

std::size_t column_of(const SweepSpec& spec, const std::string& figure) {
  const auto at = std::find_if(spec.given.begin(), spec.given.end(),
                               [&](const KeyFigure& f) { return f.name == figure; });
  assert(at != spec.given.end());
  return static_cast<std::size_t>(at - spec.given.begin());
}

Share share_of(std::size_t hits, std::size_t n) {
  constexpr double z = 1.959963984540054;  // quantile of 97.5 %
  const auto total = static_cast<double>(n);
  const double p = static_cast<double>(hits) / total;
  const double middle = (p + z * z / (2 * total)) / (1 + z * z / total);
  const double half =
      z / (1 + z * z / total) * std::sqrt(p * (1 - p) / total + z * z / (4 * total * total));
  return {p, hits == 0 ? 0 : middle - half, hits == n ? 1 : middle + half};
}

SweepSummary summary_of(const SweepSpec& spec, const SweepResult& result) {
  SweepSummary all;
  all.cases = result.rows.size();
  const std::size_t margin = column_of(spec, "margin");
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const SweepRow& row = result.rows[i];
    all.within += row.verdict == Verdict::within ? 1U : 0U;
    all.broken += row.verdict == Verdict::broken ? 1U : 0U;
    all.impossible += row.verdict == Verdict::impossible ? 1U : 0U;
    if (row.verdict != Verdict::impossible &&
        (!all.worst || row.figures[margin] < result.rows[*all.worst].figures[margin]))
      all.worst = i;
  }
  if (spec.random() && all.cases > 0) all.yield = share_of(all.within, all.cases);
  if (all.within + all.broken > 0)
    for (std::size_t c = 0; c < spec.given.size(); ++c)
      all.figures.push_back(spread_of(spec, result, c));
  if (!spec.objectives.empty()) all.front = front_of(spec, result);
  return all;
}

}  // namespace jounce

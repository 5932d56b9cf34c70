// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/loop.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "validate/src/loop/open_loop.hpp"

namespace jounce {
namespace {

using Complex = std::complex<double>;
using validate_detail::OpenLoop;

constexpr double narrowest_pole = 1e-6;  ///< width of a pole, as a share of its frequency
constexpr double pole_at_zero = 1e-9;    ///< share of the fastest pole
/// Imaginary part of a crossing of the real axis, as a share.
constexpr double real_crossing = 1e-6;
constexpr double tau = 2 * std::numbers::pi;
constexpr int per_decade = 200;
constexpr double rounded_growth = 1e-10;  // relative rounding of eigenvalues, to the greatest
constexpr double most_delay_cycles = 100;

bool too_late(const Controller& c) {
  return c.cycle > 0 && c.delay > most_delay_cycles * c.cycle;
}

void require_loop(const Drive& drive) {
  require_valid(drive);
  const Controller& c = drive.controller;
  if (too_late(c))
    throw InputError(
        "controller.delay", c.delay,
        "must be at most 100 cycles = " + six_digits(most_delay_cycles * c.cycle) + " s");
}

LoopPole pole_of(Complex s) {
  const double size = std::abs(s);
  return {s.real(), std::abs(s.imag()) / tau, size > 0 ? -s.real() / size : 0};
}

std::vector<LoopPole> sorted(const std::vector<Complex>& poles) {
  std::vector<LoopPole> found;
  for (const Complex s : poles)
    if (s.imag() >= 0) found.push_back(pole_of(s));
  std::sort(found.begin(), found.end(),
            [](const LoopPole& a, const LoopPole& b) { return a.growth > b.growth; });
  return found;
}

// ---- frequencies of the search for margins ------------------------------------------------------

/// Frequencies about a pole, spaced by its own width.
void refine_about(Complex pole, std::vector<double>& grid) {
  const double width = std::max(std::abs(pole.real()), narrowest_pole * std::abs(pole)) / tau;
  const double middle = std::abs(pole.imag()) / tau;
  for (double away = width / 16; away < middle; away *= 1.5) {
    grid.push_back(middle - away);
    grid.push_back(middle + away);
  }
}

/// From a hundredth of the slowest pole to a hundred times the fastest.
std::vector<double> grid_of(const OpenLoop& loop) {
  std::vector<Complex> poles = loop.closed_poles();
  for (const Complex p : loop.plant_poles()) poles.push_back(p);
  double fastest = 0;
  for (const Complex p : poles) fastest = std::max(fastest, std::abs(p));
  double slowest = fastest;
  for (const Complex p : poles)
    if (std::abs(p) > pole_at_zero * fastest) slowest = std::min(slowest, std::abs(p));
  const double first = slowest / tau / 100;
  const double last = std::min(100 * fastest / tau, loop.highest());
  const auto count = static_cast<int>(std::ceil(per_decade * std::log10(last / first)));
  std::vector<double> grid;
  for (int i = 0; i <= count; ++i)
    grid.push_back(first * std::pow(last / first, static_cast<double>(i) / count));
  for (const Complex p : poles) refine_about(p, grid);
  std::erase_if(grid, [&](double f) { return !(f >= first && f < last); });
  grid.push_back(last);
  std::sort(grid.begin(), grid.end());
  return grid;
}

std::vector<LoopPoint> response(const OpenLoop& loop) {
  std::vector<LoopPoint> points;
  for (const double f : grid_of(loop)) points.push_back({f, loop.at(f)});
  return points;
}

/// The frequency between two others where `of` changes its sign, to rounding.
LoopPoint crossing(const OpenLoop& loop, double a, double b,
                   const std::function<double(Complex)>& of) {
  const bool rising = of(loop.at(a)) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(a * b);
    ((of(loop.at(middle)) < 0) == rising ? a : b) = middle;
  }
  return {b, loop.at(b)};
}

std::vector<LoopPoint> crossings(const OpenLoop& loop, const std::vector<LoopPoint>& points,
                                 const std::function<double(Complex)>& of) {
  std::vector<LoopPoint> found;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const LoopPoint& a = points[i - 1];
    const LoopPoint& b = points[i];
    if ((of(a.value) < 0) != (of(b.value) < 0))
      found.push_back(crossing(loop, a.frequency, b.frequency, of));
  }
  return found;
}

// ---- margins ------------------------------------------------------------------------------------

/// The nearest of some margins.
void keep_nearest(std::optional<LoopMargin>& nearest, LoopMargin margin) {
  if (!nearest || std::abs(margin.value) < std::abs(nearest->value)) nearest = margin;
}

/// The points of the negative real axis that L passes. A pole on the imaginary axis turns the sign of L, too: there |L|
/// has no bound, and the imaginary part stays large.
std::vector<LoopPoint> negative_real(const OpenLoop& loop, const std::vector<LoopPoint>& points) {
  std::vector<LoopPoint> found = crossings(loop, points, [](Complex l) { return l.imag(); });
  if (std::isfinite(loop.highest())) found.push_back(points.back());  // z = -1: L is real
  std::erase_if(found, [](const LoopPoint& p) {
    return !(p.value.real() < 0 && std::abs(p.value.imag()) < real_crossing * std::abs(p.value));
  });
  return found;
}

/// The factor by which the gain is multiplied where a pole crosses.
double factor(const LoopPoint& p) {
  return -1 / p.value.real();
}

/// The velocity gain nearest to the drive's beyond which an unstable loop is stable.
std::optional<double> stable_gain(const OpenLoop& loop, const Drive& drive,
                                  std::vector<LoopPoint> crossed) {
  std::sort(crossed.begin(), crossed.end(), [](const LoopPoint& a, const LoopPoint& b) {
    return std::abs(std::log(factor(a))) < std::abs(std::log(factor(b)));
  });
  for (const LoopPoint& p : crossed) {
    const double k = factor(p);
    const double beyond = k < 1 ? 0.999 * k : 1.001 * k;
    if (is_stable(sorted(loop.closed_poles(beyond)))) return k * drive.controller.velocity_gain;
  }
  return std::nullopt;
}

std::string advice(const LoopStability& loop, const Drive& drive) {
  if (!loop.velocity_gain)
    return "no controller.velocity_gain makes it stable: lower controller.position_gain, raise "
           "controller.integral_time or shorten controller.delay";
  const double now = drive.controller.velocity_gain;
  const bool lower = *loop.velocity_gain < now;
  return std::string(lower ? "lower" : "raise") + " controller.velocity_gain from " + number(now) +
         (lower ? " to less than " : " to more than ") +
         fmt::format("{:.4g}", *loop.velocity_gain) + " N m s/rad";
}

}  // namespace

bool is_stable(const std::vector<LoopPole>& poles) {
  double fastest = 0;
  for (const LoopPole& p : poles)
    fastest = std::max(fastest, std::hypot(p.growth, tau * p.frequency));
  return poles.empty() || poles.front().growth <= rounded_growth * fastest;
}

std::vector<LoopPole> loop_poles(const Drive& drive) {
  require_loop(drive);
  return sorted(OpenLoop(drive).closed_poles());
}

std::vector<LoopPoint> loop_response(const Drive& drive) {
  require_loop(drive);
  return response(OpenLoop(drive));
}

LoopStability loop_stability(const Drive& drive) {
  require_loop(drive);
  const OpenLoop loop(drive);
  LoopStability found;
  found.poles = sorted(loop.closed_poles());
  found.stable = is_stable(found.poles);
  const std::vector<LoopPoint> points = response(loop);
  const std::vector<LoopPoint> crossed = negative_real(loop, points);
  for (const LoopPoint& p : crossed)
    keep_nearest(found.gain, {20 * std::log10(factor(p)), p.frequency});
  for (const LoopPoint& p : crossings(loop, points, [](Complex l) { return std::norm(l) - 1; }))
    keep_nearest(found.phase, {std::arg(-p.value) * 180 / std::numbers::pi, p.frequency});
  if (found.phase) found.phase->value = std::abs(found.phase->value);
  if (found.stable) return found;
  if (found.gain) found.gain->value = -std::abs(found.gain->value);
  if (found.phase) found.phase->value = -found.phase->value;
  found.velocity_gain = stable_gain(loop, drive, crossed);
  return found;
}

std::optional<Finding> unstable_loop(const Drive& drive) {
  if (too_late(drive.controller) || is_stable(loop_poles(drive))) return std::nullopt;
  const LoopStability loop = loop_stability(drive);
  Finding finding;
  finding.rule = "drive/stability";
  finding.quantity = "growth of the loop";
  finding.unit = "1/s";
  finding.where = loop.poles.front().frequency;
  finding.where_unit = "Hz";
  finding.value = loop.poles.front().growth;
  finding.margin = -1e6;  // before every broken limit, because these follow from it
  finding.broken = true;
  finding.has_limit = false;
  finding.advice = advice(loop, drive);
  return finding;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "proof/src/figure/loop_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/design/input.hpp"
#include "jounce/proof/drive_figures.hpp"
#include "jounce/validate/loop.hpp"

#include "proof/src/text/loop_text.hpp"

namespace jounce {
namespace {

constexpr double not_evaluated = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees = 180 / std::numbers::pi;

double decibels(std::complex<double> l) {
  return 20 * std::log10(std::abs(l));
}

/// The phase of each point in degrees, without steps of 360. The first is from -360 to 0.
std::vector<double> phases(const std::vector<LoopPoint>& points) {
  std::vector<double> found;
  for (const LoopPoint& p : points) {
    const double here = std::arg(p.value) * degrees;
    const double before = found.empty() ? -180 : found.back();
    found.push_back(here + 360 * std::round((before - here) / 360));
  }
  return found;
}

/// The range of frequencies around the margins; all frequencies if there are no margins.
std::pair<double, double> window(const LoopStability& loop, const std::vector<LoopPoint>& points) {
  double first = std::numeric_limits<double>::infinity();
  double last = 0;
  for (const auto& margin : {loop.gain, loop.phase}) {
    if (!margin) continue;
    first = std::min(first, margin->frequency);
    last = std::max(last, margin->frequency);
  }
  const double least = points.front().frequency, most = points.back().frequency;
  if (last == 0) return {least, most};
  return {std::max(least, first / 50), std::min(most, 20 * last)};
}

/// Adds a marker to the line of the panel, at its first point at or above the frequency of the margin.
void mark(Panel& panel, const LoopMargin& margin, const std::string& text, bool stable) {
  const double x = std::log10(margin.frequency);
  const Series& line = panel.series.back();
  const auto after = std::lower_bound(line.x.begin(), line.x.end(), x);
  const auto i = static_cast<std::size_t>(after - line.x.begin());
  if (i == line.x.size()) return;
  panel.markers.push_back({.x = x, .y = line.y[i], .text = text, .hint = text, .broken = !stable});
}

Series level(const std::pair<double, double>& shown, double y) {
  return {.label = "0 dB, −180 deg",
          .x = {std::log10(shown.first), std::log10(shown.second)},
          .y = {y, y},
          .style = Style::under};
}

std::string title_of(const LoopStability& loop) {
  return "loop " + stability_text(loop);
}

}  // namespace

Figure bode_figure(const Drive& drive) {
  const LoopStability loop = loop_stability(drive);
  const std::vector<LoopPoint> points = loop_response(drive);
  const std::vector<double> phase = phases(points);
  const auto shown = window(loop, points);
  Figure figure{.title = title_of(loop), .x_label = "frequency [Hz]", .decades = true};
  Panel magnitude{.y_label = "magnitude [dB]", .series = {level(shown, 0), {.label = "loop"}}};
  Panel angle{.y_label = "phase [deg]", .series = {level(shown, -180), {.label = "loop"}}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double f = points[i].frequency;
    if (f < shown.first || f > shown.second) continue;
    magnitude.series[1].x.push_back(std::log10(f));
    magnitude.series[1].y.push_back(decibels(points[i].value));
    angle.series[1].x.push_back(std::log10(f));
    angle.series[1].y.push_back(phase[i]);
  }
  if (loop.gain) mark(magnitude, *loop.gain, gain_text(loop), loop.stable);
  if (loop.phase) mark(angle, *loop.phase, phase_text(loop), loop.stable);
  figure.panels = {std::move(magnitude), std::move(angle)};
  return figure;
}

Figure nyquist_figure(const Drive& drive) {
  constexpr double left = -3, right = 1.5, high = 1.5;
  const LoopStability loop = loop_stability(drive);
  Figure figure{.title = title_of(loop), .x_label = "real part"};
  Panel panel{.y_label = "imaginary part"};
  panel.series.push_back({.label = "axes",
                          .x = {left, right, not_evaluated, 0, 0},
                          .y = {0, 0, not_evaluated, -high, high},
                          .style = Style::under});
  Series curve{.label = "loop"};
  for (const LoopPoint& p : loop_response(drive)) {
    const bool inside =
        p.value.real() >= left && p.value.real() <= right && std::abs(p.value.imag()) <= high;
    curve.x.push_back(inside ? p.value.real() : not_evaluated);
    curve.y.push_back(inside ? p.value.imag() : not_evaluated);
  }
  Series circle{.label = "unit circle"};
  for (int i = 0; i <= 360; ++i) {
    circle.x.push_back(std::cos(i / degrees));
    circle.y.push_back(std::sin(i / degrees));
  }
  panel.series.push_back(std::move(curve));
  panel.series.push_back(std::move(circle));
  panel.markers.push_back(
      {.x = -1, .y = 0, .text = "−1", .hint = loop_text(loop), .broken = !loop.stable});
  figure.panels = {std::move(panel)};
  return figure;
}

namespace {

/// The drive of a spec or of its axis, without the curve: a spec of kind "drive" has none.
struct NamedDrive {
  std::string name;
  Drive drive;
};
NamedDrive drive_in(const FigureRequest& request) {
  const std::string text = read_file(request.file);
  const std::string name = request.file == "-" ? "standard input" : request.file;
  const InputError missing(
      "drive", "",
      "is missing: this picture needs a spec with [drive]; `jounce new drive` writes an example");
  if (is_finished_table(text)) throw InputError(missing).at(name);
  const Spec spec = parse_spec(text, name);
  require_no_input(spec.document.all_files(), request.output);
  const std::vector<AxisPart> parts = spec.parts();
  if (parts.size() > 1 && request.axis.empty())
    throw InputError("axis", request.drive, "shows one axis: name it with --axis");
  for (const AxisPart& part : parts)
    if (part.drive && (request.axis.empty() || part.name == request.axis)) {
      const std::string whole = spec.name.empty() ? name : spec.name;
      return {parts.size() > 1 ? whole + " " + part.name : whole, part.drive->drive};
    }
  throw spec.document.located(missing);
}

}  // namespace

Figure loop_figure(const FigureRequest& request) {
  const NamedDrive of = drive_in(request);
  Figure figure = request.drive == "bode" ? bode_figure(of.drive) : nyquist_figure(of.drive);
  figure.title = of.name + ": " + figure.title;
  return figure;
}

SvgOptions drive_look(const std::string& which) {
  SvgOptions look;
  if (which == "torque-speed" || which == "spectrum") look.panel_height = 320;
  if (which == "bode") look.panel_height = 220;
  if (which == "nyquist") look.panel_height = nyquist_height;
  return look;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/drive_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "jounce/design/detail/driven.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/profiles/vibration/vibration.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce {
namespace {

constexpr double rpm = 30 / std::numbers::pi;  // per rad/s

Series outline(const char* label, const std::vector<std::pair<double, double>>& corners) {
  Series series{.label = label};
  for (const auto& [x, y] : corners) series.x.push_back(x), series.y.push_back(y);
  return series;
}

/// The greatest torque at each speed, in both directions: the corners of the envelope, once around.
Series envelope(const Motor& m, double speed) {
  const double t = m.torque_limit;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  if (m.max_velocity == 0)
    return outline("peak torque", {{-speed, t}, {speed, t}, {gap, gap}, {speed, -t}, {-speed, -t}});
  const double rated = m.rated_velocity * rpm;
  const double most = m.max_velocity * rpm;
  return outline(
      "peak torque",
      {{-most, t}, {rated, t}, {most, 0}, {most, -t}, {-rated, -t}, {-most, 0}, {-most, t}});
}

Marker marked(double x, double y, const std::string& text) {
  return {.x = x, .y = y, .text = text, .hint = text};
}

/// The modes that oscillate and decay, of a linear drive with its controller taken as continuous; none for another
/// drive.
std::vector<DriveMode> swinging(const Drive& drive) {
  Drive continuous = drive;
  continuous.controller.cycle = 0;
  if (nonlinearity(continuous)) return {};
  std::vector<DriveMode> found = modes(continuous);
  std::erase_if(found, [](const DriveMode& m) {
    return m.frequency == 0 || m.damping > 0.7 ||
           m.damping < 0;  // an unstable mode has no residual
  });
  return found;
}

/// The residual in dB of the travel, at least -160 dB: rounding lies below.
double decibels(double left, double way) {
  constexpr double floor = 1e-8;
  return 20 * std::log10(std::max(way > 0 ? left / way : 0, floor));
}

}  // namespace

Figure response_figure(const DriveResult& run, const DriveSpec& drive, const std::string& unit) {
  Figure figure{.title = "Through the servo model", .x_label = "time [s]"};
  Panel torque{.y_label = "torque [N m]"};
  Panel error{.y_label = "following error [" + unit + "]"};
  Series t{.label = "torque"};
  Series e{.label = "following error"};
  for (const DriveSample& sample : run.samples) {
    t.x.push_back(sample.time), t.y.push_back(sample.torque);
    e.x.push_back(sample.time), e.y.push_back(sample.following_error);
  }
  torque.series.push_back(std::move(t));
  error.series.push_back(std::move(e));
  const auto limit = [](Panel& panel, const std::optional<double>& most) {
    if (!most) return;
    panel.lower = -*most;
    panel.upper = *most;
  };
  limit(torque, drive.limits.torque ? *drive.limits.torque : drive.drive.motor.torque_limit);
  limit(error, drive.limits.following_error);
  torque.markers.push_back(
      marked(run.torque.where, run.torque.value, short_number(run.torque.value, 3)));
  error.markers.push_back(marked(run.following_error.where, run.following_error.value,
                                 short_number(run.following_error.value, 3)));
  figure.panels = {std::move(torque), std::move(error)};
  return figure;
}

Figure torque_speed_figure(const DriveResult& run, const Drive& drive) {
  const Motor& m = drive.motor;
  Figure figure{.title = "Torque over speed", .x_label = "motor speed [1/min]"};
  Panel panel{.y_label = "torque [N m]"};
  Series path{.label = "this motion"};
  double speeds = 0;
  double fastest = 0;
  for (const DriveSample& s : run.samples) {
    path.x.push_back(s.velocity * rpm), path.y.push_back(s.torque);
    speeds += std::abs(s.velocity) * rpm / static_cast<double>(run.samples.size());
    fastest = std::max(fastest, std::abs(s.velocity) * rpm);
  }
  panel.series.push_back(std::move(path));
  panel.series.push_back(envelope(m, 1.1 * fastest));
  if (m.rated_torque > 0) {
    const double most = m.rated_velocity > 0 ? m.rated_velocity * rpm : 1.1 * fastest;
    const double t = m.rated_torque;
    panel.series.push_back(
        outline("continuous torque", {{-most, t}, {most, t}, {most, -t}, {-most, -t}, {-most, t}}));
  }
  panel.series.push_back({.label = "rms torque at the mean speed",
                          .x = {speeds},
                          .y = {run.rms_torque},
                          .style = Style::dots});
  panel.markers.push_back(marked(speeds, run.rms_torque, "rms " + short_number(run.rms_torque, 3)));
  panel.markers.back().text_only = true;
  figure.panels = {std::move(panel)};
  return figure;
}

Figure spectrum_figure(const Trajectory& motion, const Drive& drive, const std::string& unit) {
  constexpr int points = 800;
  const std::vector<DriveMode> own = swinging(drive);
  const Range travel = extrema(motion, 0);
  const double way = travel.max.value - travel.min.value;
  double highest = 12 / motion.length();
  for (const DriveMode& m : own) highest = std::max(highest, 1.3 * m.frequency);
  Figure figure{.title = "Residual vibration of the motion",
                .x_label = "natural frequency of a mode [Hz]",
                .x_note = "response to the motion alone; `jounce validate` simulates the drive"};
  Panel panel{.y_label = "residual amplitude [dB of the travel]"};
  for (const double damping : {0.0, 0.05}) {
    Series series{.label = damping == 0 ? "undamped" : fmt::format("damping ratio {}", damping)};
    for (int i = 1; i <= points; ++i) {
      const double frequency = highest * i / points;
      series.x.push_back(frequency);
      series.y.push_back(decibels(residual_vibration(motion, Mode{frequency, damping}), way));
    }
    panel.series.push_back(std::move(series));
  }
  for (const DriveMode& m : own) {
    const double natural = m.frequency / std::sqrt(1 - m.damping * m.damping);
    const double left = residual_vibration(motion, Mode{natural, m.damping});
    panel.markers.push_back(marked(
        natural, decibels(left, way),
        fmt::format("drive, {} Hz: {} {}", short_number(natural, 3), short_number(left, 3), unit)));
  }
  figure.panels = {std::move(panel)};
  return figure;
}

Figure drive_figure(const Input& input, const std::string& which) {
  if (!input.drive)
    throw InputError(
        "drive", "",
        "is missing: this picture needs a spec with [drive]; `jounce new drive` writes an example")
        .at(input.files.empty() ? input.name : input.files.front());
  const std::string& unit = input.labels.units.position;
  const Reference reference = table_reference(input);
  Figure figure;
  if (which == "spectrum") {
    const auto motion = view(reference).trajectory();
    if (!motion)
      throw InputError("master", "",
                       "accelerates: the spectrum needs a master at constant velocity")
          .at(input.name);
    figure = spectrum_figure(*motion, input.drive->drive, unit);
  } else {
    const DriveResult run = driven(input, 2001);
    figure = which == "response" ? response_figure(run, *input.drive, unit)
                                 : torque_speed_figure(run, input.drive->drive);
    if (which == "response" && !input.drive->periodic && input.drive->settle > 0)
      figure.shades = {{duration(reference), run.samples.back().time, "standstill"}};
  }
  figure.title = input.name + ": " + figure.title;
  return figure;
}

}  // namespace jounce

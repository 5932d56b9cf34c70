// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/load_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/design/make.hpp"
#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/spec/shape_spec.hpp"

#include "design/src/check/load_check.hpp"

namespace jounce {
namespace {

/// A linear quantity of a segment, as a segment: the set is closed under all that it takes.
Segment load_quantity(const LinearQuantity& quantity, Segment f) {
  Segment total = scaled(f, quantity.by[0], quantity.constant);
  for (std::size_t k = 1; k < quantity.by.size(); ++k) {
    f = derivative(f);
    if (quantity.by[k] != 0) total = *sum(total, scaled(f, quantity.by[k]));
  }
  return total;
}

Cam load_quantity(const LinearQuantity& quantity, const Cam& cam) {
  std::vector<Segment> segments;
  for (const Segment& f : cam.segments()) segments.push_back(load_quantity(quantity, f));
  return Cam(std::move(segments), cam.start(), Extrapolation::refuse);
}

std::optional<Cam> product_of(const Cam& torque, const Cam& speed) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < torque.segments().size(); ++i) {
    auto power = optimize_detail::product(torque.segments()[i], speed.segments()[i]);
    if (!power) return std::nullopt;
    segments.push_back(std::move(*power));
  }
  return Cam(std::move(segments), torque.start(), Extrapolation::refuse);
}

/// The greatest |T w| of one segment, by branch and bound: on a piece of length l,
///
///     (1)  |T w| <= greater |T w| at its ends + max |(T w)''| l^2 / 8
///     (2)  |(T w)''| <= |T''| |w| + 2 |T'| |w'| + |T| |w''|
class PowerPeak {
 public:
  PowerPeak(const Segment& torque, const Segment& speed) : torque_(torque), speed_(speed) {
    std::array<double, 3> T{};
    std::array<double, 3> w{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int order = static_cast<int>(k);
      T[k] = std::abs(segment_range(torque, 0, torque.length, order).peak().value);
      w[k] = std::abs(segment_range(speed, 0, speed.length, order).peak().value);
    }
    curvature_ = T[2] * w[0] + 2 * T[1] * w[1] + T[0] * w[2];  // (2)
  }

  /// Raises `peak` to the peak of this segment, within a share of 1e-9.
  void raise(LoadPeak& peak, double start) const { search(peak, start, 0, 1, 0); }

 private:
  /// s from 0 to 1.
  [[nodiscard]] double at(double s) const { return value(torque_, s) * value(speed_, s); }
  void search(LoadPeak& peak, double start, double from, double to, int depth) const {
    for (const double s : {from, to})
      if (std::abs(at(s)) > std::abs(peak.value)) peak = {at(s), start + s * torque_.length, 0};
    constexpr double precision = 1e-9;
    constexpr int deepest = 40;
    const double ends = std::max(std::abs(at(from)), std::abs(at(to)));
    const double l = (to - from) * torque_.length;
    const double most = ends + curvature_ * l * l / 8;  // (1)
    if (most <= std::abs(peak.value) * (1 + precision) || depth == deepest) return;
    const double middle = from + (to - from) / 2;
    search(peak, start, from, middle, depth + 1);
    search(peak, start, middle, to, depth + 1);
  }

  const Segment& torque_;
  const Segment& speed_;
  double curvature_ = 0;
};

LoadPeak power_peak(const Cam& torque, const Cam& speed) {
  LoadPeak peak;
  double start = torque.start();
  for (std::size_t i = 0; i < torque.segments().size(); ++i) {
    PowerPeak(torque.segments()[i], speed.segments()[i]).raise(peak, start);
    start += torque.segments()[i].length;
  }
  return peak;
}

/// The velocity of the master in its unit per second; nullopt without [load] or [master].
std::optional<double> speed_of_load(const Spec& spec) {
  if (!spec.optimize.shape.load || !spec.master) return std::nullopt;
  return spec.master->velocity / seconds_per_unit(spec);
}

}  // namespace

std::vector<LoadFigure> load_figures(const Spec& spec, const Cam& cam) {
  const auto speed = speed_of_load(spec);
  if (!speed) return {};
  const LoadSpec& load = *spec.optimize.shape.load;
  const LoadTorque torque = load_torque_of(load, *speed, spec.units.position);
  std::vector<LoadFigure> all;
  const auto peak = [&](const char* name, const char* unit, const LoadPeak& most) {
    all.push_back({name, std::abs(most.value), unit, most.where});
  };
  peak("peak torque", "N m", load_peak(TorqueOf{torque}, cam, 0));
  const double rms = load_rms(RmsTorqueOf{torque}, cam);
  all.push_back({"rms torque", rms, "N m"});
  if (is_linear(load))
    peak("peak power", "W",
         power_peak(load_quantity(torque_of(load, *speed, spec.units.position), cam),
                    load_quantity(motor_speed_of(load, *speed), cam)));
  if (load.winding_loss) all.push_back({"motor heating", *load.winding_loss * rms * rms, "W"});
  return all;
}

std::optional<LoadCurves> load_curves(const Spec& spec, const Cam& cam) {
  const auto speed = speed_of_load(spec);
  if (!speed) return std::nullopt;
  const LoadSpec& load = *spec.optimize.shape.load;
  LoadCurves curves{load_quantity(torque_of(load, *speed, spec.units.position), cam)};
  if (is_linear(load))
    curves.power = product_of(curves.torque, load_quantity(motor_speed_of(load, *speed), cam));
  return curves;
}

}  // namespace jounce

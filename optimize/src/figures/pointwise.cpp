// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/detail/pointwise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/program/spline_space.hpp"

// The quantities of a load are q = (linear, f', f'', f). Equation (1) of shape.hpp is then
//
//   (1)  T = q_0 + J q_2 + J' q_1 + C sign(q_1) + G sin(angle + turn q_3)
//
// A shape is divided where f' vanishes and where J has a break. On each interval the sign is
// constant, and T is a polynomial plus the sine term. The product of two quantities that are linear
// in the shape (a power) is a polynomial throughout.

namespace jounce::optimize_detail {
namespace {

using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;

constexpr double same_cut = 1e-9;  ///< in s, from 0 to 1 over a segment

LinearQuantity with_order(int order) {
  return derivative_of_shape(order);
}

/// A place in the inertia: the number of a segment, and the distance from its beginning.
struct InertiaAt {
  double value = 0;
  double slope = 0;
};

InertiaAt inertia_at(const std::vector<Segment>& inertia, double begin, double x) {
  if (inertia.empty()) return {};
  double from = begin;
  for (const Segment& f : inertia) {
    if (x < from + f.length || &f == &inertia.back()) {
      const Jet jet = evaluate(f, std::clamp((x - from) / f.length, 0.0, 1.0));
      return {jet[0], jet[1]};
    }
    from += f.length;
  }
  return {};
}

/// The breaks of the inertia strictly inside (a, b), preceded by a and followed by b.
std::vector<double> cuts_between(const std::vector<Segment>& inertia, double begin, double a,
                                 double b) {
  std::vector<double> cuts{a};
  double x = begin;
  for (const Segment& f : inertia) {
    x += f.length;
    if (x > a + rounded_sum * (b - a) && x < b - rounded_sum * (b - a)) cuts.push_back(x);
  }
  cuts.push_back(b);
  return cuts;
}

/// The places where f' vanishes inside a segment, with 0 before them and 1 after them.
std::vector<double> turns(const Segment& f) {
  const Segment velocity = derivative(f);
  std::vector<double> inside;
  roots(velocity, rounded_value * magnitude(velocity), inside);
  std::vector<double> places{0};
  for (const double s : inside)
    if (s - places.back() > same_cut && s < 1 - same_cut) places.push_back(s);
  places.push_back(1);
  return places;
}

Segment inertia_part(const std::vector<Segment>& inertia, double begin, double a, double b) {
  double from = begin;
  for (const Segment& f : inertia) {
    const double to = from + f.length;
    if ((a + b) / 2 < to || &f == &inertia.back()) {
      const double s0 = std::clamp((a - from) / f.length, 0.0, 1.0);
      const double s1 = std::clamp((b - from) / f.length, 0.0, 1.0);
      Segment g = part(f, s0, s1);
      g.length = b - a;
      return g;
    }
    from = to;
  }
  return {};
}

Segment added(const Segment& f, const Segment& g) {
  return sum(f, g).value();
}

/// (1) on an interval without breaks or reversals.
Wave torque_wave(const LoadTorque& load, const Segment& f, double begin, double a, double b) {
  Wave wave;
  wave.from = a;
  wave.to = b;
  const Segment velocity = derivative(f);
  wave.sign = value(velocity, 0.5) < 0 ? -1 : 1;
  Segment p = quantity_of(load.linear, f);
  if (!load.inertia.empty()) {
    Segment inertia = inertia_part(load.inertia, begin, a, b);
    inertia.length = f.length;
    p = added(p, product(inertia, derivative(velocity)).value());
    p = added(p, product(derivative(inertia), velocity).value());
  }
  p.c[0] += load.coulomb * wave.sign;
  wave.polynomial = p;
  wave.gravity = load.gravity;
  wave.angle = scaled(f, load.turn, load.angle);
  return wave;
}

std::vector<Wave> torque_waves(const LoadTorque& load, const std::vector<Segment>& shape,
                               double begin) {
  std::vector<Wave> waves;
  double x = begin;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Segment& f = shape[i];
    const double end = x + f.length;
    const std::vector<double> cuts = cuts_between(load.inertia, begin, x, end);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double s0 = (cuts[k] - x) / f.length;
      const double s1 = k + 2 == cuts.size() ? 1 : (cuts[k + 1] - x) / f.length;
      const Segment interval = s0 == 0 && s1 == 1 ? f : part(f, s0, s1);
      const std::vector<double> places =
          load.coulomb == 0 ? std::vector<double>{0, 1} : turns(interval);
      for (std::size_t n = 0; n + 1 < places.size(); ++n) {
        const bool whole = places.size() == 2;
        const double a = cuts[k] + places[n] * interval.length;
        const double b = cuts[k] + places[n + 1] * interval.length;
        waves.push_back(torque_wave(
            load, whole ? interval : part(interval, places[n], places[n + 1]), begin, a, b));
        waves.back().piece = i;
      }
    }
    x = end;
  }
  return waves;
}

std::vector<Wave> power_waves(const PowerOf& power, const std::vector<Segment>& shape,
                              double begin) {
  std::vector<Wave> waves;
  double x = begin;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    Wave wave{.piece = i, .from = x, .to = x + shape[i].length};
    wave.polynomial =
        product(quantity_of(power.force, shape[i]), quantity_of(power.velocity, shape[i])).value();
    wave.angle.length = shape[i].length;
    waves.push_back(wave);
    x = wave.to;
  }
  return waves;
}

/// (1) with its derivatives by q.
double torque(const LoadTorque& load, double begin, double x, double sign,
              std::span<const double> q, std::span<double> slope) {
  const InertiaAt j = inertia_at(load.inertia, begin, x);
  const double angle = load.angle + load.turn * q[3];
  slope[0] = 1;
  slope[1] = j.slope;
  slope[2] = j.value;
  slope[3] = load.gravity * load.turn * std::cos(angle);
  return q[0] + j.value * q[2] + j.slope * q[1] + load.coulomb * sign +
         load.gravity * std::sin(angle);
}

Pointwise of_load(const LoadTorque& load, double begin, Pointwise::Over over) {
  Pointwise p{.over = over, .of = {load.linear, with_order(1), with_order(2), with_order(0)}};
  if (load.coulomb != 0) p.signed_by = 1;
  p.g = [load, begin](double x, double sign, std::span<const double> q, std::span<double> slope) {
    return torque(load, begin, x, sign, q, slope);
  };
  p.waves = [load](const std::vector<Segment>& shape, double from) {
    return torque_waves(load, shape, from);
  };
  return p;
}

Pointwise of_energy(const EnergyOf& energy, double begin) {
  Pointwise p = of_load(energy.load, begin, Pointwise::Over::integral);
  p.g = [load = energy.load, recovered = energy.recovered, begin](
            double x, double sign, std::span<const double> q, std::span<double> slope) {
    const double t = torque(load, begin, x, sign, q, slope);
    const double share = t * q[1] > 0 ? 1 : recovered;
    for (double& d : slope) d *= share * q[1];
    slope[1] += share * t;
    return share * t * q[1];
  };
  return p;
}

}  // namespace

std::optional<Segment> product(const Segment& f, const Segment& g) {
  if (f.sines > 0 || g.sines > 0 || f.degree + g.degree > Segment::max_degree) return std::nullopt;
  Segment h;
  h.length = f.length;
  h.degree = f.degree + g.degree;
  for (int i = 0; i <= f.degree; ++i)
    for (int j = 0; j <= g.degree; ++j)
      h.c[static_cast<std::size_t>(i + j)] +=
          f.c[static_cast<std::size_t>(i)] * g.c[static_cast<std::size_t>(j)];
  return h;
}

std::optional<Pointwise> pointwise(const ShapeFigure& figure, double begin) {
  if (const auto* f = std::get_if<PowerOf>(&figure)) {
    Pointwise p{.of = {f->force, f->velocity}};
    p.g = [](double, double, std::span<const double> q, std::span<double> slope) {
      slope[0] = q[1];
      slope[1] = q[0];
      return q[0] * q[1];
    };
    p.waves = [power = *f](const auto& shape, double from) {
      return power_waves(power, shape, from);
    };
    return p;
  }
  if (const auto* f = std::get_if<TorqueOf>(&figure))
    return of_load(f->load, begin, Pointwise::Over::peak);
  if (const auto* f = std::get_if<RmsTorqueOf>(&figure))
    return of_load(f->load, begin, Pointwise::Over::rms);
  if (const auto* f = std::get_if<EnergyOf>(&figure)) return of_energy(*f, begin);
  return std::nullopt;
}

}  // namespace jounce::optimize_detail

#include "jounce/optimize/detail/pointwise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "jounce/optimize/detail/quadrature.hpp"
#include "jounce/optimize/detail/spline_space.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/roots.hpp"

// With the quantities q = (linear, f', f'', f) of a load, shape.hpp (1) is
//
//   (1)  T = q_0 + J q_2 + J' q_1 + C sign(q_1) + G sin(angle + turn q_3)
//
// A shape is cut where f' vanishes and where J has a break; on each stretch the sign is one, T is a
// polynomial but for the sine, and the power of two linear quantities is a polynomial throughout.
//
// The peak of a wave with a sine: between a and b it is off the straight line between its end values by at
// most
//
//   (2)  (b - a)^2 / 8 (max |P''| + |G| (max |angle'|^2 + max |angle''|))
//
// so halves are dropped as soon as the higher of their ends and (2) are below the best known.

namespace jounce::optimizer {
namespace {

LinearQuantity with_order(int order) {
  return derivative_of_shape(order);
}

/// Where on the axis of x the inertia is: its segment, and how far in.
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

/// The breaks of the inertia strictly inside (a, b), with a before and b behind.
std::vector<double> cuts_between(const std::vector<Segment>& inertia, double begin, double a,
                                 double b) {
  std::vector<double> cuts{a};
  double x = begin;
  for (const Segment& f : inertia) {
    x += f.length;
    if (x > a + 1e-12 * (b - a) && x < b - 1e-12 * (b - a)) cuts.push_back(x);
  }
  cuts.push_back(b);
  return cuts;
}

/// Where f' vanishes inside a segment, 0 and 1 around.
std::vector<double> turns(const Segment& f) {
  const Segment velocity = derivative(f);
  std::vector<double> inside;
  roots(velocity, 1e-14 * magnitude(velocity), inside);
  std::vector<double> places{0};
  for (const double s : inside)
    if (s - places.back() > 1e-9 && s < 1 - 1e-9) places.push_back(s);
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

/// (1) on a stretch without breaks or turns.
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
      const Segment stretch = s0 == 0 && s1 == 1 ? f : part(f, s0, s1);
      const std::vector<double> places =
          load.coulomb == 0 ? std::vector<double>{0, 1} : turns(stretch);
      for (std::size_t n = 0; n + 1 < places.size(); ++n) {
        const bool whole = places.size() == 2;
        const double a = cuts[k] + places[n] * stretch.length;
        const double b = cuts[k] + places[n + 1] * stretch.length;
        waves.push_back(torque_wave(load, whole ? stretch : part(stretch, places[n], places[n + 1]),
                                    begin, a, b));
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

/// Halves until (2) leaves no room for more than the tolerance above the best.
struct Climb {
  const Wave& wave;
  double sign;
  double tolerance;
  double bend;  ///< the factor of (b - a)^2 in (2), s in [0, 1]
  Extremum best{};

  void run(double a, double at_a, double b, double at_b, int depth) {
    const double highest = std::max(at_a, at_b) + bend * (b - a) * (b - a);
    if (highest <= sign * best.value + tolerance || depth == 0) return;
    const double middle = (a + b) / 2;
    const double at_middle = consider(middle);
    run(a, at_a, middle, at_middle, depth - 1);
    run(middle, at_middle, b, at_b, depth - 1);
  }
  double consider(double s) {
    const double value = sign * wave.at(s);
    if (value > sign * best.value)
      best = {sign * value, wave.from + s * (wave.to - wave.from), Side::right};
    return value;
  }
};

double peak_of_derivative(const Segment& f, int order) {
  return std::abs(segment_range(f, 0, f.length, order).peak().value);
}

}  // namespace

double Wave::at(double s) const {
  const double p = value(polynomial, s);
  return gravity == 0 ? p : p + gravity * std::sin(value(angle, s));
}

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

namespace {

void require_number(const std::string& key, double value, bool holds, const char* rule) {
  if (!std::isfinite(value) || !holds) throw InputError(key, value, rule);
}

void require_inertia(const std::string& key, const LoadTorque& load, const ShapeProblem& p) {
  if (load.inertia.empty()) return;
  const Trajectory inertia(load.inertia, p.begin);  // throws for a bad segment
  require_number(key, inertia.end(), std::abs(inertia.end() - p.end) <= 1e-9 * (p.end - p.begin),
                 "must end where the shape does");
  double before = value(load.inertia.front(), 0);
  for (const Segment& f : load.inertia) {
    const double step = std::abs(value(f, 0) - before);
    require_number(key, value(f, 0), step <= 1e-9 * magnitude(f),
                   "must not step: the torque would be infinite there");
    require_number(key, f.degree, f.sines == 0 && f.degree <= 4, "must be of degree 4 at most");
    before = value(f, 1);
  }
}

void require_load(const std::string& key, const LoadTorque& load, const ShapeProblem& p) {
  for (const double by : load.linear.by)
    require_number(key + ".linear.by", by, true, "must be finite");
  require_number(key + ".linear.constant", load.linear.constant, true, "must be finite");
  if (order_of(load.linear) > p.degree)
    throw InputError(
        key + ".linear", load.linear.name,
        "needs a higher derivative than a shape of degree " + std::to_string(p.degree) + " has");
  require_number(key + ".coulomb", load.coulomb, load.coulomb >= 0, "must be finite and >= 0");
  require_number(key + ".gravity", load.gravity, true, "must be finite");
  require_number(key + ".turn", load.turn, true, "must be finite");
  require_number(key + ".angle", load.angle, true, "must be finite");
  require_inertia(key + ".inertia", load, p);
  const bool anything = order_of(load.linear) >= 0 || load.linear.constant != 0 ||
                        !load.inertia.empty() || load.coulomb != 0 || load.gravity != 0;
  if (!anything) throw InputError(key, 0.0, "must not be zero throughout");
}

/// The degree of a linear quantity of a shape.
int degree_of(const LinearQuantity& q, int degree) {
  for (std::size_t k = 0; k < q.by.size(); ++k)
    if (q.by[k] != 0) return degree - static_cast<int>(k);
  return 0;
}

}  // namespace

void require_pointwise(const std::string& key, const ShapeFigure& figure, const ShapeProblem& p) {
  if (const auto* f = std::get_if<PowerOf>(&figure))
    if (degree_of(f->force, p.degree) + degree_of(f->velocity, p.degree) > Segment::max_degree)
      throw InputError(key, name(figure),
                       "needs a shape of a lower degree: its product with " +
                           std::to_string(p.degree) + " is above degree 11");
  if (const auto* f = std::get_if<TorqueOf>(&figure)) require_load(key + ".load", f->load, p);
  if (const auto* f = std::get_if<RmsTorqueOf>(&figure)) require_load(key + ".load", f->load, p);
  if (const auto* f = std::get_if<EnergyOf>(&figure)) {
    require_load(key + ".load", f->load, p);
    require_number(key + ".recovered", f->recovered, f->recovered >= 0 && f->recovered <= 1,
                   "must be in [0, 1]");
  }
}

Range range_of(const Wave& wave, double tolerance) {
  if (wave.gravity == 0) return segment_range(wave.polynomial, wave.from, wave.to, 0);
  const double length = wave.angle.length;
  const double turning = peak_of_derivative(wave.angle, 1);
  const double bend =
      length * length / 8 *
      (peak_of_derivative(wave.polynomial, 2) +
       std::abs(wave.gravity) * (turning * turning + peak_of_derivative(wave.angle, 2)));
  Range range;
  for (const double sign : {1.0, -1.0}) {
    Climb climb{wave, sign, tolerance, bend, {wave.at(0), wave.from, Side::right}};
    const double first = sign * wave.at(0);
    climb.run(0, first, 1, climb.consider(1), 40);
    (sign > 0 ? range.max : range.min) = climb.best;
  }
  return range;
}

namespace {

/// The integral of g, or of its square, over the shape: by the quantities, between the waves' ends.
double integrated(const Pointwise& figure, const std::vector<Segment>& shape, double begin) {
  std::vector<double> starts{begin};
  for (const Segment& f : shape) starts.push_back(starts.back() + f.length);
  std::vector<double> q(figure.of.size());
  std::vector<double> slope(q.size());
  double total = 0;
  for (const Wave& wave : figure.waves(shape, begin)) {
    const Segment& f = shape[wave.piece];
    std::vector<Segment> parts;
    for (const LinearQuantity& each : figure.of) parts.push_back(quantity_of(each, f));
    const auto g = [&](double r) {
      const double x = wave.from + r * (wave.to - wave.from);
      const double s = std::clamp((x - starts[wave.piece]) / f.length, 0.0, 1.0);
      for (std::size_t k = 0; k < q.size(); ++k) q[k] = value(parts[k], s);
      const double at = figure.g(x, wave.sign, q, slope);
      return figure.over == Pointwise::Over::rms ? at * at : at;
    };
    total += (wave.to - wave.from) * integral(g);
  }
  return total;
}

}  // namespace

std::vector<Extremum> places_of(const Pointwise& figure, const std::vector<Segment>& shape,
                                double begin, double level) {
  std::vector<Extremum> places;
  if (figure.over != Pointwise::Over::peak) return places;
  std::array<std::size_t, 2> last{shape.size() + 1, shape.size() + 1};
  for (const Wave& wave : figure.waves(shape, begin)) {
    const Range range = range_of(wave, 1e-9 * level);
    for (const double sign : {1.0, -1.0}) {
      const Extremum& e = sign > 0 ? range.max : range.min;
      if (sign * e.value < level) continue;
      std::size_t& before = last[sign > 0 ? 0 : 1];
      if (before != wave.piece && before + 1 != wave.piece) places.push_back(e);
      before = wave.piece;
    }
  }
  return places;
}

double value_of(const Pointwise& figure, const std::vector<Segment>& shape, double begin) {
  if (figure.over != Pointwise::Over::peak) {
    double length = 0;
    for (const Segment& f : shape) length += f.length;
    const double total = integrated(figure, shape, begin);
    return figure.over == Pointwise::Over::rms ? std::sqrt(total / length) : total;
  }
  double peak = 0;
  const std::vector<Wave> waves = figure.waves(shape, begin);
  for (const Wave& wave : waves) {
    const double ends = std::max(std::abs(wave.at(0)), std::abs(wave.at(1)));
    if (!std::isfinite(ends)) return std::nan("");  // std::max would lose it
    peak = std::max(peak, ends);
  }
  for (const Wave& wave : waves)
    peak = std::max(peak, std::abs(range_of(wave, 1e-8 * peak).peak().value));
  return peak;
}

}  // namespace jounce::optimizer

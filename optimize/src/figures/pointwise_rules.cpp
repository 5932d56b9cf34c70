// SPDX-License-Identifier: Apache-2.0
// The rules for a load.

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimize_detail {
namespace {

using profiles_detail::rounded_input;

void require_number(const std::string& key, double value, bool holds, const char* rule) {
  if (!std::isfinite(value) || !holds) throw InputError(key, value, rule);
}

void require_inertia(const std::string& key, const LoadTorque& load, const ShapeProblem& p) {
  if (load.inertia.empty()) return;
  const Trajectory inertia(load.inertia, p.begin);  // throws for a bad segment
  require_number(key, inertia.end(),
                 std::abs(inertia.end() - p.end) <= rounded_input * (p.end - p.begin),
                 "must end at the end of the shape");
  double before = value(load.inertia.front(), 0);
  for (const Segment& f : load.inertia) {
    const double step = std::abs(value(f, 0) - before);
    require_number(key, value(f, 0), step <= rounded_input * magnitude(f),
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

}  // namespace jounce::optimize_detail

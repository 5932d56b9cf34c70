// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/optimum_figure.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/plot/input_figure.hpp"

#include "plot/src/figure/curve_figure.hpp"

namespace jounce {
namespace {

/// A linear quantity of a segment, as a segment: the set is closed under all that it takes.
Segment quantity_of(const LinearQuantity& quantity, Segment f) {
  Segment total = scaled(f, quantity.by[0], quantity.constant);
  for (std::size_t k = 1; k < quantity.by.size(); ++k) {
    f = derivative(f);
    if (quantity.by[k] != 0) total = *sum(total, scaled(f, quantity.by[k]));
  }
  return total;
}

Cam quantity_of(const LinearQuantity& quantity, const Cam& cam) {
  std::vector<Segment> segments;
  for (const Segment& f : cam.segments()) segments.push_back(quantity_of(quantity, f));
  return Cam(std::move(segments), cam.start(), Extrapolation::refuse);
}

std::optional<LinearQuantity> torque_of(const Spec& spec) {
  const auto& load = spec.optimize.shape.load;
  if (!load || !spec.master) return std::nullopt;
  return torque_of(*load, spec.master->velocity / seconds_per_unit(spec), spec.units.position);
}

Input only_input_of(const Spec& spec, const std::string& name) {
  Input input = std::move(inputs_of(spec, spec.document.name).front());
  input.name = name;
  return input;
}

}  // namespace

Figure optimum_figure(const Spec& given_spec, const Spec& optimized) {
  const Input given = only_input_of(given_spec, "given");
  const Input better = only_input_of(optimized, "optimized");
  Figure figure = figure_of(better, given);
  figure.title =
      (optimized.name.empty() ? optimized.document.name : optimized.name) + ": optimized";
  const auto torque = torque_of(optimized);
  if (!torque) return figure;
  CurveLook look{
      .axis_unit = optimized.units.x, .unit = "N m", .label = better.name, .before = given.name};
  Figure of_torque = curve_figure(quantity_of(*torque, std::get<Cam>(*better.curve)),
                                  quantity_of(*torque, std::get<Cam>(*given.curve)), look);
  figure.panels.push_back(std::move(of_torque.panels.front()));
  figure.panels.back().y_label = is_linear(*optimized.optimize.shape.load)
                                     ? "torque [N m]"
                                     : "torque without friction, lever [N m]";
  return figure;
}

}  // namespace jounce

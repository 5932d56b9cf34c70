// SPDX-License-Identifier: Apache-2.0
#include "cli/optimize/before_after.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/design/make.hpp"
#include "jounce/plot/curve_figure.hpp"

#include "cli/common/picture.hpp"

namespace jounce::cli {
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

Input input_of(const Spec& spec, const std::string& name) {
  Input input = std::move(inputs_of(spec, spec.document.name).front());
  input.name = name;
  return input;
}

}  // namespace

Figure before_after(const Spec& before, const Spec& after) {
  const Input given = input_of(before, "given");
  const Input better = input_of(after, "optimised");
  Figure figure = figure_of(better, given);
  figure.title = (after.name.empty() ? after.document.name : after.name) + ": optimised";
  const auto torque = torque_of(after);
  if (!torque) return figure;
  CurveLook look{
      .axis_unit = after.units.x, .unit = "N m", .label = better.name, .before = given.name};
  Figure of_torque = curve_figure(quantity_of(*torque, std::get<Cam>(*better.curve)),
                                  quantity_of(*torque, std::get<Cam>(*given.curve)), look);
  figure.panels.push_back(std::move(of_torque.panels.front()));
  figure.panels.back().y_label = is_linear(*after.optimize.shape.load)
                                     ? "torque [N m]"
                                     : "torque without friction, lever [N m]";
  return figure;
}

}  // namespace jounce::cli

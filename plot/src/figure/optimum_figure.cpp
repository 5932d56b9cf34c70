// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/optimum_figure.hpp"

#include <utility>

#include "jounce/design/input.hpp"
#include "jounce/plot/input_figure.hpp"

#include "plot/src/figure/curve_figure.hpp"
#include "plot/src/figure/torque_panels.hpp"

namespace jounce {
namespace {

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
  const CurveLook look{
      .axis_unit = optimized.units.x, .unit = "N m", .label = better.name, .before = given.name};
  for (Panel& panel :
       torque_panels(optimized, std::get<Cam>(*better.curve), std::get<Cam>(*given.curve), look))
    figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/load_figure.hpp"

#include <utility>

#include "jounce/design/detail/load_figures.hpp"
#include "jounce/spec/shape_spec.hpp"

#include "plot/src/figure/input_look.hpp"
#include "plot/src/figure/torque_panels.hpp"

namespace jounce {
namespace {

Panel panel_of_load(Figure figure, const char* label) {
  Panel panel = std::move(figure.panels.front());
  panel.y_label = label;
  return panel;
}

const char* torque_label(const Spec& spec) {
  return is_linear(*spec.optimize.shape.load) ? "torque [N m]"
                                              : "torque without friction, lever [N m]";
}

}  // namespace

std::vector<Panel> torque_panels(const Spec& spec, const Cam& cam, const Cam& before,
                                 const CurveLook& look) {
  const auto now = load_curves(spec, cam);
  if (!now) return {};
  return {panel_of_load(curve_figure(now->torque, load_curves(spec, before)->torque, look),
                        torque_label(spec))};
}

std::optional<Figure> load_figure(const Input& input) {
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr || !input.spec) return std::nullopt;
  const auto curves = load_curves(*input.spec, *cam);
  if (!curves) return std::nullopt;
  CurveLook look = look_of(input);
  look.unit = "N m";
  look.limits = {};
  look.marked_limits.reset();
  look.x_note.clear();
  look.rate_units = {};
  Figure figure = curve_figure(curves->torque, look);
  figure.panels = {panel_of_load(figure, torque_label(*input.spec))};
  if (!curves->power) return figure;
  look.unit = "W";
  figure.panels.push_back(panel_of_load(curve_figure(*curves->power, look), "power [W]"));
  return figure;
}

}  // namespace jounce

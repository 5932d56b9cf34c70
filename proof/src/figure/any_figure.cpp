// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/any_figure.hpp"

#include <utility>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/axes.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/load_figure.hpp"
#include "jounce/proof/drive_figures.hpp"

#include "proof/src/figure/follower_figure.hpp"
#include "proof/src/figure/loop_figures.hpp"

namespace jounce {
namespace {

bool is_of_loop(const FigureRequest& request) {
  return request.drive == "bode" || request.drive == "nyquist";
}

/// Calls loop_figure(); errors name the member `drive`.
Figure loop_of(const FigureRequest& request) {
  try {
    return loop_figure(request);
  } catch (const InputError& error) {
    if (error.key() != "axis") throw;
    throw InputError("drive", error.value(), error.rule());
  }
}

std::vector<Input> inputs_of(const FigureRequest& request) {
  std::vector<Input> all = request.machine.empty() ? read_inputs(request.file)
                                                   : gcode_inputs(request.file, request.machine);
  require_no_input(files_of(all), request.output);
  all = axes_named(std::move(all), request.axis, request.file);
  for (Input& input : all)  // beside another motion, only a cam needs the request
    if (request.before.empty() || input.labels.over_master)
      input = over(request.over, std::move(input));
  return all;
}

/// The only axis of the file `before`, or the axis with the name of `input`.
Input before_of(const FigureRequest& request, const Input& input) {
  std::vector<Input> all = read_program(request.before, request.machine);
  require_no_input(files_of(all), request.output);
  if (all.size() > 1) all = axes_named(std::move(all), input.axis, request.before);
  Input before = only_axis(std::move(all), request.before);
  return before.labels.over_master ? over(request.over, std::move(before)) : before;
}

/// The figure, and below it torque and power of a [load].
Figure with_load(Figure figure, const std::vector<Input>& inputs) {
  if (inputs.size() > 1) return figure;
  if (auto load = load_figure(inputs.front()))
    for (Panel& panel : load->panels) figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

Figure any_figure(const FigureRequest& request) {
  if (is_of_loop(request)) return loop_of(request);
  const std::vector<Input> inputs = inputs_of(request);
  if (!request.drive.empty()) {
    if (inputs.size() > 1)
      throw InputError("drive", request.drive, "shows one axis: name it with --axis");
    return drive_figure(inputs.front(), request.drive);
  }
  if (request.follower)
    return follower_figure(inputs.front());  // a spec with [follower] has one axis
  if (request.before.empty()) return with_load(figure_of(inputs), inputs);
  if (inputs.size() > 1)
    throw InputError("before", request.before, "compares one axis: name it with --axis");
  return figure_of(inputs.front(), before_of(request, inputs.front()));
}

}  // namespace jounce

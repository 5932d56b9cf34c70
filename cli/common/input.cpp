// SPDX-License-Identifier: Apache-2.0
#include "cli/common/input.hpp"

#include <utility>

#include "jounce/design/detail/axes.hpp"
#include "jounce/design/detail/version.hpp"
#include "jounce/design/over_time.hpp"

#include "cli/common/option_names.hpp"

namespace jounce::cli {
namespace {

std::vector<Input> axis_of(std::vector<Input> all, const std::string& path,
                           const std::string& axis) {
  return with_option_names({"axis"}, [&] { return axes_named(std::move(all), axis, path); });
}

}  // namespace

std::vector<Input> over(const std::string& what, std::vector<Input> all) {
  for (Input& input : all)
    input = with_option_names({"over"}, [&] { return over(what, std::move(input)); });
  return all;
}

Input only_one(std::vector<Input> all, const std::string& path) {
  return with_option_names({"axis"}, [&] { return only_axis(std::move(all), path); });
}

std::vector<Input> load_axes(const std::string& path, const std::string& axis, bool decimal_comma) {
  return axis_of(read_inputs(path, decimal_comma), path, axis);
}

std::vector<Input> load_program(const std::string& path, const std::string& machine,
                                const std::string& axis) {
  if (machine.empty()) return load_axes(path, axis);
  return axis_of(gcode_inputs(path, machine), path, axis);
}

Input load_program_axis(const std::string& path, const std::string& machine,
                        const std::string& axis) {
  return only_one(load_program(path, machine, axis), path);
}

Input load(const std::string& path, const std::string& axis, bool decimal_comma) {
  return only_one(load_axes(path, axis, decimal_comma), path);
}

Input load_beside(const std::string& path, const Input& input, const std::string& machine) {
  std::vector<Input> all = read_program(path, machine);
  require_one_kind(all.front(), input, path, input.files.front());
  if (all.size() > 1) all = axis_of(std::move(all), path, input.axis);
  return only_one(std::move(all), path);
}

}  // namespace jounce::cli

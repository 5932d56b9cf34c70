// SPDX-License-Identifier: Apache-2.0
#include "cli/common/input.hpp"

#include <algorithm>
#include <utility>

namespace jounce::cli {
namespace {

std::string names_of(const std::vector<Input>& inputs) {
  std::string names;
  for (const Input& input : inputs) names += (names.empty() ? "" : ", ") + input.axis;
  return names;
}

/// All inputs of a file, or only that of the named axis.
std::vector<Input> axis_of(std::vector<Input> all, const std::string& path,
                           const std::string& axis) {
  if (axis.empty()) return all;
  const std::string name = path == "-" ? "standard input" : path;
  const auto is_meant = [&](const Input& input) { return input.axis == axis; };
  if (const auto n = std::count_if(all.begin(), all.end(), is_meant); n > 1)
    throw InputError(
        "--axis", axis,
        "is the name of " + std::to_string(n) + " cams in " + name + ": rename one of them");
  const auto named = std::find_if(all.begin(), all.end(), is_meant);
  if (named == all.end())
    throw InputError("--axis", axis,
                     all.size() == 1 ? name + " has only one axis, without a name: leave out --axis"
                                     : "must be one of " + names_of(all));
  Input one = std::move(*named);
  all.clear();
  all.push_back(std::move(one));
  return all;
}

Input only_one(std::vector<Input> all, const std::string& path) {
  if (all.size() > 1)
    throw InputError("--axis", "",
                     "is missing: this verb works with one axis, " +
                         (path == "-" ? "standard input" : path) + " has " + names_of(all));
  return std::move(all.front());
}

}  // namespace

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

Input load_beside(const std::string& path, const Input& input) {
  std::vector<Input> all = load_axes(path);
  return all.size() == 1 ? std::move(all.front()) : load(path, input.axis);
}

std::string file_of_axis(const std::string& option, const std::string& path,
                         const std::string& axis, std::size_t axes) {
  if (axes == 1 || path.empty()) return path;
  if (path == "-")
    throw InputError(option, "",
                     "is missing: each axis needs a file; -o a.csv writes a-" + axis +
                         ".csv and so on, --axis " + axis + " writes one axis only");
  const auto slash = path.find_last_of('/') + 1;  // npos + 1 is 0
  const auto dot = path.find_last_of('.');
  const auto end = dot == std::string::npos || dot <= slash ? path.size() : dot;
  return path.substr(0, end) + "-" + axis + path.substr(end);
}

}  // namespace jounce::cli

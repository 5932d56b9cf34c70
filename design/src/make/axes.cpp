// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/axes.hpp"

#include <algorithm>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string shown_path(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

}  // namespace

std::vector<Input> axes_named(std::vector<Input> all, const std::string& axis,
                              const std::string& path) {
  if (axis.empty()) return all;
  const std::string name = shown_path(path);
  const auto is_meant = [&](const Input& input) { return input.axis == axis; };
  if (const auto n = std::count_if(all.begin(), all.end(), is_meant); n > 1)
    throw InputError(
        "axis", axis,
        "is the name of " + std::to_string(n) + " cams in " + name + ": rename one of them");
  const auto named = std::find_if(all.begin(), all.end(), is_meant);
  if (named == all.end())
    throw InputError("axis", axis,
                     all.size() == 1 ? name + " has only one axis, without a name: leave out --axis"
                                     : "must be one of " + listed(all, &Input::axis));
  Input one = std::move(*named);
  all.clear();
  all.push_back(std::move(one));
  return all;
}

Input only_axis(std::vector<Input> all, const std::string& path) {
  if (all.size() > 1)
    throw InputError("axis", "",
                     "is missing: " + shown_path(path) + " has several axes. Choose one of " +
                         listed(all, &Input::axis));
  return std::move(all.front());
}

std::string file_of_axis(const std::string& path, const std::string& axis) {
  const auto slash = path.find_last_of('/') + 1;  // npos + 1 is 0
  const auto dot = path.find_last_of('.');
  const auto end = dot == std::string::npos || dot <= slash ? path.size() : dot;
  return path.substr(0, end) + "-" + axis + path.substr(end);
}

std::string file_of_axis(const std::string& option, const std::string& path,
                         const std::string& axis, std::size_t axes) {
  if (axes == 1 || path.empty()) return path;
  if (path == "-")
    throw InputError(option, "",
                     "is missing: with several axes, each needs a file. -o a.csv writes a-" + axis +
                         ".csv and so on; --axis " + axis + " writes one axis only");
  return file_of_axis(path, axis);
}

}  // namespace jounce

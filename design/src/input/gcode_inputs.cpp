// SPDX-License-Identifier: Apache-2.0
// The inputs of a G-code program.
#include <utility>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/design/input.hpp"
#include "jounce/io/gcode.hpp"

namespace jounce {
namespace {

/// Reads the spec of the machine of a G-code program: axes, limits and corners, but no motion.
Spec read_gcode_machine(const std::string& machine, const std::string& program) {
  std::string text = read_file(machine);
  if (const std::string kind = spec_kind(text); !kind.empty() && kind != "path")
    throw InputError("--machine", machine,
                     "is of kind \"" + kind +
                         "\". A G-code program needs a spec of kind \"path\" with the axes, their "
                         "limits and the "
                         "corners: see `jounce new path`");
  Spec spec = parse_spec(std::move(text), machine);
  const auto* const path = std::get_if<PathSpec>(&spec.subject);
  if (path == nullptr)
    throw InputError("--machine", machine, "must be a spec of kind \"path\" without commands");
  if (const auto commands = path->program.commands(); !commands.empty())
    throw InputError("--machine", machine,
                     "has a motion of its own, " + path->source + ":" +
                         std::to_string(commands.front().line) + ": remove it from " + machine +
                         " to use that spec for " + program + ", or give " + machine +
                         " instead of " + program + ", without --machine");
  return spec;
}

}  // namespace

Spec gcode_spec(const std::string& path, const std::string& machine) {
  const std::string name = path == "-" ? "standard input" : path;
  std::string program = read_file(path);
  if (!spec_kind(program).empty())
    throw InputError("", "", "is a spec, not a G-code program: leave out --machine").at(name, 1);
  Spec spec = read_gcode_machine(machine, path);
  auto* const of = std::get_if<PathSpec>(&spec.subject);
  set_gcode(*of, std::move(program), name);
  spec.name = path == "-" ? "standard input" : printable(path);
  return spec;
}

std::vector<Input> read_program(const std::string& path, const std::string& machine) {
  const auto is_program = [&] {
    const std::string text = read_file(path);
    return !is_finished_table(text, path) && begins_as_gcode(text);
  };
  return !machine.empty() && (path == "-" || is_program()) ? gcode_inputs(path, machine)
                                                           : read_inputs(path);
}

std::vector<Input> gcode_inputs(const std::string& path, const std::string& machine) {
  return inputs_of(gcode_spec(path, machine), machine);
}

}  // namespace jounce

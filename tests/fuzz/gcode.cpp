// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/gcode.hpp"

#include <cmath>

#include "jounce/profiles/error.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {
namespace {

GcodeMachine machine_of(std::size_t kind) {
  GcodeMachine machine{.axes = {{"X", "mm"}, {"Y", "mm"}, {"Z", "mm"}}};
  if (kind == 1) machine.axes = {{"x", "pulse"}, {"y", "pulse"}};
  if (kind == 2) {
    machine.axes.push_back({"A", "deg"});
    machine.path_axes = 3;
    machine.settings = {.velocity = 100, .corner = Corner::deviation, .value = 0.05};
    machine.frames.fill(Frame{.offset = {1, 2, 3, 4}});
  }
  return machine;
}

}  // namespace

void gcode(Input input) {
  const std::string text = text_of(input);
  static_cast<void>(begins_as_gcode(text));
  for (std::size_t kind = 0; kind < 3; ++kind) {
    try {
      const GcodeProgram made = parse_gcode(text, "fuzz", machine_of(kind));
      for (const double each : made.program.position())
        require(std::isfinite(each), "a position is finite");
      int before = 0;
      for (const Program::Command& command : made.program.commands()) {
        require(command.line >= before, "lines ascend");
        before = command.line;
      }
    } catch (const InputError& error) {
      require(error.line() > 0 && error.column() > 0, "an error has a place");
    }
  }
}

}  // namespace jounce::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/gcode.hpp"

#include <algorithm>

#include "jounce/profiles/error.hpp"

#include "io/src/gcode/interpreter.hpp"

namespace jounce {
namespace {

/// True for the number of a program, such as O1234, alone in its block.
bool is_program_number(const io_detail::GcodeBlock& block) {
  return block.words.size() == 1 && block.words.front().letters == "O";
}

}  // namespace

bool begins_as_gcode(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (line[line.find_first_not_of(" \t\r")] == '%' || line.front() == '(') return true;
    try {
      if (!io_detail::read_block(line, 1).words.empty()) return true;
    } catch (const InputError&) {
      return false;
    }
  }
  return false;
}

GcodeProgram parse_gcode(std::string_view text, const std::string& document,
                         const GcodeMachine& machine) {
  io_detail::GcodeInterpreter interpreter(machine);
  bool runs = true;
  bool begun = false;      // a % after this ends the program
  bool has_words = false;  // the number of the program is the first word
  for (int line = 1; runs && !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const std::size_t first = text.find_first_not_of(" \t");
    const bool percent = first < end && text[first] == '%';
    try {
      const io_detail::GcodeBlock block = io_detail::read_block(text.substr(0, end), line);
      const bool is_head = !has_words && is_program_number(block);
      has_words = has_words || !block.words.empty();
      runs = !(percent && begun) && (is_head || interpreter.execute(block));
      begun = begun || percent || !block.words.empty();
    } catch (const InputError& error) {
      throw InputError(error.key(), error.value(), error.rule())
          .at(document, line, std::max(error.column(), 1));
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return interpreter.take();
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "io/src/gcode/interpreter.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"

#include "io/src/gcode/gcode_words.hpp"

namespace jounce::io_detail {
namespace {

/// M words that take effect after the motion of their block (RS-274).
bool is_at_end_of_block(const GcodeEvent& event) {
  return event.word.front() == 'M' && (event.number <= 2 || event.number == 30);  // M0, M1, M2, M30
}

}  // namespace

GcodeInterpreter::GcodeInterpreter(const GcodeMachine& machine)
    : machine_(machine),
      made_{Program(machine.axes.size(), machine.start, machine.path_axes), {}, {}},
      feed_(machine.settings),
      rapid_(machine.settings),
      corner_(machine.settings) {
  rapid_.velocity = machine.rapid;
  for (const GcodeMachine::Axis& axis : machine.axes) {
    const char c = axis.name.size() == 1
                       ? static_cast<char>(std::toupper(static_cast<unsigned char>(axis.name[0])))
                       : '\0';
    if (c == '\0' || gcode_axes.find(c) == std::string_view::npos)
      throw InputError("axis[" + std::to_string(letters_.size() + 1) + "].name",
                       '"' + axis.name + '"',
                       "must be one of X Y Z A B C U V W, so that G-code can move it");
    letters_ += c;
  }
  set_units("");
  if (const auto& frame = machine.frames[0]) frame_ = *frame;
  part_ = within(frame_, machine.start);
}

bool GcodeInterpreter::execute(const GcodeBlock& block) {
  if (block.words.empty()) return true;
  require_supported(block);
  require_known(block);
  const bool dwell = set_modes(block);
  set_rates(block);
  const std::size_t first = made_.events.size();
  add_events(block);
  if (dwell)
    rest(block);
  else
    move(block);
  const bool ends = stops(block);
  const auto events = made_.events.begin() + static_cast<std::ptrdiff_t>(first);
  const auto at_end = std::stable_partition(
      events, made_.events.end(), [](const auto& event) { return !is_at_end_of_block(event); });
  for (auto event = at_end; event != made_.events.end(); ++event)
    event->command = made_.program.commands().size();
  return !ends;
}

GcodeProgram GcodeInterpreter::take() {
  return std::move(made_);
}

void GcodeInterpreter::require_known(const GcodeBlock& block) const {
  for (const GcodeWord& word : block.words)
    if (word.letters == "M" && (word.value == 98 || word.value == 99))
      fail_at(block, word,
              "subprograms are not supported: have the CAM program write all motions in one "
              "program");
  static const std::vector<std::string> others{"N", "G", "M", "H", "S", "T",  "F", "E",
                                               "P", "R", "I", "J", "K", "FF", "EF"};
  for (const GcodeWord& word : block.words) {
    if (word.letters == "N" && &word != block.words.data())
      fail_at(block, word, "must be the first word of its block");
    if (axis_of(word.letters) != std::string::npos) continue;
    if (word.letters.size() == 1 && gcode_axes.find(word.letters[0]) != std::string_view::npos)
      fail_at(block, word,
              "moves an axis that the machine does not have: its axes are " + letters_ +
                  ". Remove this word, or add the axis to the spec of the machine");
    if (std::find(others.begin(), others.end(), word.letters) == others.end())
      fail_at(block, word, rule_of_unsupported(word.letters));
  }
}

void GcodeInterpreter::add_events(const GcodeBlock& block) {
  for (const GcodeWord& word : block.words) {
    const std::string& letters = word.letters;
    if (letters != "M" && letters != "H" && letters != "S" && letters != "T") continue;
    const bool whole = word.value == std::floor(word.value) && (letters == "H" || word.value >= 0);
    if (letters == "H" && !(whole && word.value != 0))
      fail_at(block, word, "must be the number of an output, or this number with a minus sign");
    if (letters != "S" && !whole) fail_at(block, word, "must be a whole number of at least 0");
    made_.events.push_back(
        {letters + word.text, block.line, made_.program.commands().size(), word.value});
  }
}

void GcodeInterpreter::rest(const GcodeBlock& block) {
  const GcodeWord* const p = block.find("P");
  if (p == nullptr) fail_at(block, "G4", "needs P, the time in s, such as G4 P0.5");
  if (!(p->value >= 0)) fail_at(block, *p, "must not be negative");
  for (const GcodeWord& word : block.words)
    if (axis_of(word.letters) != std::string::npos)
      fail_at(block, word, "must not be in the block of a dwell (G4): write it in its own block");
  made_.program.dwell(p->value * machine_.second, block.line);
}

bool GcodeInterpreter::stops(const GcodeBlock& block) {
  for (const GcodeWord& word : block.words) {
    if (word.letters != "M") continue;
    if (word.value == 0 || word.value == 1) made_.program.dwell(0, block.line);
    if (word.value == 2 || word.value == 30) return true;
  }
  return false;
}

double gcode_scale(const std::string& from, const std::string& unit) {
  try {
    return conversion(from, unit);
  } catch (const InputError&) {
    return 1;
  }
}

void fail_at(const GcodeBlock& block, const GcodeWord& word, const std::string& rule) {
  throw InputError(word.letters + word.text, "", rule).at({}, block.line, word.column);
}

void fail_at(const GcodeBlock& block, const std::string& key, const std::string& rule) {
  throw InputError(key, "", rule).at({}, block.line, block.words.front().column);
}

}  // namespace jounce::io_detail

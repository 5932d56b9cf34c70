// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "io/src/gcode/gcode_words.hpp"
#include "io/src/gcode/interpreter.hpp"

namespace jounce::io_detail {
namespace {

constexpr double whole_code = 1e-6;  ///< distance of ten times a code from a whole number

/// G numbers times 10, by modal group: two of one group contradict each other.
constexpr std::array<std::pair<int, int>, 27> modal_groups{{
    {0, 1},    {10, 1},   {20, 1},   {30, 1},   {800, 1},              //
    {170, 2},  {180, 2},  {190, 2},                                    //
    {900, 3},  {910, 3},                                               //
    {901, 4},  {911, 4},                                               //
    {200, 6},  {210, 6},                                               //
    {400, 7},  {490, 8},  {940, 5},                                    //
    {540, 12}, {550, 12}, {560, 12}, {570, 12}, {580, 12}, {590, 12},  //
    {610, 13}, {611, 13}, {640, 13},                                   //
    {40, 0},
}};

int group_of(int code) {
  const auto* const found = std::find_if(modal_groups.begin(), modal_groups.end(),
                                         [&](const auto& each) { return each.first == code; });
  return found == modal_groups.end() ? -1 : found->second;
}

/// The tenfold number of a G word; -1 if no G number has more than one decimal or such a size.
int code_of(const GcodeWord& word) {
  const double tenfold = 10 * word.value;
  const int code = tenfold >= 0 && tenfold < 10000 ? static_cast<int>(std::lround(tenfold)) : -1;
  return std::abs(tenfold - code) < whole_code ? code : -1;
}

bool has_tolerance(const GcodeBlock& block) {
  return std::any_of(block.words.begin(), block.words.end(),
                     [](const GcodeWord& word) { return word.letters == "G" && word.value == 64; });
}

double positive_word(const GcodeBlock& block, const GcodeWord& word) {
  if (!(word.value > 0)) fail_at(block, word, "must be greater than 0");
  return word.value;
}

}  // namespace

void GcodeInterpreter::set_units(const std::string& length) {
  length_ = length;
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    const std::string& unit = machine_.axes[i].unit;
    const bool turns = letters_[i] >= 'A' && letters_[i] <= 'C';
    scale_[i] = turns ? gcode_scale("deg", unit) : length.empty() ? 1 : gcode_scale(length, unit);
  }
}

void GcodeInterpreter::require_supported(const GcodeBlock& block) const {
  for (const GcodeWord& word : block.words)
    if (word.letters == "G" && group_of(code_of(word)) < 0)
      fail_at(block, word, rule_of_unsupported(word.value));
}

bool GcodeInterpreter::set_modes(const GcodeBlock& block) {
  std::array<const GcodeWord*, 14> taken{};
  for (const GcodeWord& word : block.words) {
    if (word.letters != "G") continue;
    const int code = code_of(word);
    const GcodeWord*& first = taken[static_cast<std::size_t>(group_of(code))];
    if (first != nullptr)
      fail_at(block, word,
              "contradicts G" + six_digits(first->value) + " of this block: write one of the two");
    first = &word;
    set_mode(block, word, code);
  }
  if (block.find("P") != nullptr && taken[0] == nullptr && !has_tolerance(block))
    fail_at(
        block, *block.find("P"),
        "does not apply to this block: P is the time of a dwell (G4), or the greatest deviation "
        "(G64)");
  if (taken[0] != nullptr && taken[1] != nullptr)
    fail_at(block, "G4", "must not be in a block with a motion: write it in its own block");
  if (taken[0] && has_tolerance(block))
    fail_at(block, "G64",
            "must not be in the block of a dwell, because P would apply to both: write it in its "
            "own block");
  return taken[0];
}

void GcodeInterpreter::set_mode(const GcodeBlock& block, const GcodeWord& word, int code) {
  switch (code) {
    case 0:
    case 10:
    case 20:
    case 30:
      motion_ = code / 10;
      break;
    case 800:
      motion_ = -1;
      break;
    case 170:
      plane_ = "XY";
      break;
    case 180:
      plane_ = "ZX";
      break;
    case 190:
      plane_ = "YZ";
      break;
    case 200:
    case 210:
      set_length(block, word, code == 200 ? "in" : "mm");
      break;
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
      set_frame(block, word, static_cast<std::size_t>(code / 10 - 54));
      break;
    case 610:
    case 611:  // exact stop: at tangent joints, too
      corner_.corner = Corner::stop;
      corner_.value = 0;
      corner_.junction = code == 611 ? Junction::buffered : machine_.settings.junction;
      break;
    case 640:
      set_tolerance(block, word);
      break;
    case 900:
    case 910:
      relative_ = code == 910;
      break;
    case 901:
    case 911:
      center_relative_ = code == 911;
      break;
    default:  // G4 is done by rest(); G40, G49, G94: nothing to switch off
      break;
  }
}

void GcodeInterpreter::set_length(const GcodeBlock& block, const GcodeWord& word,
                                  const char* length) {
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    if (letters_[i] >= 'A' && letters_[i] <= 'C') continue;
    try {
      (void)conversion(length, machine_.axes[i].unit);
    } catch (const InputError&) {
      fail_at(block, word,
              std::string("needs axes with a unit of length, but axis ") + letters_[i] +
                  " has the unit " + machine_.axes[i].unit);
    }
  }
  set_units(length);
}

void GcodeInterpreter::set_frame(const GcodeBlock& block, const GcodeWord& word,
                                 std::size_t number) {
  const auto& frame = machine_.frames[number];
  if (!frame && number > 0)
    fail_at(block, word,
            "needs an offset: add G" + word.text + " = [...] to [gcode] of the machine");
  frame_ = frame.value_or(Frame{});
  part_ = within(frame_, made_.program.position());
}

void GcodeInterpreter::set_tolerance(const GcodeBlock& block, const GcodeWord& word) {
  const GcodeWord* const p = block.find("P");
  if (p != nullptr) {
    if (!(p->value >= 0)) fail_at(block, *p, "must not be negative: it is the greatest deviation");
    const bool averages = machine_.settings.corner == Corner::average;
    corner_.junction = machine_.settings.junction;
    corner_.corner = p->value == 0 ? Corner::stop : averages ? Corner::average : Corner::deviation;
    corner_.value = p->value * scale_[0];
    return;
  }
  if (machine_.settings.corner == Corner::stop)
    fail_at(block, word,
            "needs the greatest deviation: write G64 P0.05, or give a `corner` in [path]");
  corner_ = machine_.settings;
}

void GcodeInterpreter::set_rates(const GcodeBlock& block) {
  const double acceleration = 1 / (machine_.second * machine_.second);
  for (const auto& [word, settings] :
       {std::pair{block.find("E"), &feed_}, {block.find("EF"), &rapid_}})
    if (word != nullptr)
      settings->acceleration = settings->deceleration =
          positive_word(block, *word) * acceleration * scale_[0];
  if (const auto* const word = block.find("FF"))
    rapid_.velocity = positive_word(block, *word) * scale_[0] / time();
  if (const auto* const word = block.find("F")) {
    feed_word_ = positive_word(block, *word);
    feed_.velocity = feed_word_ * scale_[0] / time();
  }
}

}  // namespace jounce::io_detail

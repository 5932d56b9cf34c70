// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/base/document.hpp"
#include "jounce/path/arc.hpp"
#include "jounce/path/rotary.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "io/src/gcode/interpreter.hpp"

namespace jounce::io_detail {
namespace {

constexpr std::string_view center_letters = "IJK";
constexpr double arc_tolerance = 0.01;  // mm: programs round centers to 0.001 mm or 0.0001 in

/// A radius below half the chord by no more than the tolerance is half the chord.
double fitting_radius(double radius, const Point& from, const Point& to, Plane plane,
                      double tolerance) {
  const double half =
      std::hypot(to[plane.first] - from[plane.first], to[plane.second] - from[plane.second]) / 2;
  const double missing = half - std::abs(radius);
  return missing > 0 && missing <= tolerance && radius != 0 ? std::copysign(half, radius) : radius;
}

}  // namespace

void GcodeInterpreter::move(const GcodeBlock& block) {
  const GcodeWord* first = nullptr;
  const GcodeWord* center = nullptr;
  for (const GcodeWord& word : block.words) {
    if (first == nullptr && axis_of(word.letters) != std::string::npos) first = &word;
    const bool of_arc =
        word.letters == "R" || (word.letters.size() == 1 &&
                                center_letters.find(word.letters[0]) != std::string_view::npos);
    if (center == nullptr && of_arc) center = &word;
  }
  const bool arc = motion_ == 2 || motion_ == 3;
  if (center != nullptr && !arc)
    fail_at(block, *center,
            "applies to an arc, but the motion is not G2 or G3: remove it, or write G2 or G3");
  if (first == nullptr && center == nullptr) return;
  if (motion_ < 0)
    fail_at(block, *(first != nullptr ? first : center),
            "needs a motion: write G0, G1, G2 or G3 before it");
  if (arc && center == nullptr)
    fail_at(block, *first, "needs the center (I J K) or the radius (R) of the arc in this block");
  const Target to = target(block);
  made_.program.set(settings(block, to.machine));
  if (arc)
    turn(block, to, *center);
  else if (to.machine != made_.program.position())
    made_.program.line(to.machine, block.line);
  if (motion_ == 0) made_.rapids.push_back(block.line);
  part_ = to.part;
}

void GcodeInterpreter::require_inside(const GcodeBlock& block, const GcodeWord& word, std::size_t i,
                                      double position) const {
  const GcodeMachine::Axis& axis = machine_.axes[i];
  const bool below = axis.position_min && position < *axis.position_min;
  if (!below && !(axis.position_max && position > *axis.position_max)) return;
  fail_at(block, word,
          "moves axis " + axis.name + " to " + six_digits(position) + ' ' + axis.unit +
              (below ? ", below its position_min, " : ", above its position_max, ") +
              number(below ? *axis.position_min : *axis.position_max) + ' ' + axis.unit +
              ": change the program or its offset");
}

GcodeInterpreter::Target GcodeInterpreter::target(const GcodeBlock& block) const {
  Target to{part_, made_.program.position()};
  bool turned = false;
  for (const GcodeWord& word : block.words) {
    const std::size_t i = axis_of(word.letters);
    if (i == std::string::npos) continue;
    const double step = word.value * scale_[i];
    const double modulo = relative_ ? 0 : machine_.axes[i].modulo;
    to.part[i] = shortest_way(to.part[i], (relative_ ? to.part[i] : 0) + step, modulo);
    to.machine[i] =
        shortest_way(to.machine[i], (relative_ ? to.machine[i] : frame_.offset[i]) + step, modulo);
    turned = turned || (i < 3 && !frame_.shifts());
    if (!std::isfinite(to.machine[i]))
      fail_at(block, word, "is too far away: the position would exceed 1.8e308");
  }
  if (turned) {
    const Point machine = placed(frame_, to.part);
    std::copy_n(machine.begin(), 3, to.machine.begin());
  }
  for (const GcodeWord& word : block.words) {
    const std::size_t i = axis_of(word.letters);
    if (i == std::string::npos) continue;
    const bool all = turned && i < 3;  // a word of a turned frame may move each of the first axes
    const std::size_t first = all ? 0 : i;
    const std::size_t last = all ? std::min<std::size_t>(2, machine_.axes.size() - 1) : i;
    for (std::size_t k = first; k <= last; ++k) require_inside(block, word, k, to.machine[k]);
  }
  return to;
}

PathSettings GcodeInterpreter::settings(const GcodeBlock& block, const Point& to) const {
  PathSettings now = motion_ == 0 ? rapid_ : feed_;
  if (motion_ != 0 && now.velocity == PathSettings::none)
    fail_at(block, "F",
            "is missing: G1, G2 and G3 need a feed. Add F to this block, or velocity to [path]");
  now.corner = corner_.corner;
  now.value = corner_.value;
  now.junction = corner_.junction;
  if (motion_ == 0 || feed_word_ == 0) return now;
  const Point& from = made_.program.position();
  std::size_t i = 0;
  while (i < letters_.size() && from[i] == to[i]) ++i;
  if (i < letters_.size() && i >= made_.program.path_axes())
    now.velocity = feed_word_ * scale_[i] / time();
  return now;
}

void GcodeInterpreter::turn(const GcodeBlock& block, const Target& target, const GcodeWord& given) {
  const std::size_t first = axis_of(plane_.substr(0, 1));
  const std::size_t second = axis_of(plane_.substr(1, 1));
  if (first == std::string::npos || second == std::string::npos)
    fail_at(block, given,
            "belongs to an arc in the plane " + std::string(plane_) +
                ", but the axes of the machine are " + letters_);
  const Plane plane{first, second};
  const ArcRotation rotation =
      motion_ == 2 ? ArcRotation::clockwise : ArcRotation::counterclockwise;
  // In the machine for a frame that shifts, so that no digit is lost; in the frame where it turns.
  const bool shifts = frame_.shifts();
  const Point from = shifts ? made_.program.position() : part_;
  const Point& to = shifts ? target.machine : target.part;
  const auto add = [&](const Arc& arc) {
    made_.program.arc(shifts ? arc : placed(frame_, arc), block.line);
  };
  const double tolerance = arc_tolerance * gcode_scale("mm", machine_.axes[first].unit);
  try {
    if (const GcodeWord* const r = block.find("R")) {
      if (&given != r)
        fail_at(block, *r, "cannot be combined with I, J, K: write the center or the radius");
      for (const char c : center_letters)
        if (const auto* const word = block.find({&c, 1}))
          fail_at(block, *word, "cannot be combined with R: write the center or the radius");
      const double radius = fitting_radius(r->value * scale_[first], from, to, plane, tolerance);
      return add(arc_of_radius(from, radius, to, plane, rotation));
    }
    add(arc_about(from, center(block, from, plane), to, plane, rotation, 0, tolerance));
  } catch (const InputError& error) {
    if (error.column() != 0) throw;
    throw in_program(block, plane, error).at({}, block.line, given.column);
  }
}

InputError GcodeInterpreter::in_program(const GcodeBlock& block, Plane plane,
                                        const InputError& error) const {
  Document document;
  document.units[error.key()] = machine_.axes[plane.first].unit;
  if (!length_.empty()) document.given[error.key()] = length_;
  const InputError with_units = document.located(error);
  std::string words;
  for (const GcodeWord& word : block.words)
    if (word.letters == "R" || center_letters.find(word.letters) != std::string_view::npos)
      words += (words.empty() ? "" : " ") + word.letters + word.text;
  return {words.empty() ? error.key() : words, "", with_units.rule()};
}

Point GcodeInterpreter::center(const GcodeBlock& block, const Point& from, Plane plane) const {
  Point center = from;
  for (std::size_t k = 0; k < center_letters.size(); ++k) {
    const GcodeWord* const word = block.find(center_letters.substr(k, 1));
    const std::size_t i = axis_of(gcode_axes.substr(k, 1));
    const bool inside = i == plane.first || i == plane.second;
    if (word != nullptr && !inside)
      fail_at(block, *word,
              "is outside the plane of the arc, " + std::string(plane_) +
                  ": remove it, or change the plane (G17 G18 G19)");
    if (!inside) continue;
    if (word == nullptr && !center_relative_)
      fail_at(block, std::string(center_letters.substr(k, 1)),
              "is missing: after G90.1 an arc needs both coordinates of its center");
    if (word != nullptr)
      center[i] = (center_relative_  ? from[i]
                   : frame_.shifts() ? frame_.offset[i]
                                     : 0) +
                  word->value * scale_[i];
  }
  return center;
}

}  // namespace jounce::io_detail

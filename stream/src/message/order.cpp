// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace jounce::wire {
namespace {

/// Type of a value, as a letter: any number (n), a position (p: any number, or NaN: not given), a
/// magnitude (m: > 0, or NaN: not given), a flag (f), a direction (d), a factor 0 to 2 (o), an
/// integer (w), a nonzero integer (z), a count (c: integer, >= 0), a bank (f), a buffer mode (b:
/// integer, 0 to 5).
struct Meaning {
  const char* name;
  const char* values;
  std::array<const char*, 7> words;
};

constexpr const char* v = "velocity";
constexpr const char* a = "acceleration";
constexpr const char* d = "deceleration";
constexpr const char* j = "jerk";
constexpr const char* b = "buffer mode";

constexpr Meaning meanings[] = {
    {"enable", "", {}},
    {"disable", "", {}},
    {"reset", "", {}},
    {"set_position", "nf", {"position", "relative"}},
    {"home",
     "pcmmmmm",
     {"offset", "method", "search velocity", "index velocity", a, "timeout", "distance"}},
    {"hold", "", {}},
    {"resume", "", {}},
    {"override", "o", {"factor"}},
    {"move_absolute", "nmmmmdb", {"position", v, a, d, j, "direction", b}},
    {"move_relative", "nmmmmb", {"distance", v, a, d, j, b}},
    {"move_additive", "nmmmm", {"distance", v, a, d, j}},
    {"move_superimposed", "nmmmm", {"distance", "velocity difference", a, d, j}},
    {"move_velocity", "nmmmbf", {v, a, d, j, b, "hold to run"}},
    {"halt", "mm", {d, j}},
    {"gear_in", "wzmmm", {"numerator", "denominator", a, d, j}},
    {"gear_in_pos",
     "wznnnf",
     {"numerator", "denominator", "master sync position", "slave sync position",
      "master start distance", "avoid reversal"}},
    {"gear_out", "", {}},
    {"cam_out", "", {}},
    {"queue_switch", "cf", {"queue", "bank"}},
    {"queue_clear", "cfc", {"queue", "bank", "seq"}},
    {"queue_end", "c", {"queue"}},
    {"start", "", {}},
};
static_assert(std::size(meanings) == order_kinds);

const Meaning& meaning(OrderKind kind) {
  return meanings[static_cast<std::size_t>(kind)];
}

/// The rule that the value violates; empty: none.
const char* broken(char letter, double value) {
  const bool whole = std::abs(value) <= 2147483647 && value == std::trunc(value);
  if ((letter == 'm' || letter == 'p') && std::isnan(value)) return "";
  if (!std::isfinite(value)) return "must be finite";
  if (letter == 'm' && !(value > 0))
    return "must be greater than 0; leave it out to use the limit of the axis";
  if (letter == 'f' && value != 0 && value != 1) return "must be 0 or 1";
  if (letter == 'd' && std::abs(value) != 1 && value != 0) return "must be -1, 0 or 1";
  if (letter == 'o' && (value < 0 || value > 2)) return "must be 0 to 2";
  if (letter == 'b' && !(whole && value >= 0 && value <= 5)) return "must be 0 to 5";
  if ((letter == 'w' || letter == 'z') && !whole) return "must be a whole number of 31 bits";
  if (letter == 'z' && value == 0) return "must not be 0";
  if (letter == 'c' && (!whole || value < 0)) return "must be a whole number of 31 bits, 0 or more";
  return "";
}

}  // namespace

const char* name(OrderKind kind) {
  return meaning(kind).name;
}

std::size_t arity(OrderKind kind) {
  return std::strlen(meaning(kind).values);
}

std::array<double, 8> values(OrderKind kind, std::initializer_list<double> given) {
  std::array<double, 8> all{};
  const char* const letters = meaning(kind).values;
  for (std::size_t i = 0; i < arity(kind); ++i)
    if (letters[i] == 'm' || letters[i] == 'p') all[i] = std::numeric_limits<double>::quiet_NaN();
  std::copy(given.begin(), given.end(), all.begin());
  return all;
}

std::string contradiction(const Order& order) {
  const Meaning& means = meaning(order.kind);
  const std::size_t count = arity(order.kind);
  for (std::size_t i = 0; i < order.value.size(); ++i) {
    const double value = order.value[i];
    if (i >= count && value != 0)
      return std::string(means.name) + " takes " + std::to_string(count) + " values at most";
    const char* const rule = i < count ? broken(means.values[i], value) : "";
    if (*rule != 0) return std::string(means.words[i]) + " " + rule;
  }
  return "";
}

}  // namespace jounce::wire

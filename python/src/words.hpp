// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/queue.hpp"
#include "jounce/profiles/sequences/synchronize.hpp"
#include "jounce/profiles/vibration/shaper.hpp"
#include "jounce/pvt/table.hpp"

/// Enumerations are words in Python, the same as in specs and files: "hold", "quintic_hermite".
namespace jounce::python {

/// The words of an enumeration. `key`: name of the argument in an error.
template <class Enum>
struct Words;

template <>
struct Words<Side> {
  static constexpr const char* key = "side";
  static constexpr std::array all{std::pair{"right", Side::right}, std::pair{"left", Side::left}};
};
template <>
struct Words<Extrapolation> {
  static constexpr const char* key = "outside";
  static constexpr std::array all{
      std::pair{"refuse", Extrapolation::refuse}, std::pair{"hold", Extrapolation::hold},
      std::pair{"wrap", Extrapolation::wrap}, std::pair{"advance", Extrapolation::advance}};
};
template <>
struct Words<Interpolation> {
  static constexpr const char* key = "rule";
  static constexpr std::array all{std::pair{"linear", Interpolation::linear},
                                  std::pair{"cubic_hermite", Interpolation::cubic_hermite},
                                  std::pair{"quintic_hermite", Interpolation::quintic_hermite}};
};
template <>
struct Words<Domain> {
  static constexpr const char* key = "domain";
  static constexpr std::array all{std::pair{"time", Domain::time},
                                  std::pair{"master", Domain::master}};
};
template <>
struct Words<Sync> {
  static constexpr const char* key = "sync";
  static constexpr std::array all{std::pair{"none", Sync::none}, std::pair{"time", Sync::time},
                                  std::pair{"phase", Sync::phase},
                                  std::pair{"time_if_moving", Sync::time_if_moving},
                                  std::pair{"phase_or_time", Sync::phase_or_time}};
};
template <>
struct Words<ShaperKind> {
  static constexpr const char* key = "kind";
  static constexpr std::array all{std::pair{"zv", ShaperKind::zv},
                                  std::pair{"zvd", ShaperKind::zvd},
                                  std::pair{"ei", ShaperKind::ei}};
};
template <>
struct Words<BufferMode> {
  static constexpr const char* key = "mode";
  static constexpr std::array all{std::pair{"aborting", BufferMode::aborting},
                                  std::pair{"buffered", BufferMode::buffered},
                                  std::pair{"blending_low", BufferMode::blending_low},
                                  std::pair{"blending_previous", BufferMode::blending_previous},
                                  std::pair{"blending_next", BufferMode::blending_next},
                                  std::pair{"blending_high", BufferMode::blending_high}};
};

/// Returns the value of a word. Throws InputError, with all words, for another one.
template <class Enum>
Enum from_word(const std::string& word) {
  std::string all;
  for (const auto& [text, value] : Words<Enum>::all) {
    if (word == text) return value;
    all += (all.empty() ? "" : ", ") + std::string(text);
  }
  throw InputError(Words<Enum>::key, word, "must be one of " + all);
}

/// Returns the word of a value.
template <class Enum>
const char* to_word(Enum wanted) {
  for (const auto& [text, value] : Words<Enum>::all)
    if (value == wanted) return text;
  return "";
}

/// Returns the order of a derivative. Throws InputError unless it is 0 to 3.
int valid_order(int order);

/// Returns start, start + step, ... and the end. Throws InputError for a step that is not > 0, and for more than 1e8
/// places.
std::vector<double> instants(double start, double end, double step);

}  // namespace jounce::python

namespace pybind11::detail {

/// A word as an argument, and as a result.
template <class Enum>
struct word_caster {
  PYBIND11_TYPE_CASTER(Enum, const_name("str"));

  bool load(handle source, bool) {
    if (PyUnicode_Check(source.ptr()) == 0) return false;
    value = jounce::python::from_word<Enum>(source.cast<std::string>());
    return true;
  }
  static handle cast(Enum each, return_value_policy, handle) {
    return str(jounce::python::to_word(each)).release();
  }
};

template <>
struct type_caster<jounce::Side> : word_caster<jounce::Side> {};
template <>
struct type_caster<jounce::Extrapolation> : word_caster<jounce::Extrapolation> {};
template <>
struct type_caster<jounce::Interpolation> : word_caster<jounce::Interpolation> {};
template <>
struct type_caster<jounce::Domain> : word_caster<jounce::Domain> {};
template <>
struct type_caster<jounce::Sync> : word_caster<jounce::Sync> {};
template <>
struct type_caster<jounce::ShaperKind> : word_caster<jounce::ShaperKind> {};
template <>
struct type_caster<jounce::BufferMode> : word_caster<jounce::BufferMode> {};

}  // namespace pybind11::detail

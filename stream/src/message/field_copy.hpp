// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>

#include "jounce/profiles/error.hpp"

#include "stream/src/message/fields.hpp"

/// Copies the fields of a message to the generated type, and back. A list of the fields (each_field()
/// in body_fields.hpp) serves both directions: it calls the same functions of PutFields and
/// GetFields.
namespace jounce::wire {

/// True if M is T or const T.
template <class M, class T>
concept Is = std::same_as<std::remove_const_t<M>, T>;

/// Copies the fields of a message to the generated type. Throws InputError for a value that does not
/// fit the wire.
class PutFields {
 public:
  /// Number, or any other type that is the same on both sides.
  template <class T>
  void operator()(const char* /*key*/, const T& ours, T& theirs) const {
    theirs = ours;
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* /*key*/, Enum ours, std::int8_t& theirs) const {
    theirs = number_of(ours);
  }
  void operator()(const char* /*key*/, bool ours, std::int8_t& theirs) const {
    theirs = ours ? 1 : 0;
  }
  void operator()(const char* /*key*/, std::uint8_t ours, std::int8_t& theirs) const {
    theirs = static_cast<std::int8_t>(ours);
  }
  void operator()(const char* key, std::uint32_t ours, std::int32_t& theirs) const {
    theirs = put_count(key, ours);
  }
  /// Magnitude; 0: not given.
  void operator()(const char* /*key*/, const std::optional<double>& ours, double& theirs) const {
    theirs = ours.value_or(0);
  }
  template <class T, std::size_t N>
  void operator()(const char* /*key*/, const std::array<T, N>& ours, T (&theirs)[N]) const {
    std::copy(ours.begin(), ours.end(), theirs);
  }
  template <std::size_t N>
  void operator()(const char* /*key*/, const std::string& ours, std::uint8_t (&theirs)[N]) const {
    put_text(ours, theirs, N);
  }
  /// Unit, which must fit as a whole.
  void unit(const char* key, const std::string& ours, std::uint8_t (&theirs)[unit_bytes]) const {
    put_unit(key, ours, theirs);
  }
  /// Bits, which fill the number.
  template <class Ours, class Theirs>
  void bits(const Ours& ours, Theirs& theirs) const {
    theirs = std::bit_cast<Theirs>(ours);
  }
  /// Does nothing: only GetFields checks what it reads.
  void require(bool /*valid*/) const {}
};

/// Copies the fields of the generated type to a message.
class GetFields {
 public:
  template <class T>
  void operator()(const char* /*key*/, T& ours, const T& theirs) const {
    ours = theirs;
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* /*key*/, Enum& ours, std::int8_t theirs) {
    require(get_enum(theirs, ours));
  }
  void operator()(const char* /*key*/, bool& ours, std::int8_t theirs) {
    require(get_flag(theirs, ours));
  }
  void operator()(const char* /*key*/, std::uint8_t& ours, std::int8_t theirs) const {
    ours = static_cast<std::uint8_t>(theirs);
  }
  void operator()(const char* /*key*/, std::uint32_t& ours, std::int32_t theirs) {
    require(get_count(theirs, ours));
  }
  void operator()(const char* /*key*/, std::optional<double>& ours, double theirs) {
    if (theirs != 0) ours = theirs;
    require(theirs >= 0);
  }
  template <class T, std::size_t N>
  void operator()(const char* /*key*/, std::array<T, N>& ours, const T (&theirs)[N]) const {
    std::copy(theirs, theirs + N, ours.begin());
  }
  template <std::size_t N>
  void operator()(const char* /*key*/, std::string& ours, const std::uint8_t (&theirs)[N]) {
    require(get_text(theirs, N, ours));
  }
  void unit(const char* key, std::string& ours, const std::uint8_t (&theirs)[unit_bytes]) {
    (*this)(key, ours, theirs);
  }
  template <class Ours, class Theirs>
  void bits(Ours& ours, const Theirs& theirs) const {
    ours = std::bit_cast<Ours>(theirs);
  }
  void require(bool valid) { valid_ = valid_ && valid; }
  /// True if all fields were in their ranges.
  [[nodiscard]] bool valid() const { return valid_; }

 private:
  bool valid_ = true;
};

}  // namespace jounce::wire

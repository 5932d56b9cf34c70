// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace jounce {

/// A variable that an option of the command line sets: a text, a number, an optional number, a path
/// or a list of texts. The variable must outlive the object.
class OptionTarget {
 public:
  template <class Target>
  requires(!std::is_same_v<std::remove_const_t<Target>, OptionTarget>) OptionTarget(Target& target)
      : target_(&target) {}  // NOLINT(google-explicit-constructor)

  /// Sets the variable from the words of the option; a variable that is no list takes the first.
  /// Returns the rule that the word breaks, such as "must be a number", or "".
  [[nodiscard]] std::string put(const std::vector<std::string>& words) const;
  /// The present value as text; "" for a list and for an optional value.
  [[nodiscard]] std::string text() const;

  [[nodiscard]] bool is_list() const;
  [[nodiscard]] bool is_number() const;

 private:
  std::variant<std::string*, std::vector<std::string>*, std::optional<std::filesystem::path>*,
               double*, int*, std::int64_t*, unsigned*, std::uint64_t*, std::optional<double>*,
               std::optional<std::int32_t>*, std::optional<std::uint16_t>*,
               std::optional<std::uint64_t>*>
      target_;
};

}  // namespace jounce

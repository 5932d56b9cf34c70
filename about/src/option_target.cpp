// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/option_target.hpp"

#include <cctype>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "jounce/about/value_check.hpp"

namespace jounce {
namespace {

template <class Target>
std::string put_word(const std::string& word, Target& target) {
  if constexpr (std::is_assignable_v<Target&, const std::string&>) {
    target = word;
    return "";
  } else {
    const auto number = number_in<Target>(word);
    if (number) target = *number;
    if (number) return "";
    using Range = std::numeric_limits<Target>;
    if (std::is_integral_v<Target> && sizeof(Target) <= 4)
      return fmt::format("must be a whole number from {} to {}", Range::min(), Range::max());
    if (std::is_integral_v<Target>)
      return fmt::format("must be a whole number of at least {}", Range::min());
    const bool has_unit = word.find_first_of("0123456789") == word.find_first_not_of("+-.") &&
                          std::isalpha(static_cast<unsigned char>(word.back())) != 0;
    if (word.find(',') != std::string::npos) return "must be a number with a decimal point";
    return has_unit ? "must be a number without a unit" : "must be a number";
  }
}

template <class Target>
std::string put_word(const std::string& word, std::optional<Target>& target) {
  return put_word(word, target.emplace());
}

}  // namespace

std::string OptionTarget::put(const std::vector<std::string>& words) const {
  if (auto* const list = std::get_if<std::vector<std::string>*>(&target_)) {
    **list = words;
    return "";
  }
  return std::visit(
      [&](auto* target) -> std::string {
        if constexpr (std::is_same_v<decltype(target), std::vector<std::string>*>)
          return "";
        else
          return put_word(words.front(), *target);
      },
      target_);
}

std::string OptionTarget::text() const {
  return std::visit(
      [](const auto* target) -> std::string {
        using Target = std::remove_cvref_t<decltype(*target)>;
        if constexpr (std::is_arithmetic_v<Target>) return fmt::format("{}", *target);
        if constexpr (std::is_same_v<Target, std::string>) return *target;
        return "";
      },
      target_);
}

bool OptionTarget::is_list() const {
  return std::holds_alternative<std::vector<std::string>*>(target_);
}

bool OptionTarget::is_number() const {
  return !is_list() && !std::holds_alternative<std::string*>(target_) &&
         !std::holds_alternative<std::optional<std::filesystem::path>*>(target_);
}

}  // namespace jounce

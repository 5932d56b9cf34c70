// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/value_check.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/detail/nearest.hpp"

namespace jounce {

template <class Number>
std::optional<Number> number_in(const std::string& text) {
  if constexpr (std::is_integral_v<Number>) {
    Number value = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
  } else {
    char* rest = nullptr;
    const auto value = static_cast<Number>(std::strtold(text.c_str(), &rest));
    const bool whole_text = !text.empty() && rest == text.c_str() + text.size();
    return whole_text ? std::optional(value) : std::nullopt;
  }
}

template std::optional<double> number_in(const std::string&);
template std::optional<std::int64_t> number_in(const std::string&);
template std::optional<std::uint64_t> number_in(const std::string&);
template std::optional<int> number_in(const std::string&);
template std::optional<unsigned> number_in(const std::string&);
template std::optional<std::uint16_t> number_in(const std::string&);

namespace checks {

ValueCheck one_of(std::vector<std::string> words) {
  ValueCheck check = [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return "";
    const std::string near = nearest(text, words);
    if (near.empty()) return fmt::format("must be one of {}", fmt::join(words, ", "));
    return words.size() > 8
               ? fmt::format("is unknown: did you mean {}?", near)
               : fmt::format("must be one of {}: did you mean {}?", fmt::join(words, ", "), near);
  };
  check.words = std::move(words);
  return check;
}

ValueCheck whole(std::int64_t low, std::int64_t high, const std::string& what) {
  return [=](const std::string& text) -> std::string {
    const auto value = number_in<std::int64_t>(text);
    if (value && *value >= low && *value <= high) return "";
    if (high == std::numeric_limits<std::int64_t>::max())
      return fmt::format("must be {}a whole number of at least {}", what, low);
    return fmt::format("must be {}a whole number from {} to {}", what, low, high);
  };
}

ValueCheck within(double low, double high) {
  return [=](const std::string& text) {
    const auto value = number_in(text);
    const bool good = value && *value >= low && *value <= high;
    return good ? std::string() : fmt::format("must be a number from {} to {}", low, high);
  };
}

ValueCheck seconds() {
  return [](const std::string& text) {
    const auto value = number_in(text);
    const bool good = value && *value >= 1e-3 && *value <= 1e12;
    return good ? std::string() : "must be a number of seconds from 0.001 to 1e12";
  };
}

ValueCheck seconds_or_none(double low, double high) {
  return [=](const std::string& text) {
    const double value = number_in(text).value_or(-1);
    const bool good = value == 0 || (value >= low && value <= high);
    return good ? std::string()
                : fmt::format("must be from {} to {} seconds, or 0 for none", low, high);
  };
}

ValueCheck ends_in(std::vector<std::string> endings) {
  return [endings = std::move(endings)](const std::string& file) -> std::string {
    const std::string ending = std::filesystem::path(file).extension();
    const bool known = std::find(endings.begin(), endings.end(), ending) != endings.end();
    if (known || ending.empty() || endings.empty()) return "";
    return fmt::format("must end in {}{}{}", fmt::join(endings.begin(), endings.end() - 1, ", "),
                       endings.size() > 1 ? " or " : "", endings.back());
  };
}

ValueCheck output_file(std::vector<std::string> endings) {
  return [ends = ends_in(std::move(endings))](const std::string& file) -> std::string {
    namespace fs = std::filesystem;
    std::error_code none;  // an error counts as no folder
    if (file == "-") return "";
    if (fs::is_directory(file, none)) return "is a folder: name a file in it";
    const fs::path folder = fs::path(file).parent_path();
    if (folder.empty() || fs::is_directory(folder, none)) return ends(file);
    if (fs::exists(folder, none))
      return "cannot be written, because " + folder.string() + " is a file: name a folder there";
    return "cannot be written, because the folder " + folder.string() +
           " does not exist: make it first";
  };
}

ValueCheck output_folder() {
  return [](const std::string& folder) -> std::string {
    namespace fs = std::filesystem;
    std::error_code none;  // an error counts as no file
    if (folder == "-") return "must be a folder, not standard output";
    for (fs::path at = folder; !at.empty(); at = at.parent_path()) {
      const bool exists = fs::exists(at, none);
      if (exists && !fs::is_directory(at, none))
        return at == folder ? "is a file: name a folder"
                            : "cannot be made, because " + at.string() + " is a file";
      if (exists || at == at.parent_path()) break;
    }
    return "";
  };
}

}  // namespace checks
}  // namespace jounce

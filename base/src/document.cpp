// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/document.hpp"

#include <charconv>
#include <map>
#include <system_error>

namespace jounce {
namespace {

bool is_pure(const std::string& unit) {
  return unit.empty() || unit == "1";
}

/// The error with the unit of its number, if its key has one. Fifteen digits hide the rounding of a change of unit.
InputError with_unit(const InputError& error, const std::map<std::string, std::string>& units) {
  const auto unit = units.find(error.key());
  const std::string& text = error.value();
  double value = 0;
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (unit == units.end() || is_pure(unit->second) || bad != std::errc() ||
      end != text.data() + text.size())
    return error;
  const InputError rounded(error.key(), value, error.rule());
  return InputError(error.key(), rounded.value() + " " + unit->second, error.rule());
}

/// The error under the key of the text, with the number of the text.
InputError scaled(const InputError& error, const Document::Given& given) {
  const std::string& text = error.value();
  double value = 0;
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (bad != std::errc() || end != text.data() + text.size())
    return InputError(given.key, text, error.rule());
  return InputError(given.key, value * given.factor, error.rule());
}

/// The error of a number that the text does not have.
InputError missing(const std::string& key, const std::string& unit) {
  const std::string name = key.substr(key.rfind('.') + 1);
  return {key, "", "is missing: add " + name + " = NUMBER" + (is_pure(unit) ? "" : ", in " + unit)};
}

}  // namespace

InputError Document::located(const InputError& unplaced) const {
  if (!unplaced.document().empty()) return unplaced;
  if (const auto other = converted.find(unplaced.key()); other != converted.end())
    return located(scaled(unplaced, other->second));
  const auto unit = known.find(unplaced.key());
  const bool absent = unit != known.end() && !places.contains(unplaced.key()) &&
                      unplaced.value() == "0" &&
                      unplaced.rule().starts_with("must be greater than 0");
  const InputError error =
      absent ? missing(unplaced.key(), unit->second) : with_unit(unplaced, units);
  for (std::string key = error.key();; key.erase(key.find_last_of(".["))) {
    if (const auto it = places.find(key); it != places.end())
      return error.at(name, it->second.line, it->second.column);
    if (key.find_last_of(".[") == std::string::npos) return error.at(name);
  }
}

std::string Document::given_unit(const std::string& key, const std::string& otherwise) const {
  const auto unit = given.find(key);
  return unit == given.end() ? otherwise : unit->second;
}

InputError Document::naming(const std::string& key, const std::string& file,
                            const InputError& error) const {
  const bool unread = error.key().empty() && error.value().empty() && error.line() == 0;
  return unread ? located(InputError(key, file, error.rule())) : error;
}

}  // namespace jounce

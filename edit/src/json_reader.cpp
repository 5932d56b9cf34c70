// SPDX-License-Identifier: Apache-2.0
#include "edit/src/json_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/profiles/error.hpp"

namespace jounce::edit_detail {

using nlohmann::json;

std::string text_of(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json or_null(const std::optional<std::string>& text) {
  return text ? Json(*text) : Json();
}

JsonReader::JsonReader(const char* name, const std::string& text)
    : object_(json::parse(text, nullptr, false)) {
  if (!object_.is_object()) throw InputError(name, "", "must be a JSON object");
}

const json& JsonReader::at(const char* key) const {
  const auto found = object_.find(key);
  if (found == object_.end()) throw InputError(key, "", "is missing");
  return *found;
}

double JsonReader::number(const char* key) const {
  const json& value = at(key);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw InputError(key, value.dump(), "must be a number");
  return value.get<double>();
}

std::optional<double> JsonReader::optional_number(const char* key) const {
  const auto found = object_.find(key);
  if (found == object_.end() || found->is_null()) return std::nullopt;
  return number(key);
}

std::optional<std::array<double, 3>> JsonReader::three_numbers(const char* key) const {
  const json& value = at(key);
  if (value.is_null()) return std::nullopt;
  const auto is_number = [](const json& each) { return each.is_number(); };
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), is_number))
    throw InputError(key, value.dump(), "must be three numbers");
  return value.get<std::array<double, 3>>();
}

std::vector<double> JsonReader::numbers(const char* key) const {
  const json& value = at(key);
  const auto is_number = [](const json& each) { return each.is_number(); };
  if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_number))
    throw InputError(key, value.dump(), "must be a list of numbers");
  return value.get<std::vector<double>>();
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, value] : object_.items()) all.push_back(key);
  return all;
}

std::int64_t JsonReader::whole(const char* key) const {
  const json& value = at(key);
  if (!value.is_number_integer()) throw InputError(key, value.dump(), "must be a whole number");
  return value.get<std::int64_t>();
}

std::size_t JsonReader::index(const char* key, std::size_t least, std::size_t most) const {
  const std::int64_t value = whole(key);
  if (value < 0 || static_cast<std::size_t>(value) < least ||
      static_cast<std::size_t>(value) > most)
    throw InputError(key, std::to_string(value), fmt::format("must be {} to {}", least, most));
  return static_cast<std::size_t>(value);
}

std::string JsonReader::word(const char* key) const {
  const json& value = at(key);
  if (!value.is_string()) throw InputError(key, value.dump(), "must be a string");
  return value.get<std::string>();
}

bool JsonReader::flag(const char* key) const {
  if (!has(key)) return false;
  const json& value = at(key);
  if (!value.is_boolean()) throw InputError(key, value.dump(), "must be true or false");
  return value.get<bool>();
}

std::string JsonReader::object(const char* key) const {
  return at(key).dump();
}

void JsonReader::require_only(const std::vector<std::string>& keys) const {
  for (const auto& [key, value] : object_.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(key, value.dump(),
                       fmt::format("is not a key here: the keys are {}", fmt::join(keys, ", ")));
}

}  // namespace jounce::edit_detail

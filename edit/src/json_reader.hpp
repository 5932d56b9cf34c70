// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace jounce::edit_detail {

using Json = nlohmann::ordered_json;

/// Returns a value as JSON text. Bytes that are not UTF-8 are replaced.
std::string text_of(const Json& value);
/// Returns a text as a value; null for nullopt.
Json or_null(const std::optional<std::string>& text);

/// Reads the members of a JSON object from a request. Getters throw InputError for a missing key
/// and for a value of another type.
class JsonReader {
 public:
  /// Throws InputError (key `name`) if the text is not a JSON object.
  JsonReader(const char* name, const std::string& text);

  [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }
  [[nodiscard]] double number(const char* key) const;
  /// nullopt for null and for a missing key.
  [[nodiscard]] std::optional<double> optional_number(const char* key) const;
  [[nodiscard]] std::optional<std::array<double, 3>> three_numbers(const char* key) const;
  /// A list of numbers of any length.
  [[nodiscard]] std::vector<double> numbers(const char* key) const;
  /// The keys of all members.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// A whole number from `least` to `most`.
  [[nodiscard]] std::size_t index(const char* key, std::size_t least, std::size_t most) const;
  [[nodiscard]] std::int64_t whole(const char* key) const;
  [[nodiscard]] std::string word(const char* key) const;
  /// False if the key is missing.
  [[nodiscard]] bool flag(const char* key) const;
  /// The object under a key, as text.
  [[nodiscard]] std::string object(const char* key) const;
  /// Throws InputError for any other key.
  void require_only(const std::vector<std::string>& keys) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* key) const;

  nlohmann::json object_;
};

}  // namespace jounce::edit_detail

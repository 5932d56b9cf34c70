// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>
#include <string>

#include "jounce/profiles/error.hpp"

/// The error of a call, as text. Each function returns `otherwise` if `act` throws nothing.
namespace jounce::test {

/// The InputError that `act` throws; nullopt if it throws none.
template <class Do>
std::optional<InputError> refusal_of(Do&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error;
  }
  return std::nullopt;
}

/// The text of the InputError: document, line, key, value and rule.
template <class Do>
std::string error_of(Do&& act, const char* otherwise = "") {
  const auto error = refusal_of(act);
  return error ? error->what() : otherwise;
}

/// Its key.
template <class Do>
std::string key_of(Do&& act, const char* otherwise = "") {
  const auto error = refusal_of(act);
  return error ? error->key() : otherwise;
}

/// Its rule.
template <class Do>
std::string rule_of(Do&& act, const char* otherwise = "") {
  const auto error = refusal_of(act);
  return error ? error->rule() : otherwise;
}

/// The text of any exception that `act` throws; "" if it throws none.
template <class Do>
std::string why(Do&& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace jounce::test

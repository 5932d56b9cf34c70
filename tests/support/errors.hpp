// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::testing {

/// What the InputError says that this throws; "nothing is thrown" if none.
template <class Do>
std::string error_of(Do&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing is thrown";
}

/// What any exception of `act` says; "" if it throws none.
template <class Do>
std::string why(Do&& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace jounce::testing

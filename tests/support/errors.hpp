// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce::test {

/// The text of the InputError that `act` throws; "" if it throws none.
template <class Do>
std::string error_of(Do&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
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

#pragma once

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

}  // namespace jounce::testing

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "jounce/base/input_errors.hpp"

namespace jounce::cli {

/// The option for a key of the library: "--velocity-tolerance" for velocity_tolerance,
/// "--resolution" for x_step.
std::string option_of(const std::string& key);

/// The result of `act`. An InputError that it throws gets the name of the option.
template <class Act>
auto under_option(const std::string& option, const Act& act) {
  try {
    return act();
  } catch (const InputError& error) {
    throw InputError(option, error.value(), error.rule());
  }
}

/// The same for errors of these keys only, if they are in no document: each gets the name of its
/// option.
template <class Act>
auto with_option_names(std::initializer_list<std::string_view> keys, const Act& act) {
  try {
    return act();
  } catch (const InputError& error) {
    throw_renamed(error, [&](const std::string& key) {
      const std::string name = key.substr(0, key.find(' '));  // "limit jerk" of the option --limit
      return std::find(keys.begin(), keys.end(), name) == keys.end()
                 ? key
                 : option_of(name) + key.substr(name.size());
    });
  }
}

}  // namespace jounce::cli

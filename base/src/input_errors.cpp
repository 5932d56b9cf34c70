// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/input_errors.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace jounce {

InputErrors::InputErrors(std::vector<InputError> all)
    : InputError(all.front()), all_(std::move(all)) {
  std::stable_sort(all_.begin(), all_.end(), [](const InputError& a, const InputError& b) {
    return std::tuple(a.line(), a.column()) < std::tuple(b.line(), b.column());
  });
}

std::vector<InputError> all_errors(const InputError& error) {
  if (const auto* several = dynamic_cast<const InputErrors*>(&error)) return several->all();
  return {error};
}

}  // namespace jounce

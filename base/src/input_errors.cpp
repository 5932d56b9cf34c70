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

std::string all_sentences(const InputError& error, const std::string& prefix) {
  std::string text;
  for (const InputError& one : all_errors(error))
    text += (text.empty() ? "" : '\n' + prefix) + one.what();
  return text;
}

void throw_renamed(const InputError& error,
                   const std::function<std::string(const std::string& key)>& renamed) {
  std::vector<InputError> all;
  for (const InputError& one : all_errors(error)) {
    const std::string key = one.document().empty() ? renamed(one.key()) : one.key();
    all.push_back(key == one.key() ? one : InputError(key, one.value(), one.rule()));
  }
  if (all.size() == 1) throw InputError(all.front());
  throw InputErrors(std::move(all));
}

}  // namespace jounce

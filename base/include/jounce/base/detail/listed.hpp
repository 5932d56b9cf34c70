// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace jounce {

/// Returns the elements of a list for a message: "x, y, z". `text` returns the text of an element,
/// by default the element itself.
template <class List, class Text = std::identity>
std::string listed(const List& list, Text text = {}) {
  std::string all;
  for (const auto& each : list) {
    if (!all.empty()) all += ", ";
    all += std::invoke(text, each);
  }
  return all;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce::spec_detail {

/// Calls find() with the slave of the spec. An InputError of the whole table gets a key of
/// [follow].
template <class Find>
auto of_follow(const FollowPart& spec, Find find) {
  try {
    return std::visit(find, spec.slave);
  } catch (const InputError& error) {
    const std::string& key = error.key();
    const bool of_all =
        !key.starts_with("segment") && !key.starts_with("point") && !key.starts_with("zone");
    throw InputError((of_all ? "follow." : "") + key, error.value(), error.rule());
  }
}

}  // namespace jounce::spec_detail

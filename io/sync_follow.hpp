#pragma once

#include "jounce/io/spec.hpp"

namespace jounce {

/// What is to be said of a spec of kind "follow" beside its limits: the findings of its tables or of
/// its plan ("follow/..."), and when it begins where it waits for its [master] to pass a place. That
/// master starts from rest at 0. Empty for other kinds.
Report check_follow(const Spec& spec);

}  // namespace jounce

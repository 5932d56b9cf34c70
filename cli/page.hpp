#pragma once

#include "verb.hpp"

namespace jounce::cli {

/// `jounce page`.
void add_page(CommandLine& line);

}  // namespace jounce::cli

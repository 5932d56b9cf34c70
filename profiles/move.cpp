#include "jounce/profiles/move.hpp"

namespace jounce {}

#include "jounce/gear/googol_follow.hpp"

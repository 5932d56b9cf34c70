#include "jounce/optimize/bound.hpp"

#include <gtest/gtest.h>

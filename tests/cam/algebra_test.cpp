#include "jounce/cam/algebra.hpp"

#include <gtest/gtest.h>
TEST(Algebra, Compiles) {}

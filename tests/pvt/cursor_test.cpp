// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/cursor.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace jounce::cursor_test {
namespace {

using test::Random;

Table table_of(Interpolation rule, Extrapolation outside) {
  Random random(6);
  Columns columns;
  double x = -3;
  for (int i = 0; i < 50; ++i, x += random.log_uniform(0.01, 10)) {
    columns.x.push_back(x);
    columns.p.push_back(random.uniform(-1, 1));
    if (rule != Interpolation::linear) columns.v.push_back(random.uniform(-1, 1));
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(random.uniform(-1, 1));
  }
  return {Domain::master, rule, outside, std::move(columns)};
}

TEST(Cursor, AnswersWhatTheTableDoesInWhateverOrder) {
  Random random(7);
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
    for (const Extrapolation outside :
         {Extrapolation::hold, Extrapolation::wrap, Extrapolation::advance}) {
      const Table table = table_of(rule, outside);
      Cursor cursor(table);
      double x = table.start();
      for (int k = 0; k < 20000; ++k) {
        // Mostly a little onwards, now and then anywhere, outside included, or onto a knot.
        x += table.length() * 1e-4;
        const int chance = random.below(50);
        if (chance == 0)
          x = random.uniform(table.start() - table.length(), table.end() + table.length());
        if (chance == 1) x = table.breaks()[static_cast<std::size_t>(random.below(50))];
        ASSERT_EQ(cursor.jet(x), table.jet(x)) << name(rule) << " " << name(outside) << " at " << x;
      }
    }
  }
}

TEST(Cursor, BeginsAnywhere) {
  const Table table = table_of(Interpolation::cubic_hermite, Extrapolation::hold);
  for (const double x : {table.start(), 0.0, table.end(), table.end() + 1, table.start() - 1}) {
    Cursor cursor(table);
    EXPECT_EQ(cursor.jet(x), table.jet(x)) << x;
    Cursor copy = cursor;
    EXPECT_EQ(copy.jet(x), table.jet(x)) << x;
  }
}

}  // namespace
}  // namespace jounce::cursor_test

// SPDX-License-Identifier: Apache-2.0
#include "cam/src/laws/polynomial.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::polynomial_test {
namespace {

TEST(Polynomial, IsTheHermiteQuinticWhereTheSameIsGiven) {
  const std::vector<Condition> conditions{{0, 0, 3},    {0, 1, 0.2},  {0, 2, -0.01},
                                          {75, 0, 100}, {75, 1, 1.5}, {75, 2, 0.03}};
  const Segment f = polynomial(75, conditions);
  const Segment g = quintic(75, 3, 0.2, -0.01, 100, 1.5, 0.03);
  EXPECT_EQ(f.degree, 5);
  for (std::size_t k = 0; k < f.c.size(); ++k) EXPECT_NEAR(f.c[k], g.c[k], 1e-14 * magnitude(g));
}

TEST(Polynomial, RecoversAnyOneFromItsOwnValues) {
  test::Random random(5);
  for (int n = 0; n < 2000; ++n) {
    Segment wanted;
    wanted.length = std::exp(random.uniform(-12, 12));
    const int size = 1 + random.below(12);
    wanted.degree = size - 1;
    for (int k = 0; k < size; ++k) wanted.c[static_cast<std::size_t>(k)] = random.uniform(-1, 1);
    std::vector<Condition> conditions;
    for (int k = 0; k < size; ++k) {  // spread over the segment, values and first derivatives
      const double s = (k + random.uniform(0.2, 0.8)) / size;
      const int order = k % 3 == 1 ? 1 : 0;
      conditions.push_back(
          {s * wanted.length, order, evaluate(wanted, s)[static_cast<std::size_t>(order)]});
    }
    const Segment f = polynomial(wanted.length, conditions);
    for (const Condition& c : conditions) {
      const auto k = static_cast<std::size_t>(c.order);
      const double scale = magnitude(f) * std::pow(wanted.length, -c.order);
      EXPECT_NEAR(evaluate(f, c.at / wanted.length)[k], c.value, 1e-13 * scale) << n;
    }
  }
}

TEST(Polynomial, RejectsWhatHasNoAnswer) {
  const auto complaint = [](const std::vector<Condition>& conditions, double length = 1) {
    return test::key_of([&] { (void)polynomial(length, conditions); }, "no error");
  };
  EXPECT_EQ(complaint({}), "conditions");
  EXPECT_EQ(complaint(std::vector<Condition>(13)), "conditions");
  EXPECT_EQ(complaint({{0, 0, 1}, {0, 0, 2}}), "conditions");
  EXPECT_EQ(complaint({{0, 1, 1}, {1, 1, 2}}), "conditions") << "no position";
  EXPECT_EQ(complaint({{2, 0, 1}}), "at");
  EXPECT_EQ(complaint({{0, 4, 1}}), "order");
  EXPECT_EQ(complaint({{0, 0, std::nan("")}}), "value");
  EXPECT_EQ(complaint({{0, 0, 1}}, 0), "length");
}

}  // namespace
}  // namespace jounce::polynomial_test

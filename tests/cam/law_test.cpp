#include "jounce/cam/law.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/extrema.hpp"

#include "support/invariants.hpp"
#include "support/oracle.hpp"

namespace jounce {
namespace {

using testing::oracle;

struct Case {
  Law law;
  const char* oracle;
  int order;  // continuous up to this derivative
};

class Laws : public ::testing::TestWithParam<Case> {};

TEST_P(Laws, MeetTheOracleInCoefficientsAndPoints) {
  const auto& expected = oracle("laws")["laws"][GetParam().oracle];
  const Cam f(normalised(GetParam().law));
  const Ranges r = extrema(f);
  EXPECT_NEAR(r[1].max.value, expected["cv"].get<double>(), 1e-12);
  EXPECT_NEAR(r[2].max.value, expected["ca"].get<double>(), 1e-12);
  EXPECT_NEAR(-r[2].min.value, expected["ca"].get<double>(), 1e-12) << "point symmetry";
  EXPECT_NEAR(std::abs(r[3].peak().value), expected["cj"].get<double>(), 1e-10);

  const auto& z = oracle("laws")["z"];
  const std::array names{"f", "f1", "f2", "f3"};
  const std::array tolerance{1e-15, 1e-14, 1e-13, 1e-11};
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double at = z[i];
    const Jet jet = f.jet(at, at == 1 ? Side::left : Side::right);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& column = expected[names[k]];
      EXPECT_NEAR(jet[k], column[i].get<double>(), tolerance[k])
          << "derivative " << k << " at " << at;
    }
  }
}

TEST_P(Laws, KeepTheInvariants) {
  testing::expect_invariants(Cam(normalised(GetParam().law)), GetParam().order);
}

TEST_P(Laws, ReachTheBoundOfSevenSegmentsAndNoMore) {
  // 1/Cv + Cv/Ca + Ca/Cj <= 1 for every rest-to-rest law.
  const Ranges r = extrema(Cam(normalised(GetParam().law)));
  const double cv = r[1].max.value;
  const double ca = r[2].max.value;
  const double sum = 1 / cv + cv / ca + ca / std::abs(r[3].peak().value);
  EXPECT_LE(sum, 1);
  EXPECT_NEAR(sum, oracle("laws")["sum_seven_segment"][GetParam().oracle].get<double>(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(RestToRest, Laws,
                         ::testing::Values(Case{Law::poly345, "poly_345", 2},
                                           Case{Law::modified_sine, "modified_sine", 2},
                                           Case{Law::modified_trapezoid, "modified_trapezoid", 2},
                                           Case{Law::inclined_sine, "inclined_sine", 2}),
                         [](const auto& test) { return std::string(test.param.oracle); });

TEST(Scca, OneCodePathYieldsTheWholeFamily) {
  constexpr double pi = std::numbers::pi;
  const auto peak = [](double b, double c, double d, int order) {
    return extrema(Cam(scca(b, c, d)), order).max.value;
  };
  EXPECT_NEAR(peak(0, 1, 0, 2), 4, 1e-14) << "parabola";
  EXPECT_NEAR(peak(0, 0, 1, 2), pi * pi / 2, 1e-14) << "simple sine";
  EXPECT_NEAR(peak(0.5, 0, 0.5, 2), 2 * pi, 1e-14) << "cycloid";
  EXPECT_NEAR(peak(0.25, 0, 0.75, 2), 4 * pi * pi / (4 + pi), 1e-13) << "modified sine";
  EXPECT_NEAR(peak(0.25, 0.5, 0.25, 2), 8 * pi / (2 + pi), 1e-13) << "modified trapezoid";
  for (const double b : {0.0, 0.1, 0.3, 0.5})
    for (const double c : {0.0, 0.2, 0.5}) {
      const double d = 1 - b - c;
      const double ca =
          4 * pi * pi / ((pi * pi - 8) * (b * b - d * d) - 2 * pi * (pi - 2) * b + pi * pi);
      EXPECT_NEAR(peak(b, c, d, 2), ca, 1e-12 * ca) << b << " " << c;
    }
}

TEST(Scca, RefusesSharesThatDoNotAddUp) {
  EXPECT_THROW(scca(0.5, 0.5, 0.5), InputError);
  EXPECT_THROW(scca(-0.5, 1, 0.5), InputError);
}

TEST(LawNames, ReadBack) {
  for (const Law law : all_laws()) EXPECT_EQ(law_named(name(law)), law);
  EXPECT_FALSE(law_named("sinus"));
}

}  // namespace
}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/certificate.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/laws/laws.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace jounce::certificate_test {
namespace {

using test::laws;
using test::oracle;

const Finding* find(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

TEST(Certificates, Law345Is21PercentAboveTheLeastForItsJerk) {
  const Report best = certificates(laws().at("poly_345"));
  const Finding* front = find(best, "bound/acceleration_for_jerk");
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->limit, 15 * (1 - std::sqrt(1 - 32.0 / 60)), 1e-12);
  EXPECT_NEAR(front->margin, 0.2147, 1e-4);
  EXPECT_NEAR(find(best, "bound/square_jerk")->margin, 0, 1e-12) << "3-4-5 attains it";
  EXPECT_NEAR(find(best, "bound/acceleration")->margin, 10 / std::sqrt(3) / 4 - 1, 1e-12);
  EXPECT_EQ(find(best, "bound/jounce"), nullptr) << "its jerk is not zero at the ends";
  for (const Finding& f : best.findings) EXPECT_EQ(f.severity, Severity::note);
}

TEST(Certificates, AreAttainedByTheBest) {
  const auto margin = [](const Cam& law, const char* rule) {
    const Report report = certificates(as_rise(law));
    const Finding* f = find(report, rule);
    return f ? f->margin : -1;
  };
  const auto all = laws();
  EXPECT_NEAR(margin(all.at("quadratic_parabola"), "bound/acceleration"), 0, 1e-12);
  EXPECT_NEAR(margin(all.at("quadratic_parabola"), "bound/duration"), 0, 1e-12);
  EXPECT_NEAR(margin(all.at("minimum_peak_jerk"), "bound/jerk"), 0, 1e-12);
  EXPECT_NEAR(margin(all.at("minimum_peak_jerk"), "bound/acceleration_for_jerk"), 0, 1e-6);
  EXPECT_NEAR(margin(all.at("cubic_23"), "bound/square_acceleration"), 0, 1e-12);
  EXPECT_NEAR(margin(all.at("poly_4567"), "bound/square_jounce"), 0, 1e-12);
  EXPECT_NEAR(margin(Cam({line(1, 0, 1)}), "bound/velocity"), 0, 1e-12);
  EXPECT_NEAR(margin(Cam({line(1, 0, 1)}), "bound/square_velocity"), 0, 1e-12);
}

TEST(Certificates, HaveTheSumsOfTheSevenSegmentBound) {
  for (const auto& [name, sum] : oracle("laws")["sum_seven_segment"].items()) {
    const Report report = certificates(laws().at(name));
    EXPECT_NEAR(find(report, "bound/duration")->value, sum.get<double>(), 1e-12) << name;
  }
}

TEST(Certificates, NeedTheEndsThatTheirProofNeeds) {
  const Report sine = certificates(laws().at("simple_sine"));  // f'' is not zero at its ends
  EXPECT_TRUE(find(sine, "bound/acceleration"));
  EXPECT_FALSE(find(sine, "bound/jerk"));
  EXPECT_EQ(find(sine, "bound/duration")->quantity, "1/Cv + Cv/Ca");
}

TEST(Certificates, FindPiecesThatDoNotJoin) {
  // Two rises of 3, the second 0.5 too high: the position steps, no derivative does.
  const Cam law(normalized(Law::modified_sine));
  const Cam torn = concatenated(scaled(law, 3), shifted(scaled(law, 3), 1, 3.5));
  const Report whole = certificates(as_rise(torn));
  EXPECT_FALSE(whole.ok());
  EXPECT_TRUE(find(whole, "identity/moment")->broken);
  // A law that claims a stroke it does not travel: every bound it breaks is named.
  Cam half = scaled(law, 0.5);
  const Cam claimed = concatenated(half, Cam({line(0.001, 1, 1)}, 1));
  const Report report = certificates(as_rise(claimed));
  EXPECT_TRUE(find(report, "bound/velocity")->broken);
  EXPECT_TRUE(find(report, "bound/acceleration")->broken);
  EXPECT_TRUE(find(report, "bound/power")->broken);
  EXPECT_FALSE(find(report, "bound/power")->advice.empty());
}

/// A random cam of one to three segments: any law with a shape of its own, any scale. Derivatives are
/// left to the laws beside a knot, or given between two laws that take them.
CamSpec random_spec(test::Random& random) {
  std::vector<LawInfo> laws;
  for (const LawInfo& law : all_laws())
    if (has_own_shape(law.law)) laws.push_back(law);
  CamSpec spec;
  const double stroke = random.log_uniform(1e-6, 1e6);
  const double length = random.log_uniform(1e-6, 1e6);
  const int n = 1 + random.below(3);
  double master = random.uniform(-1, 1) * length;
  double slave = random.uniform(-1, 1) * stroke;
  spec.start.master = master;
  spec.start.slave = slave;
  spec.periodic = random.below(2) == 0;
  Ends before = Ends::straight;
  for (int i = 0; i < n; ++i) {
    const LawInfo& law =
        laws[static_cast<std::size_t>(random.below(static_cast<int>(laws.size())))];
    const double step = length * random.log_uniform(0.01, 1);
    if (law.ends == Ends::given && before == Ends::given && random.below(2) == 0) {
      spec.segments.back().end.geo_velocity = random.uniform(-3, 3) * stroke / step;
      spec.segments.back().end.geo_acceleration = random.uniform(-9, 9) * stroke / step / step;
    }
    master += step;
    if (law.ends != Ends::standing) slave += stroke * random.uniform(-1, 1);
    CamSegment segment;
    segment.law = law.law;
    if (law.law == Law::scca) {
      const double b = random.uniform(0, 0.6);
      const double c = random.uniform(0, 0.4);
      segment.form.shares = {b, c, 1 - b - c};
    }
    segment.end.master = master;
    segment.end.slave = slave;
    spec.segments.push_back(segment);
    before = law.ends;
  }
  return spec;
}

std::string written(const std::optional<double>& value) {
  return value ? number(*value) : "-";
}

std::string text(const CamSpec& spec) {
  std::string all = number(spec.start.master) + " " + number(spec.start.slave);
  for (const CamSegment& s : spec.segments)
    all += std::string("; ") + name(s.law) + " " + number(s.end.master) + " " +
           number(s.end.slave) + " " + written(s.end.geo_velocity) + " " +
           written(s.end.geo_acceleration);
  return all + (spec.periodic ? "; periodic" : "");
}

/// The cam, or nothing where the laws do not fit together.
std::optional<Cam> made(const CamSpec& spec) {
  try {
    return design(spec).cam;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TEST(Certificates, HoldForAHundredThousandRandomCams) {
  test::Random random(20);
  std::map<std::string, std::size_t> held;
  std::map<Law, std::size_t> used;
  for (int cams = 0; cams < 100'000 && !HasFailure();) {
    const CamSpec spec = random_spec(random);
    const auto cam = made(spec);
    if (!cam) continue;
    ++cams;
    for (const CamSegment& s : spec.segments) ++used[s.law];
    for (const Finding& f : certificates(*cam).findings) {
      ++held[f.rule.text()];
      EXPECT_FALSE(f.broken) << f.rule << " " << f.quantity << " = " << number(f.value)
                             << ", bound " << number(f.limit) << ": " << text(spec);
    }
  }
  for (const char* rule :
       {"bound/velocity", "bound/acceleration", "bound/jerk", "bound/jounce", "bound/power",
        "bound/duration", "bound/acceleration_for_jerk", "bound/square_velocity",
        "bound/square_acceleration", "bound/square_jerk", "bound/square_jounce",
        "identity/acceleration", "identity/moment"})
    EXPECT_GT(held[rule], 10'000U) << rule;
  for (const LawInfo& law : all_laws())
    if (has_own_shape(law.law)) {
      EXPECT_GT(used[law.law], 1'000U) << law.name;
    }
}

}  // namespace
}  // namespace jounce::certificate_test

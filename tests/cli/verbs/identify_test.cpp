// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::identify_verb_test {
namespace {

using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using IdentifyVerb = cli_test::Program;

TEST_F(IdentifyVerb, FindsTheRecordedInertia) {
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  // A rigid machine without error of following: its torque is inertia times acceleration and friction, and noise beside
  // which the error of following is small: a sum of twelve digits of a generator by Park and Miller.
  constexpr double inertia = 3e-4, friction = 2e-4, turns = 2 * 3.141592653589793, time = 0.3;
  std::string log = "time [s],command [rev],torque [N m]\n";
  std::uint64_t seed = 1;
  for (int i = 0; i <= 300; ++i) {
    const double x = i / 300.0;
    const double v = turns / time * (1 - std::cos(turns * x));
    const double a = turns * turns / time / time * std::sin(turns * x);
    double noise = -6;
    for (int k = 0; k < 12; ++k) {
      seed = seed * 48271 % 2147483647;
      noise += static_cast<double>(seed) / 2147483647;
    }
    log += std::to_string(time * x) + "," + std::to_string(x - std::sin(turns * x) / turns) + "," +
           std::to_string(inertia * a + friction * v + 0.005 * noise) + "\n";
  }
  write("run.csv", log);
  const std::string identify = "identify drive.toml --log run.csv --fit mass[1].inertia";
  const Result found = run(identify + " -o fitted.toml --plot fit.svg --json");
  EXPECT_EQ(found.status, 0) << found.err;
  const json first = json::parse(found.out)["numbers"][0];
  EXPECT_NEAR(first["value"].get<double>(), inertia - 4e-5, 0.01 * inertia);  // less the motor's
  EXPECT_THAT(slurp(folder / "fitted.toml"), HasSubstr("kind = \"drive\""));
  EXPECT_THAT(slurp(folder / "fit.svg"), StartsWith("<svg"));
  EXPECT_EQ(run(identify + " --plot fit.png").status, 0);
  EXPECT_EQ(slurp(folder / "fit.png").substr(1, 3), "PNG");  // not SVG by another name
  EXPECT_THAT(run(identify + " -o drive.toml").err, HasSubstr("is also the input"));
  EXPECT_THAT(run(identify + " -o run.csv").err, HasSubstr("must end in .toml"));
  EXPECT_EQ(run("identify drive.toml --log run.csv --fit mass[1].inertai").status, 2);
}

}  // namespace
}  // namespace jounce::identify_verb_test

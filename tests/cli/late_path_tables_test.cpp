// SPDX-License-Identifier: Apache-2.0
// The tables of a G-code program keep the limits of their axes, also long after its start, where the rounding of a time
// is large beside the shortest phases; and an axis with these limits admits them. The witness computes the jerk from
// the knots, in the longer format of this processor.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/job.hpp"
#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/design/input.hpp"

#include "support/random.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::cli {
namespace {

const std::filesystem::path plate =
    std::filesystem::path(JOUNCE_SOURCE_DIR) / "examples/gcode-part";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The program of the example after a dwell.
std::string delayed(const std::string& seconds) {
  std::string program = text_of(plate / "plate.ngc");
  program.insert(program.find("N50 "), "N45 G4 P" + seconds + "\n");
  return program;
}

/// The greatest magnitude of the third derivative of a quintic table. In an interval of length h, it is
/// (6 c3 + 24 c4 s + 60 c5 s^2) / h^3 with s = 0 .. 1. The values at the end of the interval give c3 to c5.
/// Shorter intervals than `least` do not count.
double greatest_jerk(const Columns& knots, double least) {
  long double greatest = 0;
  for (std::size_t i = 0; i + 1 < knots.x.size(); ++i) {
    const long double h = static_cast<long double>(knots.x[i + 1]) - knots.x[i];
    if (h < least) continue;
    const long double v = knots.v[i] * h, a = knots.a[i] * h * h;
    const long double dp = static_cast<long double>(knots.p[i + 1]) - knots.p[i] - v - a / 2;
    const long double dv = knots.v[i + 1] * h - v - a;
    const long double da = knots.a[i + 1] * h * h - a;
    const long double c3 = 10 * dp - 4 * dv + da / 2;
    const long double c4 = -15 * dp + 7 * dv - da;
    const long double c5 = 6 * dp - 3 * dv + da / 2;
    for (int k = 0; k <= 64; ++k) {
      const long double s = k / 64.0L;
      greatest = std::max(greatest, std::abs(6 * c3 + 24 * c4 * s + 60 * c5 * s * s) / (h * h * h));
    }
  }
  return static_cast<double>(greatest);
}

/// Expects that the tables keep the jerk by the witness, except for `excess` in intervals of at least
/// `least`, s, and that an axis with their limits admits them.
void expect_admitted(const std::vector<Input>& inputs, const std::string& what, double least,
                     double excess) {
  ASSERT_EQ(inputs.size(), 3u);
  for (const Input& input : inputs) {
    const Table& table = input.table.table;
    const double limit = *input.limits.jerk;
    const double jerk = greatest_jerk(table.columns(), least);
    EXPECT_GT(jerk, 0.5 * limit) << input.axis;
    EXPECT_LE(jerk, limit * (1 + excess)) << input.axis << " " << what;
    AxisConfig axis;
    axis.limits = input.limits;
    const Job job(1, std::make_shared<const Table>(table), nullptr);
    const auto refusal = admit(job, axis, table.columns().p.front());
    EXPECT_FALSE(refusal) << input.axis << " " << what << ": " << (refusal ? refusal->value : 0);
    EXPECT_TRUE(check_all(input).ok()) << input.axis << " " << what;
  }
}

TEST(LatePathTables, KeepTheLimitsAndAreAdmitted) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "plate.toml") << text_of(plate / "plate.toml");
  for (const char* const delay : {"0", "60", "3600"}) {
    std::ofstream(folder / "plate.ngc") << delayed(delay);
    expect_admitted(read_inputs((folder / "plate.toml").string()),
                    std::string("after ") + delay + " s", 0, 1e-6);
  }
}

/// A spiral of short lines. The corners are curves of degree 11 over time, in intervals of 20 ms.
std::string spiral(test::Random& random) {
  std::ostringstream program;
  program << "G21 G90 G17 G54 G64 P0.02\nG0 X60 Y40\nG1 Z-1 F600\n";
  const double start = random.uniform(0.5, 3);
  const int lines = 20 + random.below(40);
  for (int i = 0; i < lines; ++i) {
    const double angle = i * random.uniform(0.1, 0.5);
    const double radius = start + 0.05 * i;
    program << "G1 X" << 60 + radius * std::cos(angle) << " Y" << 40 + radius * std::sin(angle)
            << " F2400\n";
  }
  return program.str() + "M30\n";
}

TEST(LatePathTables, OfShortLinesKeepTheLimitsAndAreAdmitted) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "plate.toml") << text_of(plate / "plate.toml");
  test::Random random(27);
  for (int i = 0; i < 12; ++i) {
    std::ofstream(folder / "plate.ngc") << spiral(random);
    expect_admitted(read_inputs((folder / "plate.toml").string()), "of spiral " + std::to_string(i),
                    1e-3, 5e-9);
  }
}

}  // namespace
}  // namespace jounce::cli

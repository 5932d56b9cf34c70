// SPDX-License-Identifier: Apache-2.0
// A finished table is compared with its spec: its curve, all limits, and the version of the spec. The witness computes
// the motion of the table from its knots, by Hermite's formula, at many places.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/base/file.hpp"
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/design/detail/file_check.hpp"
#include "jounce/design/files/file_difference.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"

#include "design/src/input/against_spec.hpp"
#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::against_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double speed = 900;  // deg/s

/// 50 mm by modified sine over 120 deg, a dwell until 200 deg, back until 360 deg.
std::string spec_text(const std::string& limits, const std::string& table = "tolerance = 1e-6") {
  return "jounce = 1\nkind = \"cam\"\nname = \"small\"\nperiodic = true\n"
         "units = { master = \"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 }\n"
         "[[segment]]\nname = \"out\"\nlaw = \"modified_sine\"\nend = { master = 120, slave = 50 "
         "}\n"
         "[[segment]]\nlaw = \"dwell\"\nend = { master = 200, slave = 50 }\n"
         "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 360, slave = 0 }\n"
         "[limits.slave]\n" +
         limits + "\n[master]\nvelocity = 900\n[table]\n" + table + "\n";
}

/// The law of modified sine, and its first two derivatives, for a stroke and a length of 1.
std::vector<double> modified_sine(double s) {
  const double pi = std::acos(-1.0);
  const double c = pi + 4;
  if (s > 0.5) {
    std::vector<double> f = modified_sine(1 - s);
    return {1 - f[0], f[1], -f[2]};
  }
  if (s < 0.125)
    return {(pi * s - std::sin(4 * pi * s) / 4) / c, (pi - pi * std::cos(4 * pi * s)) / c,
            4 * pi * pi * std::sin(4 * pi * s) / c};
  const double at = (pi + 4 * pi * s) / 3;
  return {(2 + pi * s - 9.0 / 4 * std::sin(at)) / c, (pi - 3 * pi * std::cos(at)) / c,
          4 * pi * pi * std::sin(at) / c};
}

/// Knots of the spec above, at equal intervals of each segment: a table of few knots.
Columns few_knots(int intervals) {
  Columns columns;
  const auto add = [&](double x, double p, double v, double a) {
    columns.x.push_back(x);
    columns.p.push_back(p);
    columns.v.push_back(v);
    columns.a.push_back(a);
  };
  for (const auto& [from, length, start, stroke] :
       {std::array{0.0, 120.0, 0.0, 50.0}, {200.0, 160.0, 50.0, -50.0}})
    for (int i = 0; i <= intervals; ++i) {
      const double s = static_cast<double>(i) / intervals;
      const std::vector<double> f = modified_sine(s);
      add(from + s * length, start + stroke * f[0], stroke * f[1] / length,
          stroke * f[2] / (length * length));
    }
  return columns;
}

/// The position and the acceleration (mm, mm/s^2) of the quintic of the knots at x.
std::pair<double, double> played(const Columns& c, double x) {
  std::size_t i = 0;
  while (i + 2 < c.x.size() && c.x[i + 1] <= x) ++i;
  const double h = c.x[i + 1] - c.x[i];
  const double s = (x - c.x[i]) / h;
  const double dp = c.p[i + 1] - c.p[i];
  const double v0 = c.v[i] * h, v1 = c.v[i + 1] * h;
  const double a0 = c.a[i] * h * h, a1 = c.a[i + 1] * h * h;
  const double c3 = 10 * dp - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
  const double c4 = -15 * dp + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
  const double c5 = 6 * dp - 3 * (v0 + v1) - 0.5 * (a0 - a1);
  const double p = c.p[i] + s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))));
  const double a = (a0 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h);
  return {p, a * speed * speed};
}

double spec_position(double x) {
  return x < 120   ? 50 * modified_sine(x / 120)[0]
         : x < 200 ? 50
                   : 50 - 50 * modified_sine((x - 200) / 160)[0];
}

/// The greatest acceleration of a table behind its master, and its greatest distance from the spec.
struct Witness {
  double acceleration = 0, distance = 0;

  explicit Witness(const Columns& columns) {
    constexpr int places = 720'000;
    for (int k = 0; k <= places; ++k) {
      const double x = 360.0 * k / places;
      const auto [p, a] = played(columns, x);
      acceleration = std::max(acceleration, std::abs(a));
      distance = std::max(distance, std::abs(p - spec_position(x)));
    }
  }
};

const Finding* broken(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.broken && f.rule.text() == rule) return &f;
  return nullptr;
}

class Against : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const std::string path = folder_.path() / name;
    write_file(path, text);
    return path;
  }
  /// A table with few knots in the format of TwinCAT, without its comments: without units.
  std::string twincat(const Columns& columns) {
    const Table table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap, columns);
    std::string text = exchange_text(*exchange_format_named("twincat"), {table, {"deg", "mm"}, {}});
    for (auto at = text.find("(*"); at != std::string::npos; at = text.find("(*"))
      text.erase(at, text.find("*)", at) + 2 - at);
    return write("few.twincat", text);
  }
  std::vector<Report> check(const std::string& table, const CheckOptions& options) {
    axes_ = read_inputs(table);
    return check_reports(axes_, options);
  }
  std::vector<Input> axes_;

 private:
  test::TemporaryFolder folder_;
};

TEST_F(Against, TheTableOfAControllerKeepsItsSpecOrShowsTheWitnessNumbers) {
  const std::string spec = write("small.toml", spec_text("acceleration = 15600"));
  const Columns columns = few_knots(5);
  const Witness witness(columns);
  ASSERT_GT(witness.acceleration, 15600);
  const std::string table = twincat(columns);
  const Report report = check(table, {.against = spec}).front();
  const Finding* const limit = broken(report, "limit/acceleration");
  ASSERT_NE(limit, nullptr) << to_json(report, axes_.front().labels);
  EXPECT_NEAR(std::abs(limit->value), witness.acceleration, 1e-6 * witness.acceleration);
  EXPECT_THAT(limit->advice, HasSubstr("jounce convert " + spec + " " + table + " --to twincat"));
  EXPECT_EQ(axes_.front().labels.segment_of(*limit), "1 out");
  const auto position = std::find_if(report.findings.begin(), report.findings.end(),
                                     [](const Finding& f) { return f.rule == "table/position"; });
  ASSERT_NE(position, report.findings.end());
  EXPECT_NEAR(position->value, witness.distance, 1e-6 * witness.distance);
}

TEST_F(Against, ATableWithinItsToleranceKeepsAllLimits) {
  const std::string spec = write("small.toml", spec_text("acceleration = 15600"));
  const Input made = read_inputs(spec).front();
  for (const std::string name : {"fine.csv", "fine.json"}) {
    const std::string table = write(name, table_text(name, made.table));
    EXPECT_TRUE(check(table, {.against = spec}).front().ok()) << name;
  }
  const std::string meters = write("meters.csv", [&] {
    TableFile file = made.table;
    Columns columns = file.table.columns();
    for (auto* column : {&columns.p, &columns.v, &columns.a})
      for (double& value : *column) value *= 1e-3;
    return to_csv({Table(Domain::master, file.table.rule(), file.table.outside(), columns),
                   {"deg", "m"},
                   {}});
  }());
  EXPECT_TRUE(check(meters, {.against = spec}).front().ok());
}

TEST_F(Against, ADeviationBeyondTheToleranceIsBroken) {
  const std::string spec = write("small.toml", spec_text("acceleration = 30000"));
  const Columns columns = few_knots(5);
  const double distance = Witness(columns).distance;
  const Table coarse(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap, columns);
  const std::string table = write("few.csv", to_csv({coarse, {"deg", "mm"}, {}}));
  const Report report = check(table, {.against = spec}).front();
  ASSERT_NE(broken(report, "table/position"), nullptr);
  EXPECT_NEAR(broken(report, "table/position")->limit, 1e-6, 1e-9) << "the tolerance in [table]";
  const auto with = [&](double share) {
    return check(table,
                 {.against = spec, .tolerances = {"position=" + std::to_string(share * distance)}})
        .front()
        .ok();
  };
  EXPECT_FALSE(with(0.9));
  EXPECT_TRUE(with(1.1));
}

TEST_F(Against, TheLimitsOfATableAloneAreBehindAMasterOfAGivenSpeed) {
  const Columns columns = few_knots(5);
  const double peak = Witness(columns).acceleration;
  const Table coarse(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap, columns);
  const std::string table = write("few.csv", to_csv({coarse, {"deg", "mm"}, {}}));
  const auto ok = [&](double limit, const std::string& velocity) {
    const std::string text = "acceleration=" + std::to_string(limit * 1e-3) + " m/s^2";
    return check(table, {.limits = {text}, .start = {.master_velocity = velocity}}).front().ok();
  };
  for (const std::string velocity : {"900", "900 deg/s", "150 rpm", "150 cpm"}) {
    EXPECT_TRUE(ok(1.0001 * peak, velocity)) << velocity;
    EXPECT_FALSE(ok(0.9999 * peak, velocity)) << velocity;
  }
  EXPECT_FALSE(ok(1.0001 * peak, "901"));
  const auto error = [&](const CheckOptions& options) {
    return test::error_of([&] { check(table, options); });
  };
  EXPECT_THAT(error({.limits = {"acceleration=3"}}), HasSubstr("add --master-velocity"));
  EXPECT_THAT(error({.start = {.master_velocity = "900"}}), HasSubstr("or to a limit over time"));
  EXPECT_THAT(error({.limits = {"jerk=0"}, .start = {.master_velocity = "900"}}),
              HasSubstr("must be greater than 0"));
  EXPECT_THAT(error({.limits = {"jerk=1"}, .start = {.master_velocity = "9 mm/s"}}),
              HasSubstr("deg/s"));
}

TEST_F(Against, ATableThatDoesNotBelongToTheSpecIsAnError) {
  const std::string spec = write("small.toml", spec_text("acceleration = 15600"));
  const auto table = [&](double end, const Units& units, Extrapolation outside) {
    return write("t.csv", to_csv({Table(Domain::master, Interpolation::quintic_hermite, outside,
                                        {{0, end}, {0, 0}, {0, 0}, {0, 0}}),
                                  units,
                                  {}}));
  };
  const auto error = [&](const std::string& path, const std::string& against) {
    return test::error_of([&] { check(path, {.against = against}); });
  };
  EXPECT_THAT(error(table(180, {"deg", "mm"}, Extrapolation::wrap), spec),
              HasSubstr("the motion is from 0 to 360 deg"));
  EXPECT_THAT(error(table(360, {"deg", "mm"}, Extrapolation::hold), spec),
              HasSubstr("the motion repeats, and"));
  EXPECT_THAT(error(table(360, {"deg", "rad"}, Extrapolation::wrap), spec),
              HasSubstr("the position is in mm, and in rad of"));
  const std::string right = table(360, {"deg", "mm"}, Extrapolation::wrap);
  EXPECT_THAT(error(right, right), HasSubstr("is a table: give the spec"));
}

TEST_F(Against, OfManyFilesTheTablesOfThisSpecAreCompared) {
  const std::string spec = write("small.toml", spec_text("acceleration = 15600"));
  const std::string other = write("other.toml", spec_text("acceleration = 15700"));
  EXPECT_THAT(test::error_of([&] { check(other, {.against = spec}); }),
              HasSubstr("is a spec, too: leave out --against; `jounce diff` compares two specs"));
  Input made = read_inputs(spec).front();
  const auto compared = [&](const std::string& named) {
    made.table.provenance.spec = named;
    const std::string table = write("t.csv", to_csv(made.table));
    const Report report = check(table, {.against = spec, .selects_tables = true}).front();
    for (const Finding& f : report.findings)
      if (f.rule == "table/position") return true;
    return false;
  };
  EXPECT_TRUE(compared("small.toml"));
  EXPECT_TRUE(compared("cams/small.toml")) << "made in another folder";
  EXPECT_TRUE(compared("")) << "the header names no spec";
  EXPECT_FALSE(compared("other.toml"));
  EXPECT_FALSE(compared("gone.toml"));
  EXPECT_NO_THROW(check(other, {.against = spec, .selects_tables = true})) << "a spec of the run";
}

TEST_F(Against, ATableOlderThanItsSpecIsAWarning) {
  const std::string text = spec_text("acceleration = 15600");
  const std::string spec = write("small.toml", text);
  Input made = read_inputs(spec).front();
  made.table.provenance.spec = "cams/small.toml";  // from another folder
  const std::string table = write("small.csv", to_csv(made.table));
  const auto older = [&] {
    const std::vector<Input> axes = read_inputs(table);
    const Report report = axis_report(axes.front());
    for (const Finding& f : report.findings)
      if (f.rule == "warning/older_table") return f.advice;
    return std::string();
  };
  EXPECT_EQ(older(), "");
  write("small.toml", text + "# a change\n");
  EXPECT_THAT(older(), HasSubstr("jounce design " + spec + " -o " + table));
  EXPECT_THAT(check(table, {.against = spec}).front().warnings(), 0)
      << "the comparison replaces the warning";
  write("small.toml", text);
  EXPECT_EQ(older(), "");
}

TEST_F(Against, ATableHasTheLimitsOfTheSpecInItsHeader) {
  const std::string text = spec_text("acceleration = 15600");
  const std::string spec = write("small.toml", text);
  const std::string table =
      write("small.csv", table_text("small.csv", read_inputs(spec).front().table));
  const auto rules = [&] {
    std::string all;
    const Report report = check(table, {}).front();
    for (const Finding& f : report.findings) all += f.rule.text() + " ";
    return all;
  };
  EXPECT_THAT(rules(), HasSubstr("limit/acceleration"));
  EXPECT_THAT(rules(), testing::Not(HasSubstr("warning/")));
  EXPECT_THAT(rules(), testing::Not(HasSubstr("table/position"))) << "the curve is not compared";
  write("small.toml", text + "# a change\n");
  EXPECT_THAT(rules(), HasSubstr("warning/no_limits")) << "they may be others now";
}

TEST_F(Against, TheAxisOfTheSpecCanBeNamed) {
  const std::string spec =
      write("two.toml",
            "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\", time = \"s\" }\n"
            "[[axis]]\nname = \"x\"\nto = 10\nvelocity = 10\nacceleration = 100\n"
            "[[axis]]\nname = \"y\"\nto = 20\nvelocity = 20\nacceleration = 200\n");
  const std::string table = write("other.csv", table_text("other.csv", read_inputs(spec)[1].table));
  EXPECT_THAT(test::error_of([&] { check(table, {.against = spec}); }),
              HasSubstr("names none of them"));
  EXPECT_THAT(test::error_of([&] { check(table, {.against = spec, .axis = "z"}); }),
              HasSubstr("has no axis z: name one of x, y with --axis"));
  EXPECT_TRUE(check(table, {.against = spec, .axis = "y"}).front().ok());
  EXPECT_FALSE(check(table, {.against = spec, .axis = "x"}).front().ok());
}

TEST_F(Against, TheDifferenceOfTwoSpecsShowsTheirTables) {
  const std::string limits = "acceleration = 15600";
  const std::string fine = write("a.toml", spec_text(limits));
  const std::string coarse =
      write("b.toml", spec_text(limits, "tolerance = 0.01\nknots = \"fewest\""));
  const auto difference = [&](const std::string& tolerance) {
    return file_difference(read_inputs(fine), read_inputs(coarse), fine, coarse,
                           [&](const Labels& labels) { return tolerance_of({tolerance}, labels); });
  };
  EXPECT_FALSE(difference("0").equal());
  const std::size_t before = read_inputs(fine).front().table.table.size();
  const std::size_t after = read_inputs(coarse).front().table.table.size();
  const auto knots = [](std::size_t n) { return std::to_string(n) + " knots"; };
  EXPECT_THAT(to_text(difference("0")), HasSubstr("! [table]: " + knots(before)));
  EXPECT_THAT(to_text(difference("0")), HasSubstr("-> " + knots(after)));
  EXPECT_TRUE(difference("position=0.011").equal());
}

// Far from 0, the rounding of the knots exceeds the limit: the row of the limit was dropped.
TEST_F(Against, ALimitThatIsMetWithinRoundingKeepsItsRow) {
  for (const double from : {0.0, 25'000.0, 720'000.0, -3e6}) {
    const std::string spec =
        write("move.toml",
              "jounce = 1\nkind = \"move\"\nname = \"o\"\nunits = { position = \"mm\" }\n"
              "[move]\nprofile = \"trapezoid\"\nfrom = " +
                  number(from) + "\nto = " + number(from + 0.5) +
                  "\nvelocity = 7.3\nacceleration = 333\n[limits]\nvelocity = 7.3\n"
                  "acceleration = 333\n");
    const Input made = read_inputs(spec).front();
    const std::string table = write("move.csv", to_csv(made.table));
    const std::vector<Report> reports = check(table, {.against = spec});
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_EQ(reports.front().broken(), 0U) << from;
    for (const auto& [rule, limit] :
         {std::pair{"limit/velocity", 7.3}, {"limit/acceleration", 333.0}}) {
      std::size_t rows = 0;
      for (const Finding& f : reports.front().findings) {
        EXPECT_NE(f.rule.text(), "warning/no_limits");
        if (f.rule.text() != rule) continue;
        ++rows;
        EXPECT_NEAR(f.value, limit, 1e-5 * limit) << from;
        EXPECT_EQ(f.limit, limit);
      }
      EXPECT_EQ(rows, 1U) << rule << " from " << from;
    }
  }
}

}  // namespace
}  // namespace jounce::against_test

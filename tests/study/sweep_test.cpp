// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sweep.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/study/detail/sweep_files.hpp"
#include "jounce/study/detail/sweep_summary.hpp"

#include "support/errors.hpp"

namespace jounce::sweep_test {
namespace {

using test::error_of;
using ::testing::HasSubstr;

/// A folder of its own with a spec and a sweep.
class Sweeps : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("sweep_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    write("move.toml", R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "trapezoid"
to = 30
velocity = "10 mm/s"
acceleration = 20
[limits]
velocity = 12.5
)");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    write_file(path(name), text);
  }
  SweepSpec sweep(const std::string& body) const {
    write("sweep.toml", "jounce = 1\nkind = \"sweep\"\nspec = \"move.toml\"\n" + body);
    return read_sweep(path("sweep.toml"));
  }
  std::string refused(const std::string& body) const {
    const std::string what = error_of([&] { (void)sweep(body); });
    const std::string where = path("");
    return what.starts_with(where) ? what.substr(where.size()) : what;
  }

 private:
  std::filesystem::path folder_;
};

const char* const grid = R"(figures = ["duration", "peak velocity"]
[[parameter]]
key = "move.velocity"
values = [5, "0.01 m/s", 15]
[[parameter]]
key = "move.acceleration"
from = 10
to = 40
count = 4
)";

TEST_F(Sweeps, CombineAllListedValues) {
  const SweepSpec spec = sweep(grid);
  ASSERT_EQ(spec.cases(), 12U);
  const SweepResult result = run_sweep(spec);
  ASSERT_TRUE(result.complete);
  ASSERT_EQ(result.rows.size(), 12U);
  std::size_t i = 0;
  for (const double v : {5.0, 10.0, 15.0})
    for (const double a : {10.0, 20.0, 30.0, 40.0}) {
      const SweepRow& row = result.rows[i];
      EXPECT_EQ(row.number, i);
      EXPECT_EQ(spec.numbers(i)[0].value, v);
      EXPECT_EQ(spec.numbers(i)[1].value, a);
      EXPECT_NEAR(row.figures[0], 30 / v + v / a, 1e-12);
      EXPECT_NEAR(row.figures[1], v, 1e-12);
      EXPECT_EQ(row.verdict, v > 12.5 ? Verdict::broken : Verdict::within);
      if (v > 12.5) {
        EXPECT_EQ(row.why, "limit/velocity");
      }
      ++i;
    }
}

const char* const random_two = R"(figures = ["duration"]
[[parameter]]
key = "move.velocity"
normal = { sigma = 0.5 }
[[parameter]]
key = "move.acceleration"
tolerance = "5 %"
[[parameter]]
key = "move.to"
values = [20, 30, 40]
[monte_carlo]
samples = 40
seed = 3
)";

TEST_F(Sweeps, MeetTheSameSamplesInEveryCombination) {
  const SweepSpec spec = sweep(random_two);
  ASSERT_EQ(spec.cases(), 120U);
  std::set<double> drawn;
  for (std::size_t k = 0; k < 40; ++k) {
    const auto numbers = spec.numbers(k);
    drawn.insert(numbers[0].value);
    EXPECT_GT(numbers[1].value, 19);
    EXPECT_LT(numbers[1].value, 21);
    for (const std::size_t combination : {1U, 2U}) {
      const auto same = spec.numbers(k + 40 * combination);
      EXPECT_EQ(same[0].value, numbers[0].value);
      EXPECT_EQ(same[1].value, numbers[1].value);
      EXPECT_EQ(same[2].value, 20 + 10.0 * static_cast<double>(combination));
    }
  }
  EXPECT_EQ(drawn.size(), 40U);
}

/// An even design of N samples has one in each N-th of every parameter's distribution.
TEST_F(Sweeps, FillTheirRangesEvenlyWhereTheyAreAskedTo) {
  for (const std::string design : {"latin_hypercube", "sobol"}) {
    const SweepSpec spec = sweep(R"(figures = ["duration"]
[[parameter]]
key = "move.velocity"
uniform = { from = 8, to = 12 }
[[parameter]]
key = "move.to"
values = [20, 30]
[[parameter]]
key = "move.acceleration"
normal = { sigma = 2 }
[monte_carlo]
samples = 64
design = ")" + design + "\"\n");
    ASSERT_EQ(spec.cases(), 128U);
    std::set<int> uniform, normal;
    for (std::size_t s = 0; s < 64; ++s) {
      const auto numbers = spec.numbers(64 + s);
      EXPECT_EQ(numbers[1].value, 30);
      uniform.insert(static_cast<int>((numbers[0].value - 8) / 4 * 64));
      normal.insert(static_cast<int>(32 * std::erfc((20 - numbers[2].value) / 2 / std::sqrt(2.0))));
      EXPECT_EQ(spec.numbers(s)[0].value,
                numbers[0].value);  // the same samples in every combination
    }
    EXPECT_EQ(uniform.size(), 64U) << design;
    EXPECT_EQ(normal.size(), 64U) << design;
    const SweepResult result = run_sweep(spec);
    const std::string text = summary_text(spec, result, summary_of(spec, result));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("confidence")));  // the samples are not independent
  }
}

/// The fastest trapezoid for a peak velocity: 30 / v + v / a, with the greatest a.
TEST_F(Sweeps, OfOptimaMakeAFrontByConstraints) {
  write("move.toml", R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "trapezoid"
to = 30
velocity = 5
acceleration = 10
[optimize]
minimize = "duration"
[[optimize.parameter]]
key = "move.velocity"
range = [1, 40]
[[optimize.parameter]]
key = "move.acceleration"
range = [5, 20]
[[optimize.require]]
figure = "peak velocity"
at_most = 10
)");
  const SweepSpec spec = sweep(R"(optima = true
figures = ["duration", "peak velocity"]
minimize = ["duration", "peak velocity"]
[[parameter]]
key = "optimize.require[1].at_most"
values = [6, 12, 18]
)");
  const SweepResult result = run_sweep(spec);
  ASSERT_EQ(result.rows.size(), 3U);
  const std::size_t time = column_of(spec, "duration"), v = column_of(spec, "move.velocity");
  EXPECT_EQ(spec.given[v].value, 5);
  for (std::size_t i = 0; i < 3; ++i) {
    const double most = std::array{6.0, 12.0, 18.0}[i];
    const SweepRow& row = result.rows[i];
    ASSERT_EQ(row.verdict, Verdict::within) << row.why;
    EXPECT_NEAR(row.figures[time], 30 / most + most / 20, 2e-5) << most;
    EXPECT_NEAR(row.figures[v], most, 1e-4 * most);
    EXPECT_EQ(row_of(line_of(row), spec)->figures, row.figures);
  }
  EXPECT_EQ(summary_of(spec, result).front.size(), 3U);
}

TEST_F(Sweeps, OfOptimaHaveARowForWhatHasNone) {
  write("move.toml", R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "trapezoid"
to = 30
velocity = 5
acceleration = 10
[optimize]
minimize = "peak velocity"
max_evaluations = 100
[[optimize.parameter]]
key = "move.velocity"
range = [1, 40]
[[optimize.require]]
figure = "duration"
at_most = 8
)");
  const SweepSpec spec = sweep(R"(optima = true
figures = ["peak velocity"]
[[parameter]]
key = "optimize.require[1].at_most"
values = [0.1, 8]
)");
  const SweepResult result = run_sweep(spec);
  EXPECT_EQ(result.rows[0].verdict, Verdict::impossible);
  EXPECT_THAT(result.rows[0].why, HasSubstr("infeasible"));
  EXPECT_EQ(result.rows[1].verdict, Verdict::within) << result.rows[1].why;
}

TEST_F(Sweeps, GiveTheSameBytesOnAnyNumberOfThreads) {
  const SweepSpec spec = sweep(random_two);
  const SweepResult one = run_sweep(spec, {.farm = on_threads(1)});
  EXPECT_EQ(one.evaluated, 120U);
  for (const unsigned jobs : {2U, 7U}) {
    const SweepResult many = run_sweep(spec, {.farm = on_threads(jobs)});
    EXPECT_EQ(to_csv(spec, one), to_csv(spec, many));
    EXPECT_EQ(to_npy(spec, one), to_npy(spec, many));
  }
}

TEST_F(Sweeps, ContinueWhereTheyWereStopped) {
  const SweepSpec spec = sweep(random_two);
  const std::string whole = to_csv(spec, run_sweep(spec));
  const std::string journal = path("results.csv.journal");
  std::size_t done = 0;
  std::size_t made = 0;
  for (int run = 0; run < 100; ++run) {
    const SweepResult part = run_sweep(
        spec, {.farm = on_threads(2), .journal = journal, .keep_going = [&](auto n, auto) {
                 return n < done + 25;
               }});
    EXPECT_EQ(part.resumed, done);
    EXPECT_EQ(part.rows.size(), part.resumed + part.evaluated);
    done = part.rows.size();
    made += part.evaluated;
    if (!part.complete) continue;
    EXPECT_EQ(to_csv(spec, part), whole);
    break;
  }
  EXPECT_EQ(made, 120U);  // nothing lost, nothing twice
}

TEST_F(Sweeps, RejectAJournalOfAnotherSpec) {
  const std::string journal = path("j");
  const auto part = [&](const SweepSpec& spec) {
    return run_sweep(spec, {.farm = on_threads(1),
                            .journal = journal,
                            .keep_going = [](auto, auto) { return false; }});
  };
  (void)part(sweep(grid));
  EXPECT_THAT(error_of([&] { part(sweep(std::string("# another\n") + grid)); }),
              HasSubstr("belongs to another sweep, spec or version"));
  EXPECT_EQ(part(sweep(grid)).resumed, 1U);
}

TEST_F(Sweeps, HaveARowForWhatIsImpossible) {
  const SweepSpec spec = sweep(R"([[parameter]]
key = "move.acceleration"
values = [20, -1, 0]
)");
  const SweepResult result = run_sweep(spec);
  ASSERT_EQ(result.rows.size(), 3U);
  EXPECT_EQ(result.rows[0].verdict, Verdict::within);
  EXPECT_EQ(result.rows[1].verdict, Verdict::impossible);
  EXPECT_EQ(result.rows[1].why, "move.acceleration = -1 mm/s^2: must be greater than 0");
  EXPECT_TRUE(std::isnan(result.rows[2].figures[0]));
  const std::string csv = to_csv(spec, result);
  EXPECT_THAT(csv, HasSubstr("\n2,-1,,,"));
  EXPECT_THAT(csv,
              HasSubstr(",impossible,move.acceleration = -1 mm/s^2: must be greater than 0\n"));
  EXPECT_EQ(summary_of(spec, result).impossible, 2U);
}

TEST_F(Sweeps, GoThroughTheirLines) {
  const SweepSpec spec = sweep(grid);
  for (const SweepRow& row : run_sweep(spec).rows) {
    const auto back = row_of(line_of(row), spec);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->figures, row.figures);
    EXPECT_EQ(line_of(*back), line_of(row));
  }
  for (const char* line :
       {"", "1", "1 0 2 3", "12 0 1 2 3 ", "1 3 1 2 3 ", "-1 0 1 2 3 ", "1 0 1 2 x "})
    EXPECT_FALSE(row_of(line, spec)) << line;
  EXPECT_TRUE(row_of("1 2 nan nan nan the reason", spec));
}

TEST_F(Sweeps, EndWithWhatAThreadThrows) {
  std::atomic<int> taken{0};
  EXPECT_THROW(on_threads(3)(
                   {0, 1, 2, 3, 4, 5, 6, 7},
                   [](std::size_t k) -> std::string {
                     if (k == 4) throw std::bad_alloc();
                     return "";
                   },
                   [&](std::size_t, const std::string&) {
                     ++taken;
                     return true;
                   }),
               std::bad_alloc);
  EXPECT_LE(taken, 7);
}

TEST_F(Sweeps, FindTheParetoFrontAmongThoseWithinLimits) {
  const SweepSpec spec =
      sweep(std::string("minimize = [\"duration\", \"peak acceleration\"]\n") + grid);
  const SweepResult result = run_sweep(spec);
  const SweepSummary summary = summary_of(spec, result);
  // 10 mm/s is faster than 5 at every acceleration, and 15 breaks the limit.
  std::vector<std::size_t> numbers;
  for (const std::size_t i : summary.front) numbers.push_back(result.rows[i].number);
  EXPECT_THAT(numbers, ::testing::ElementsAre(7, 6, 5, 4));
  EXPECT_EQ(summary.within, 8U);
  EXPECT_EQ(summary.broken, 4U);
}

TEST_F(Sweeps, AreSummedUp) {
  const SweepSpec spec = sweep(R"(figures = ["peak velocity"]
[[parameter]]
key = "move.velocity"
values = [2, 8, 4, 6]
[limits]
"peak velocity" = 7
)");
  const SweepResult result = run_sweep(spec);
  const FigureSpread f = summary_of(spec, result).figures[0];
  EXPECT_NEAR(f.least, 2, 1e-12);
  EXPECT_NEAR(f.median, 5, 1e-12);
  EXPECT_NEAR(f.greatest, 8, 1e-12);
  EXPECT_NEAR(f.mean, 5, 1e-12);
  EXPECT_NEAR(f.deviation, std::sqrt(20.0 / 3), 1e-12);
  EXPECT_EQ(f.greatest_case, 1U);
  EXPECT_EQ(f.limit, 7);
  EXPECT_EQ(result.rows[1].why, "peak velocity above 7");
  EXPECT_THAT(summary_text(spec, result, summary_of(spec, result)),
              HasSubstr("4 cases; 3 within all limits, 1 beyond a limit"));
}

// The margin was "inf", with a median and a deviation of "-nan".
TEST_F(Sweeps, WithoutLimitsHaveNoMargin) {
  write("move.toml",
        "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
        "profile = \"trapezoid\"\nto = 30\nvelocity = 10\nacceleration = 20\n");
  const SweepSpec spec = sweep(
      "figures = [\"duration\"]\n[[parameter]]\nkey = \"move.velocity\"\nvalues = [2, 8, 4, 6]\n");
  const SweepResult result = run_sweep(spec);
  const SweepSummary summary = summary_of(spec, result);
  for (const FigureSpread& f : summary.figures) {
    EXPECT_FALSE(std::isnan(f.median)) << f.given.name;
    EXPECT_FALSE(std::isnan(f.deviation)) << f.given.name;
  }
  const std::string text = summary_text(spec, result, summary);
  EXPECT_THAT(text, HasSubstr("duration"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("margin")));
}

TEST(Share, IsWilsons) {
  const Share none = share_of(0, 10);  // z^2 / (n + z^2)
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 3.8414588206941227 / 13.841458820694123, 1e-15);
  const Share half = share_of(50, 100);
  EXPECT_NEAR(half.low, 0.4038315, 1e-7);  // R: prop.test(50, 100, correct = FALSE)
  EXPECT_NEAR(half.high, 0.5961685, 1e-7);
  EXPECT_EQ(share_of(7, 7).high, 1);
}

TEST_F(Sweeps, AreForNumPyToo) {
  const SweepSpec spec = sweep(grid);
  const std::string npy = to_npy(spec, run_sweep(spec));
  ASSERT_TRUE(npy.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
  const std::size_t head =
      static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
  EXPECT_EQ((head + 10) % 64, 0U);
  EXPECT_EQ(npy.size(), 10 + head + 12 * 8 * 7);
  EXPECT_THAT(npy.substr(10, head),
              HasSubstr("{'descr': [('case', '<i8'), ('move.velocity', '<f8'), "
                        "('move.acceleration', '<f8'), ('duration', '<f8'), ('peak velocity', "
                        "'<f8'), ('margin', '<f8'), ('verdict', '<i8')], 'fortran_order': False, "
                        "'shape': (12,), }"));
  double duration = 0;
  std::memcpy(&duration, npy.data() + 10 + head + 3 * 8, 8);
  EXPECT_NEAR(duration, 6.5, 1e-12);
}

TEST_F(Sweeps, RejectWhatMakesNoSense) {
  const std::string one = "[[parameter]]\nkey = \"move.velocity\"\n";
  try {
    (void)parse_sweep("jounce = 1\nkind = \"sweep\"\nbase = \"move.toml\"\n" + one, "s.toml");
    FAIL();
  } catch (const InputErrors& errors) {
    ASSERT_EQ(errors.all().size(), 2U);
    EXPECT_THAT(errors.all()[0].what(), HasSubstr("spec: is missing: add spec = \"FILE.toml\""));
    EXPECT_THAT(errors.all()[1].what(),
                HasSubstr("s.toml:3:1: base = \"move.toml\": is not a key"));
  }
  EXPECT_EQ(refused(""),
            "sweep.toml: parameter: is missing: add [[parameter]] with key and values for each "
            "number to vary");
  EXPECT_EQ(refused("[[parameter]]\nkey = \"move.velocty\"\nvalues = [1]\n"),
            "sweep.toml:5:7: parameter[1].key = \"move.velocty\": names no number in " +
                path("move.toml") + ": did you mean move.velocity?");
  EXPECT_THAT(refused(one),
              HasSubstr("needs exactly one of the keys values, from (with to and count)"));
  EXPECT_THAT(refused(one + "values = []\n"), HasSubstr("is empty: give at least one value"));
  EXPECT_THAT(refused(one + "values = [nan]\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(refused(one + "values = [\"1 deg\"]\n"),
              HasSubstr("deg is not a unit of this quantity"));
  EXPECT_THAT(refused("[[parameter]]\nkey = \"move.to\"\nvalues = [\"1 mm\"]\n"),
              HasSubstr("mm is not a unit of this quantity: give the value without a unit"));
  EXPECT_THAT(refused(one + "from = 1\nto = 2\n"), HasSubstr("count: is missing"));
  const auto both = [&](const std::string& body) {
    std::string all;
    try {
      (void)sweep(body);
    } catch (const InputErrors& errors) {
      for (const InputError& each : errors.all()) all += each.key() + ' ' + each.rule() + '\n';
    }
    return all;
  };
  EXPECT_THAT(both(one + "from = 1\nto = 2\nsteps = 5\n"),
              ::testing::AllOf(HasSubstr("steps is not a key here: did you mean count?"),
                               HasSubstr("parameter[1].count is missing")));
  EXPECT_THAT(both(one + "from = 1\nto = 2\nwidth = 5\n"),
              ::testing::AllOf(HasSubstr("parameter[1].width is not a key here; possible keys: "),
                               HasSubstr("parameter[1].count is missing")));
  EXPECT_THAT(both(one + "tolerance = 0.05\n[monte_carlo]\nruns = 100\nseed = 1\n"),
              ::testing::AllOf(HasSubstr("runs is not a key here: did you mean samples?"),
                               HasSubstr("monte_carlo.samples is missing")));
  EXPECT_THAT(refused(one + "from = 1\nto = 2\ncount = 1\n"), HasSubstr("must be at least 2"));
  EXPECT_THAT(refused(one + "from = 2\nto = 2\ncount = 25\n"),
              HasSubstr("to = 2 mm/s: must differ from from"));
  EXPECT_THAT(
      refused("minimize = [\"stroke\"]\nmaximize = [\"stroke\"]\n" + one + "values = [1]\n"),
      HasSubstr("maximize = \"stroke\": is an objective already"));
  EXPECT_THAT(refused(one + "from = 1\nto = 2\ncount = 99999999\n"),
              HasSubstr("more than 10000000 cases"));
  EXPECT_THAT(refused(one + "tolerance = \"5 %\"\n"), HasSubstr("monte_carlo: is missing"));
  EXPECT_THAT(refused(one + "tolerance = \"5 mm\"\n[monte_carlo]\nsamples = 2\n"),
              HasSubstr("must be a share such as \"5 %\""));
  EXPECT_THAT(refused(one + "tolerance = -0.1\n[monte_carlo]\nsamples = 2\n"),
              HasSubstr("must be a share such as"));
  EXPECT_THAT(refused(one + "values = [1]\n[monte_carlo]\nsamples = 2\n"),
              HasSubstr("needs a parameter with"));
  EXPECT_THAT(refused(one + "normal = { sigma = 0 }\n[monte_carlo]\nsamples = 2\n"),
              HasSubstr("must be greater than 0"));
  EXPECT_THAT(refused(one + "uniform = { from = 2, to = 1 }\n[monte_carlo]\nsamples = 2\n"),
              HasSubstr("must be greater than from, 2"));
  EXPECT_THAT(refused(one + "values = [1]\n" + one + "values = [1]\n"),
              HasSubstr("is given twice"));
  EXPECT_THAT(refused(one + "values = [1]\nvalue = 3\n"), HasSubstr("is not a key here"));
  EXPECT_THAT(
      error_of([&] { (void)read_sweep(path("move.toml")); }),
      HasSubstr("move.toml:2:8: kind = \"move\": must be \"sweep\": write a second spec with "
                "kind = \"sweep\", a [[parameter]], and spec = \"move.toml\""));
  EXPECT_THAT(
      refused("figures = [\"peak torque\"]\n" + one + "values = [1]\n"),
      HasSubstr("sweep.toml:4:11: figures = \"peak torque\": must be one of stroke, knots"));
  EXPECT_THAT(refused("minimize = [\"peak velocit\"]\n" + one + "values = [1]\n"),
              HasSubstr("did you mean \"peak velocity\"?"));
  EXPECT_THAT(refused(one + "values = [1]\n[limits]\n\"peak speed\" = 1\n"),
              HasSubstr("limits = \"peak speed\": must be one of"));
  EXPECT_THAT(
      refused(one + "tolerance = 0.1\n[monte_carlo]\nsamples = 2\ndesign = \"grid\"\n"),
      HasSubstr("monte_carlo.design = \"grid\": must be one of random, latin_hypercube, sobol"));
  EXPECT_THAT(refused("optima = true\n" + one + "values = [1]\n"),
              HasSubstr("optima = true: needs a spec with [[optimize.parameter]]"));
}

TEST_F(Sweeps, WriteTheirFilesAndNameTheJournal) {
  const SweepSpec spec = sweep(grid);
  const SweepResult result = run_sweep(spec);
  const SweepFiles files{.csv = path("all.csv"), .npy = path("all.npy")};
  write_sweep(files, spec, result);
  EXPECT_EQ(read_file(files.csv), to_csv(spec, result));
  EXPECT_EQ(std::filesystem::file_size(files.npy), to_npy(spec, result).size());
  EXPECT_EQ(files.journal(), path("all.csv.journal"));
  EXPECT_EQ((SweepFiles{.csv = "-", .npy = "all.npy"}.journal()), "all.npy.journal");
  EXPECT_EQ(SweepFiles{}.journal(), "");
  const SweepResult part{.rows = {result.rows.front()}, .evaluated = 1};
  EXPECT_EQ(stopped_text({.csv = "a.csv"}, spec, part),
            "stopped after 1 of 12 cases; continue with the same command (a.csv.journal)");
  EXPECT_EQ(stopped_text({}, spec, part),
            "stopped after 1 of 12 cases; with -o, the same command would continue from there");
}

}  // namespace
}  // namespace jounce::sweep_test

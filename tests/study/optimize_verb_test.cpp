// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/base/file.hpp"
#include "jounce/design/make.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "../support/random.hpp"

// The program itself: what `jounce optimize` writes is what `jounce check` finds right.

namespace jounce::optimize_verb_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

struct Ran {
  int status = 0;
  std::string output;  ///< both streams
};

class OptimizeVerb : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(::testing::TempDir()) / ("optimize_verb_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Ran jounce(const std::string& words) const {
    const std::string command = "cd " + folder_.string() + " && " JOUNCE_EXE " " + words + " 2>&1";
    Ran ran;
    std::FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe))
      ran.output.append(buffer, n);
    const int status = pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
  }

  /// Optimizes a file beside this test, by its name.
  Ran optimized(const std::string& name, const std::string& options = "") const {
    return jounce("optimize " JOUNCE_SOURCE_DIR "/tests/study/optimize/" + name +
                  ".toml -o out.toml " + options);
  }

  /// The outcome for machines; what was written passes `jounce check`.
  Json outcome(const std::string& name, const std::string& options = "") const {
    const Ran ran = optimized(name, "--json " + options);
    EXPECT_EQ(ran.status, 0) << name << ": " << ran.output;
    expect_checked(name);
    return Json::parse(ran.output, nullptr, false);
  }

  void expect_checked(const std::string& what) const {
    const Ran ran = jounce("check out.toml");
    EXPECT_EQ(ran.status, 0) << what << ": " << ran.output;
  }

  static double reached(const Json& outcome, std::size_t figure = 0) {
    return outcome["runs"][0]["figures"][figure]["reached"].get<double>();
  }

  std::filesystem::path folder_;
};

// ---- searches over [[optimize.parameter]] -------------------------------------------------------

TEST_F(OptimizeVerb, BringsTimesAndVelocitiesOfAPvtTableToTheirOptimum) {
  // Independent: 12 runs of SLSQP over all four segments' peaks from random starts end at 2.2109.
  const Json found = outcome("search-false-convergence");
  EXPECT_EQ(found["status"], "converged");
  EXPECT_NEAR(found["figures"][0]["reached"].get<double>(), 2.2109, 2e-4);
}

// ---- free shapes --------------------------------------------------------------------------------

TEST_F(OptimizeVerb, MinimisesASecondFigureBesideAnRms) {
  const Json found = outcome("lexicographic-rms-first");
  EXPECT_NE(found["status"], "stalled") << found["reason"];
  EXPECT_LE(reached(found), 0.0121277 * (1 + 1e-5)) << "0.1 % above the least alone, 0.0121156";
  EXPECT_LE(reached(found, 1), 0.8 * 0.0335626) << "of the shape with the least rms";
}

TEST_F(OptimizeVerb, ForgivesWhatASolverLeaves) {
  EXPECT_EQ(outcome("monotone")["status"], "optimal");
  EXPECT_EQ(outcome("through-points")["status"], "optimal");
}

TEST_F(OptimizeVerb, JudgesWhatItDoesNotChange) {
  const Ran ran = optimized("slave-limit-shape");
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.output, HasSubstr("limit/master_velocity"));
  EXPECT_FALSE(std::filesystem::exists(path("out.toml")));
}

TEST_F(OptimizeVerb, WritesADwellThatItCanRead) {
  (void)outcome("last-dwell");
}

TEST_F(OptimizeVerb, ListsTheJerkThatTheLawAtItsPlaceKeeps) {
  const Json free = outcome("placeholder-law-345");
  const Ran kept = optimized("placeholder-law-4567");
  EXPECT_EQ(kept.status, 0);
  EXPECT_THAT(kept.output,
              HasSubstr("geo_jerk is kept at 0 at 0 deg (segment 1 x) and at 0 at 360 deg "
                        "(segment 1 x): free.ends = { jerk = \"free\" }"));
  std::string text = read_file(JOUNCE_SOURCE_DIR "/tests/study/optimize/placeholder-law-4567.toml");
  const std::string shape = "free = { shape = 24 }";
  const auto with = [&](const std::string& ends) {
    std::string other = text;
    write_file(path("ends.toml"),
               other.replace(other.find(shape), shape.size(),
                             "free = { shape = 24, ends = { jerk = " + ends + " } }"));
    const Ran ran = jounce("optimize ends.toml --json");
    EXPECT_EQ(ran.status, 0) << ran.output;
    return reached(Json::parse(ran.output, nullptr, false));
  };
  EXPECT_NEAR(with("\"free\""), reached(free), 2e-6 * reached(free));
  EXPECT_GT(with("0"), reached(free) * 1.05);
}

TEST_F(OptimizeVerb, LabelsEveryFigureWithItsOwnNumber) {
  const Json found = outcome("mislabelled");
  const Json& figures = found["runs"][0]["figures"];
  EXPECT_EQ(figures[1]["figure"], "peak geo_jerk");
  EXPECT_NEAR(figures[1]["given"].get<double>(), 60 * 50 / 120.0 / 120 / 120, 1e-9)
      << "of the law 345";
  EXPECT_EQ(figures[2]["figure"], "peak geo_velocity");
  EXPECT_NEAR(figures[2]["given"].get<double>(), 1.875 * 50 / 120, 1e-9);
  EXPECT_LE(figures[2]["reached"].get<double>(), 0.7);
}

/// Processor time of a program that optimizes a shape of 2000 pieces, and that `signal` interrupts after a
/// second, if it is one. s
double processor_seconds(const std::string& folder, const char* seconds, int signal) {
  const std::string spec = JOUNCE_SOURCE_DIR "/tests/study/optimize/ctrl-c-2000.toml";
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) != 0 || freopen("ended.txt", "w", stdout) == nullptr) _exit(99);
    execl(JOUNCE_EXE, "jounce", "optimize", spec.c_str(), "-o", "out.toml", "--seconds", seconds,
          static_cast<char*>(nullptr));
    _exit(99);
  }
  if (signal != 0) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    kill(child, signal);
  }
  int status = 0;
  rusage used{};
  EXPECT_EQ(wait4(child, &status, 0, &used), child);
  EXPECT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 1);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

// It took 9 to 31 s more: a factorisation that exchanges rows cannot be interrupted.
TEST_F(OptimizeVerb, EndsAShapeOf2000PiecesInTime) {
  EXPECT_LT(processor_seconds(folder_.string(), "3", 0), 3 + 2.5);
  EXPECT_THAT(read_file(path("ended.txt")), HasSubstr("s is reached"));
}

TEST_F(OptimizeVerb, EndsAShapeOf2000PiecesWhenItIsInterrupted) {
  EXPECT_LT(processor_seconds(folder_.string(), "60", SIGINT), 1 + 2.5);
  EXPECT_THAT(read_file(path("ended.txt")), HasSubstr("cancelled: stopped by the caller"));
  EXPECT_FALSE(std::filesystem::exists(path("out.toml")));
}

/// Greatest third derivative of the quintics between the knots of a table: at the ends of each and in the
/// middle of the parabola that it is.
double greatest_jerk(const Table& table) {
  const Columns& c = table.columns();
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < c.x.size(); ++i) {
    const double h = c.x[i + 1] - c.x[i];
    const double p = c.p[i + 1] - c.p[i] - h * (c.v[i] + h * c.a[i] / 2);
    const double v = (c.v[i + 1] - c.v[i] - h * c.a[i]) * h;
    const double a = (c.a[i + 1] - c.a[i]) * h * h;
    const double c3 = 10 * p - 4 * v + a / 2, c4 = -15 * p + 7 * v - a, c5 = 6 * p - 3 * v + a / 2;
    const auto jerk = [&](double s) {
      return (6 * c3 + s * (24 * c4 + s * 60 * c5)) / (h * h * h);
    };
    greatest = std::max({greatest, std::abs(jerk(0)), std::abs(jerk(1))});
    if (const double s = -c4 / (5 * c5); s > 0 && s < 1)
      greatest = std::max(greatest, std::abs(jerk(s)));
  }
  return greatest;
}

TEST_F(OptimizeVerb, WritesATableThatKeepsTheJerk) {
  const Ran ran = optimized("table-jerk", "--table out.csv");
  EXPECT_EQ(ran.status, 0) << ran.output;
  expect_checked("table-jerk");
  const Table table = read_table(path("out.csv")).table;
  ASSERT_EQ(table.rule(), Interpolation::quintic_hermite);
  EXPECT_LE(greatest_jerk(table), 0.001334 * (1 + 1e-9));
}

TEST_F(OptimizeVerb, ReportsAViolationInFull) {
  const Ran ran = optimized("clipped-percent");
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.output, AllOf(HasSubstr("exceeds the limit 0.0003 "), HasSubstr(" by 900 %")));
  EXPECT_THAT(ran.output, Not(HasSubstr("by 100 %")));
}

// ---- free knots ---------------------------------------------------------------------------------

TEST_F(OptimizeVerb, KeepsTheLimitsOfTheSlaveAtFreeKnots) {
  const Ran ran = optimized("slave-limit-knots");  // 150 mm/s behind 480 deg/s
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.output, HasSubstr("the limit 0.3125"));
}

TEST_F(OptimizeVerb, KeepsTheLimitsOfTheSlaveWhileTheMasterAccelerates) {
  const Ran ran = optimized("slave-limit-ramp");  // without the ramp the optimum breaks the limit
  EXPECT_EQ(ran.status, 0) << ran.output;
  EXPECT_THAT(ran.output,
              HasSubstr("geo_acceleration while the master accelerates reaches its limit"));
  expect_checked("slave-limit-ramp");
}

TEST_F(OptimizeVerb, WritesNumbersThatTomlCanRead) {
  const Ran ran = optimized("big-numbers");
  EXPECT_EQ(ran.status, 0) << ran.output;
  expect_checked("big-numbers");
}

TEST_F(OptimizeVerb, EndsASearchOverKnotsInTime) {
  const Ran ran = optimized("knots-no-budget", "--seconds 1");
  EXPECT_EQ(ran.status, 0) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("stalled: the time limit of 1 s is reached"));
  expect_checked("knots-no-budget");
}

/// A free shape begins at the end of its range, where the slave still moves outwards.
TEST_F(OptimizeVerb, ARangeThatEndsInMotionIsOneRowWithItsCause) {
  std::ofstream(path("range.toml"))
      << "jounce = 1\nkind = \"cam\"\nperiodic = true\n"
         "units = { master = \"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 }\n"
         "[[segment]]\nlaw = \"345\"\nend = { master = 170, slave = 80, geo_velocity = 0.1 }\n"
         "[[segment]]\nlaw = \"line\"\nend = { master = 200, slave = 83 }\n"
         "[[segment]]\nlaw = \"quintic\"\nfree = { shape = 20 }\n"
         "end = { master = 360, slave = 0 }\n"
         "[limits]\nposition_min = 0\nposition_max = 83\n"
         "[limits.slave]\njerk = \"9000 m/s^3\"\n[master]\nvelocity = \"150 rpm\"\n"
         "[optimize]\nminimize = [\"peak jerk\"]\n";
  const Ran ran = jounce("optimize range.toml -o better.toml");
  EXPECT_EQ(ran.status, 1) << ran.output;
  const std::string row = "BROKEN limit/position_max";
  const auto first = ran.output.find(row);
  ASSERT_NE(first, std::string::npos) << ran.output;
  EXPECT_EQ(ran.output.find(row, first + 1), std::string::npos) << ran.output;
  EXPECT_THAT(
      ran.output,
      HasSubstr("the range ends where the slave still moves outwards: at 200 deg it is at the "
                "limit 83 mm and has geo_velocity 0.1 mm/deg"));
  EXPECT_THAT(ran.output, Not(HasSubstr("mm/s^3"))) << "the unit of the spec is m/s^3";
}

// ---- any spec -----------------------------------------------------------------------------------

/// A cam with some freedom, some limits and one or two objectives.
class AnySpec {
 public:
  explicit AnySpec(std::uint64_t seed) : random_(seed) {}

  std::string text(bool of_knots) {
    const bool periodic = random_.below(2) == 0;
    const int segments = 2 + random_.below(2);
    std::string all = std::string("jounce = 1\nkind = \"cam\"\n") +
                      (periodic ? "periodic = true\n" : "") +
                      "units = { master = \"deg\", position = \"mm\" }\n"
                      "start = { master = 0, slave = 0 }\n";
    for (int i = 0; i < segments; ++i) all += segment(i, segments, periodic, of_knots);
    all += "[master]\nvelocity = 480\ndistance = 720\n" + acceleration() + limits();
    return all + "[optimize]\nminimize = [" + figures(of_knots) + "]\n";
  }

 private:
  std::string segment(int i, int segments, bool periodic, bool of_knots) {
    const bool last = i + 1 == segments;
    const double end = last ? 360 : 360.0 * (i + random_.uniform(0.7, 1.2)) / segments;
    const double slave = last && periodic ? 0 : random_.uniform(-60, 60);
    const std::string at =
        "end = { master = " + number(end) + ", slave = " + number(slave) + " }\n";
    if (of_knots) {
      const std::string free =
          last ? ""
               : "free = { geo_velocity = [-3, 3], geo_acceleration = [-0.5, 0.5]" +
                     sometimes(", slave", slave, 20) + sometimes(", master", end, 25) + " }\n";
      return "[[segment]]\nlaw = \"quintic\"\n" + at + free;
    }
    constexpr const char* laws[] = {"345", "4567", "modified_sine", "modified_trapezoid"};
    const std::string law =
        std::string("[[segment]]\nlaw = \"") + laws[random_.below(4)] + "\"\n" + at;
    if (i > 0 && random_.below(3) == 0) return law;
    const bool opened = i == 0 && !periodic && random_.below(2) == 0;
    return law + "free = { shape = " + std::to_string(8 + random_.below(20)) +
           (opened ? ", ends = { jerk = \"free\" }" : "") + " }\n";
  }

  /// " = [VALUE - ROOM, VALUE + ROOM]" behind a key, or nothing.
  std::string sometimes(const std::string& key, double value, double room) {
    if (random_.below(2) == 0) return "";
    return key + " = [" + number(value - room) + ", " + number(value + room) + "]";
  }

  std::string acceleration() {
    if (random_.below(2) == 0) return "";
    return "acceleration = " + number(random_.log_uniform(500, 2e4)) + "\n";
  }

  std::string limits() {
    std::string all;
    if (random_.below(2) == 0)
      all += "[limits]\ngeo_velocity = " + number(random_.log_uniform(0.5, 4)) + "\n";
    const bool acceleration = random_.below(2) == 0;
    const bool jerk = random_.below(3) == 0;
    if (acceleration || jerk) all += "[limits.slave]\n";
    if (acceleration) all += "acceleration = " + number(random_.log_uniform(1e3, 1e5)) + "\n";
    if (jerk) all += "jerk = " + number(random_.log_uniform(1e5, 1e7)) + "\n";
    return all;
  }

  std::string figures(bool of_knots) {
    constexpr const char* names[] = {"peak geo_acceleration", "rms geo_acceleration",
                                     "peak geo_jerk",         "rms geo_jerk",
                                     "peak geo_velocity",     "rms geo_velocity"};
    const int choice = of_knots ? 3 : 6;
    const int first = random_.below(choice);
    const int second = random_.below(choice);
    std::string all = std::string("\"") + names[first] + '"';
    if (second != first) all += std::string(", \"") + names[second] + '"';
    return all;
  }

  test::Random random_;
};

/// The figures of an outcome: of knots "objectives", of shapes those of each run.
std::vector<Json> figures_of(const Json& outcome) {
  std::vector<Json> all;
  for (const Json& each : outcome.value("objectives", Json::array())) all.push_back(each);
  for (const Json& run : outcome.value("runs", Json::array()))
    for (const Json& each : run["figures"]) all.push_back(each);
  return all;
}

/// The figure that a label names, over the segments of a spec (from 1; none: all), computed from
/// the finished curve alone.
double named(const std::string& label, const Spec& spec, const std::vector<std::size_t>& segments) {
  constexpr const char* quantities[] = {"geo_velocity", "geo_acceleration", "geo_jerk"};
  const int order = 1 + static_cast<int>(std::find(std::begin(quantities), std::end(quantities),
                                                   label.substr(label.find(' ') + 1)) -
                                         std::begin(quantities));
  const auto& cam = std::get<CamSpec>(spec.subject);
  const Cam curve = std::get<Cam>(*make(spec).curve);
  double peak = 0, squares = 0, length = 0;
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const double from = curve.breaks()[i];
    const double to = curve.breaks()[i + 1];
    std::size_t own = 1;  // the segment of the spec
    while (cam.segments[own - 1].end.master < (from + to) / 2) ++own;
    if (!segments.empty() && std::count(segments.begin(), segments.end(), own) == 0) continue;
    peak = std::max(peak, std::abs(segment_range(curve, i, order).peak().value));
    constexpr int panels = 200;  // midpoints: 1e-5 of an rms
    for (int k = 0; k < panels; ++k) {
      const double y =
          evaluate(curve.segments()[i], (k + 0.5) / panels)[static_cast<std::size_t>(order)];
      squares += y * y * (to - from) / panels;
    }
    length += to - from;
  }
  return label.starts_with("peak") ? peak : std::sqrt(squares / length);
}

/// Every label of an outcome names the number beside it.
void expect_labels(const Json& outcome, const Spec& spec) {
  const auto expect = [&](const std::string& label, const Json& figure,
                          const std::vector<std::size_t>& segments) {
    const double value = named(label, spec, segments);
    EXPECT_NEAR(figure["reached"].get<double>(), value, 1e-4 * value + 1e-7) << label;
  };
  for (const Json& each : outcome.value("objectives", Json::array()))
    expect(each["objective"].get<std::string>(), each, {});
  for (const Json& run : outcome.value("runs", Json::array()))
    for (const Json& each : run["figures"])
      expect(each["figure"].get<std::string>(), each,
             run["segments"].get<std::vector<std::size_t>>());
}

std::uint64_t number_in(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// The seeds of the specs: that of JOUNCE_SEED, or 1 to 40 times JOUNCE_CASES and the shapes that once failed.
/// 77 to 154: a point lay beside a knot. 194 and 223: the pieces did not join. 159, 285 and 344: the second run
/// did not keep the jerk at an end.
std::vector<std::uint64_t> seeds() {
  if (const std::uint64_t one = number_in("JOUNCE_SEED", 0)) return {one};
  std::vector<std::uint64_t> all(40 * number_in("JOUNCE_CASES", 1));
  std::iota(all.begin(), all.end(), 1);
  for (const std::uint64_t failed : {77U, 99U, 126U, 154U, 159U, 194U, 223U, 285U, 344U})
    if (failed > all.size()) all.push_back(failed);
  return all;
}

/// The seeds are in four parts, so that no test takes long.
constexpr std::size_t parts = 4;

class AnyOptimum : public OptimizeVerb,
                   public ::testing::WithParamInterface<std::tuple<bool, std::size_t>> {};

TEST_P(AnyOptimum, IsCheckedAndNotBelowItsBoundAndLeavesNothing) {
  const auto [knots, part] = GetParam();
  int written = 0;
  const auto all = seeds();
  for (std::size_t i = part; i < all.size(); i += parts) {
    const std::uint64_t seed = all[i];
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::filesystem::remove(path("out.toml"));
    write_file(path("any.toml"), AnySpec(seed).text(knots));
    const Ran ran = jounce("optimize any.toml -o out.toml --json");
    ASSERT_LE(ran.status, 1) << read_file(path("any.toml")) << ran.output;
    if (ran.status != 0) continue;
    ++written;
    expect_checked(read_file(path("any.toml")));
    const Json first = Json::parse(ran.output);
    expect_labels(first, read_spec(path("out.toml")));
    for (const Json& f : figures_of(first))
      EXPECT_GE(f["reached"].get<double>(), f.value("bound", 0.0) * (1 - 1e-9)) << f;
    if (first["status"] == "stalled") continue;
    const Ran second = jounce("optimize out.toml --json");
    const Json again = Json::parse(second.output, nullptr, false);
    ASSERT_FALSE(again.is_discarded()) << second.output << read_file(path("any.toml"));
    if (again["status"] == "stalled") continue;
    EXPECT_EQ(second.status, 0) << second.output << read_file(path("any.toml"));
    const double rounding = 1e-12;  // rounding of figures that are 0
    const bool ordered = figures_of(first).size() > again.value("runs", Json::array()).size();
    const double tolerance = ordered && !knots ? 1.01e-3 : 3e-6;
    EXPECT_GE(figures_of(again)[0]["reached"].get<double>() + rounding,
              figures_of(first)[0]["reached"].get<double>() * (1 - tolerance))
        << first["reason"];
  }
  EXPECT_GE(written, all.size() == 1 ? 0 : 3);
}

INSTANTIATE_TEST_SUITE_P(Of, AnyOptimum,
                         ::testing::Combine(::testing::Bool(),
                                            ::testing::Range(std::size_t{0}, parts)),
                         [](const auto& param) {
                           return (std::get<0>(param.param) ? "Knots" : "Shapes") +
                                  std::to_string(std::get<1>(param.param) + 1);
                         });

}  // namespace
}  // namespace jounce::optimize_verb_test

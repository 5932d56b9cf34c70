// SPDX-License-Identifier: Apache-2.0
// What `check` and `design` promise of every example is what the executor's log shows.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/design/input.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/proof/played.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/sender/stream_plan.hpp"

#include "executor/site.hpp"
#include "support/errors.hpp"

namespace jounce::cli {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const fs::path examples = fs::path(JOUNCE_SOURCE_DIR) / "examples";

/// Files that hold nothing that could be streamed, and why: by the kind of a spec, by their ending, by their name.
const std::map<std::string, std::string> no_tables{
    {"axis", "what an executor runs"},
    {"machine", "what an executor runs"},
    {"drive", "the model behind an axis"},
    {"sweep", "makes many variants of another spec, which is played"},
    {".cpp", "a program, which has a test of its own"},
    {".md", "a page"},
    {".ngc", "a program, which a spec beside it names"},
    {".dxf", "a drawing, which a spec beside it names"},
    {".svg", "a drawing, which a spec beside it names"},
    {"ci/gitattributes", "a setting of git"},
    {"ci/github-actions.yml", "a pipeline"},
    {"ci/gitlab-ci.yml", "a pipeline"},
    {"ci/jounce-git-diff", "a script"},
    {"ci/jounce-textconv", "a script"},
    {"ci/pre-commit", "a script"},
    {"ci/pre-commit-config.yaml", "a setting of pre-commit"},
    {"compensated-table/corrections.csv", "the user table of compensated-table/y.toml"},
    {"measured-cam/measured.csv", "the points of measured-cam/spline.toml, which is played"},
    {"pmc600-path/sequence.csv", "the records of pmc600-path/sequence.toml, which is played"},
    {"gcode-part/machine.toml", "a machine, which needs a program"},
    {"library/CMakeLists.txt", "a build, which tests/package runs"},
    {"points-file/points.csv", "the knots of points-file/pvt.toml, which is played"},
    {"points-file/points.xlsx", "the same knots, in a workbook"}};

std::string kind_of(const fs::path& path) {
  std::ifstream file(path);
  const std::string mark = "kind = \"";
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(mark))
      return line.substr(mark.size(), line.find('"', mark.size()) - mark.size());
  return "";
}

/// Every other file under examples/.
std::vector<std::string> files() {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(examples)) {
    const fs::path& path = entry.path();
    const std::string name = path.lexically_relative(examples).string();
    if (entry.is_directory() || no_tables.contains(name)) continue;
    if (no_tables.contains(path.extension()) || no_tables.contains(kind_of(path))) continue;
    found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// One line of the log while the table is played, read without the library's reader.
struct Logged {
  double time = 0;
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  bool at_rest = false;  // the table has ended
};

std::vector<Logged> logged(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<Logged> all;
  bool begun = false;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    begun |= cells[8] != "0";
    if (begun)
      all.push_back({std::stod(cells[1]), std::stod(cells[5]), std::stod(cells[6]),
                     std::stod(cells[7]), cells[8] == "0"});
  }
  const double start = all.empty() ? 0 : all.front().time;
  for (Logged& tick : all) tick.time -= start;
  return all;
}

/// A cam without a [master] follows one that passes it once, from and to rest; so does one whose master
/// moves where it begins, with which no axis at rest can start.
Trajectory passing(const Cam& cam) {
  const double length = cam.end() - cam.start();
  return trapezoid({.from = cam.start(),
                    .to = cam.end(),
                    .velocity = length / 1.5,
                    .acceleration = 3 * length})
      .curve();
}

/// A move from one state to another that is slower than the motion it leads to.
Trajectory lead(const MotionState& from, const MotionState& to, const Trajectory& motion) {
  const auto peak = [&](int order) {
    const double value = std::abs(extrema(motion, order).peak().value);
    return value > 0 ? value : Bounds::none;
  };
  const MoveResult move = move_to(from, to, within(peak(1), peak(2), peak(3)));
  EXPECT_TRUE(move) << explain(move.status);
  return move.profile.curve();
}

/// Appends the knots of a table, but for its first where that is the last one there.
void append(Columns& all, const Columns& more) {
  const double from = all.x.empty() ? 0 : all.x.back() - more.x.front();
  const std::size_t first = all.x.empty() ? 0 : 1;
  for (std::size_t i = first; i < more.x.size(); ++i) all.x.push_back(from + more.x[i]);
  const auto add = [&](std::vector<double>& column, const std::vector<double>& values) {
    if (values.empty()) return;
    column.insert(column.end(), values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
  };
  add(all.p, more.p);
  add(all.v, more.v);
  add(all.a, more.a);
}

Columns knots_of(const Trajectory& motion, Interpolation rule) {
  std::vector<double> knots{motion.start()};
  for (const double x : motion.breaks())  // a phase may be no longer than the rounding of its place
    if (x - knots.back() > 1e-9 * motion.end()) knots.push_back(x);
  knots.back() = motion.end();
  return sample(motion, rule, knots).table.columns();
}

/// A motion that begins or ends moving, between a move that leads to it from rest and one that
/// brings it to rest, within its own peaks. The promised limits hold for all of it.
Input from_rest_to_rest(Input input) {
  const auto* const motion = std::get_if<Trajectory>(&*input.curve);
  if (motion == nullptr) return input;
  const auto state = [](const Jet& jet) { return MotionState{jet[0], jet[1], jet[2]}; };
  const Interpolation rule = input.table.table.rule();
  const bool smooth = rule == Interpolation::quintic_hermite;
  MotionState begin = state(motion->jet(motion->start(), Side::right));
  MotionState end = state(motion->jet(motion->end(), Side::left));
  const double none = 1e-6 * std::abs(extrema(*motion, 1).peak().value);
  const bool leads = std::abs(begin.velocity) > none;
  const bool follows = std::abs(end.velocity) > none;
  if (!leads && !follows) return input;
  if (!smooth) begin.acceleration = end.acceleration = 0;  // it may step
  std::vector<Segment> segments;
  Columns columns;
  if (leads) {
    const Trajectory in = lead({begin.position - begin.velocity, 0, 0}, begin, *motion);
    segments.assign(in.segments().begin(), in.segments().end());
    append(columns, knots_of(in, rule));
  }
  append(columns, input.table.table.columns());
  segments.insert(segments.end(), motion->segments().begin(), motion->segments().end());
  if (follows) {
    const Trajectory out = lead(end, {end.position + end.velocity, 0, 0}, *motion);
    segments.insert(segments.end(), out.segments().begin(), out.segments().end());
    append(columns, knots_of(out, rule));
  }
  input.curve = Trajectory(std::move(segments), 0, Extrapolation::hold);
  input.table.table = Table(Domain::time, rule, Extrapolation::hold, std::move(columns));
  return input;
}

/// The played motion, and its promise: the table over time, and behind its master the chain rule.
struct Promise {
  StreamPlan plan;
  Reference table;
  Reference curve;
};

bool has_master(const Input& input) {
  const auto* const cam = std::get_if<Cam>(&*input.curve);
  if (!input.spec || !input.spec->master) return false;
  if (cam == nullptr || input.spec->master->acceleration) return true;
  const double begins = std::abs(cam->jet(cam->start(), Side::right)[1]);
  return begins <= 1e-9 * std::abs(extrema(*cam, 1).peak().value);
}

Promise promise_of(const Input& input) {
  const auto* const cam = std::get_if<Cam>(&*input.curve);
  StreamPlan plan;
  if (cam == nullptr || has_master(input)) {
    ExecutorTables tables = executor_tables(input);
    plan.tables.push_back({std::move(tables.slave.table), tables.slave.units});
    if (tables.master)
      plan.tables.push_back({std::move(tables.master->table), tables.master->units});
    if (tables.master) plan.mode = wire::ArmMode::follow_table;
    return {std::move(plan), table_reference(input), exact_reference(input)};
  }
  const Trajectory master = passing(*cam);
  const std::vector<double> knots(master.breaks().begin(), master.breaks().end());
  plan.tables.push_back({input.table.table, input.table.units});
  plan.tables.push_back(
      {sample(master, Interpolation::cubic_hermite, knots).table, {"s", input.table.units.x}});
  plan.mode = wire::ArmMode::follow_table;
  return {std::move(plan), Followed(input.table.table.curve<OverMaster>(), master),
          Followed(*cam, master)};
}

/// The greatest magnitudes of a motion: at both sides of its breaks, and between them on a grid so fine
/// that what it misses is below a thousandth.
struct Peaks {
  double position = 0, velocity = 0, acceleration = 0, jerk = 0;
};

Peaks peaks_of(const Reference& motion) {
  constexpr int steps = 20'000;
  Peaks peaks;
  const auto look = [&](double t) {
    const Motion m = at(motion, std::min(std::max(t, 0.0), duration(motion)));
    peaks.position = std::max(peaks.position, std::abs(m.position));
    peaks.velocity = std::max(peaks.velocity, std::abs(m.velocity));
    peaks.acceleration = std::max(peaks.acceleration, std::abs(m.acceleration));
    peaks.jerk = std::max(peaks.jerk, std::abs(m.jerk));
  };
  for (int i = 0; i <= steps; ++i) look(duration(motion) * i / steps);
  std::visit(
      [&](const auto& signal) {
        for (const double x : signal.breaks())
          for (const double side : {-1e-9, 0.0, 1e-9}) look(x - signal.start() + side);
      },
      motion);
  return peaks;
}

/// An instant's rounding: a value that steps there may be that of either side.
template <class Value>
bool is(double value, const Reference& motion, double t, Value of, double tolerance) {
  constexpr double instant = 1e-9;
  for (const double at_ : {t, t - instant, t + instant}) {
    const double clamped = std::min(std::max(at_, 0.0), duration(motion));
    if (std::abs(value - of(at(motion, clamped))) <= tolerance) return true;
  }
  return false;
}

/// Permitted error of a value whose instant is rounded: the change by its slope in that time.
double rounding(double peak, double slope) {
  return 1e-8 * peak + 2e-9 * slope + 1e-9;
}

class Play {
 public:
  Play(const Input& input, const std::string& file) : input_(input), promise_(promise_of(input)) {
    log_ = fs::temp_directory_path() / ("jounce-played-" + std::to_string(getpid()) + "-" +
                                        fs::path(file).stem().string() + ".csv");
  }
  ~Play() {
    std::error_code none;
    fs::remove(log_, none);
  }
  Play(const Play&) = delete;
  Play& operator=(const Play&) = delete;

  /// Streams it to an axis that can do what is promised, and no more. Why not; empty: it was played.
  std::string run() {
    peaks_ = peaks_of(promise_.table);
    ExecutorOptions axis =
        test::axis_named("feeder", {}, {input_.table.units.x, input_.table.units.position});
    axis.axis.limits.velocity = 1.01 * std::max(peaks_.velocity, 1e-9);
    axis.axis.limits.acceleration = 1.01 * std::max(peaks_.acceleration, 1e-6);
    axis.adopt_start = true;
    axis.enable = true;
    axis.log = log_;
    test::Site site({axis});
    site.advance(20ms);
    promise_.plan.executor = "feeder";
    const StreamOutcome outcome = site.stream(promise_.plan);
    if (!outcome.ok()) return outcome.reason;
    site.advance(Nanos(std::llround((duration(promise_.table) + 0.1) * 1e9)));
    last_ = site.last();
    site.dispatcher.close();
    std::ifstream file(log_);
    csv_ = {std::istreambuf_iterator<char>(file), {}};
    return "";
  }

  void compare() const {
    compare_ticks();
    compare_peaks();
    compare_limits();
    compare_end();
  }

 private:
  /// Position by `validate`'s own comparison, velocity and acceleration against the table.
  void compare_ticks() const {
    Designed designed{.over_time = {.table = [&](double t) { return at(promise_.table, t); }},
                      .duration = duration(promise_.table)};
    if (const auto tolerance = table_tolerance(input_)) {
      designed.over_time.curve = [&](double t) { return at(promise_.curve, t).position; };
      designed.tolerance = *tolerance;
    }
    const Played played = compare_played(read_played(csv_, "log"), designed);
    EXPECT_LE(played.table.error, played.table.limit) << "at " << played.table.where << " s";
    if (played.curve && check_all(input_).ok()) {
      EXPECT_LE(played.curve->error, played.curve->limit) << "at " << played.curve->where << " s";
    }
    for (const Logged& tick : logged(csv_)) {
      if (tick.at_rest) break;
      ASSERT_TRUE(is(
          tick.velocity, promise_.table, tick.time, [](const Motion& m) { return m.velocity; },
          rounding(peaks_.velocity, peaks_.acceleration)))
          << tick.time << " s: " << tick.velocity;
      ASSERT_TRUE(is(
          tick.acceleration, promise_.table, tick.time,
          [](const Motion& m) { return m.acceleration; },
          rounding(peaks_.acceleration, peaks_.jerk)))
          << tick.time << " s: " << tick.acceleration;
    }
  }

  /// The log reaches the peaks that `design` prints, but for what lies between two ticks.
  void compare_peaks() const {
    double velocity = 0;
    double acceleration = 0;
    for (const Logged& tick : logged(csv_)) {
      velocity = std::max(velocity, std::abs(tick.velocity));
      acceleration = std::max(acceleration, std::abs(tick.acceleration));
    }
    constexpr double cycle = 1e-3;
    EXPECT_LE(velocity, peaks_.velocity * 1.001 + 1e-12);
    EXPECT_GE(velocity, peaks_.velocity * 0.999 - cycle * peaks_.acceleration);
    EXPECT_LE(acceleration, peaks_.acceleration * 1.001 + 1e-9);
    EXPECT_GE(acceleration, peaks_.acceleration * 0.999 - cycle * peaks_.jerk);
  }

  /// A limit over time that holds for `check` holds in the log; one that is broken for `check` is
  /// broken there.
  void compare_limits() const {
    if (std::holds_alternative<Cam>(*input_.curve)) return;  // limits per master unit
    const double unit =
        duration(exact_reference(input_)) /
        (std::get<Trajectory>(*input_.curve).end() - std::get<Trajectory>(*input_.curve).start());
    double velocity = 0;
    double acceleration = 0;
    for (const Logged& tick : logged(csv_)) {
      velocity = std::max(velocity, std::abs(tick.velocity));
      acceleration = std::max(acceleration, std::abs(tick.acceleration));
    }
    const Report report = check_all(input_);
    compare_limit(report, "limit/velocity", input_.limits.velocity, velocity * unit,
                  1e-3 * peaks_.acceleration * unit);
    compare_limit(report, "limit/acceleration", input_.limits.acceleration,
                  acceleration * unit * unit, 1e-3 * peaks_.jerk * unit * unit);
  }

  static void compare_limit(const Report& report, const std::string& rule,
                            const std::optional<double>& limit, double seen, double missed) {
    if (!limit) return;
    const bool broken =
        std::any_of(report.findings.begin(), report.findings.end(),
                    [&](const Finding& finding) { return finding.broken && finding.rule == rule; });
    if (broken) {
      EXPECT_GE(seen, *limit - missed) << rule << ": broken for check";
    } else {
      EXPECT_LE(seen, *limit * (1 + 1e-9)) << rule << ": holds for check";
    }
  }

  void compare_end() const {
    EXPECT_EQ(last_.fault, Cause::none) << name(last_.fault);
    EXPECT_EQ(last_.finished, 1U);
    const Motion end = at(promise_.curve, duration(promise_.curve));
    const double tolerance = table_tolerance(input_).value_or(0) + 1e-12 * peaks_.position + 1e-12;
    EXPECT_NEAR(last_.position, end.position, tolerance);
    EXPECT_EQ(last_.velocity, 0);
  }

  const Input& input_;
  Promise promise_;
  fs::path log_;
  Peaks peaks_;
  Tick last_;
  std::string csv_;
};

/// Examples that no axis can play, and the reason that is given.
const std::map<std::string, std::string> refused{
    // The misprint that it shows.
    {"googol-pt/as-printed.toml", "must be a whole number of ms"},
    // `check` finds a step of its velocity, which no axis can make.
    {"googol-pt/sine.toml", "start_velocity"},
    // Lines that meet at an angle: a step of the velocity.
    {"cam-algebra/lines.toml", "velocity_step"},
    // The kinematics of a group: it has no commands of its own.
    {"delta/kinematics.toml", "command: is missing"},
    {"scara/kinematics.toml", "command: is missing"},
    // It begins in the origin of its frame, and the axes of this test stand at 0.
    {"himc-path/frame.toml", "the table begins at"}};

class PlayedExample : public ::testing::TestWithParam<std::string> {};

/// All its axes are played and compared; why one was not; empty: all were.
std::string played(const std::string& file) {
  std::string why;
  const std::string error = test::error_of([&] {
    for (const Input& loaded : read_inputs((examples / file).string())) {
      const Input input = from_rest_to_rest(loaded);
      SCOPED_TRACE(input.name);
      Play play(input, file);
      why = play.run();
      if (!why.empty()) return;
      play.compare();
    }
  });
  return error.empty() ? why : error;
}

TEST_P(PlayedExample, IsWhatCheckAndDesignPromise) {
  const auto no = refused.find(GetParam());
  const std::string why = played(GetParam());
  if (no == refused.end()) {
    EXPECT_EQ(why, "");
  } else {
    EXPECT_NE(why.find(no->second), std::string::npos) << why;
  }
}

// A file left out by its kind is not a table; a file left out or rejected by its name exists.
TEST(PlayedExamples, LeaveOutNoTable) {
  for (const auto& entry : fs::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".toml" && no_tables.contains(kind_of(entry.path()))) {
      EXPECT_THROW((void)read_inputs(entry.path().string()), InputError) << entry.path();
    }
  for (const auto& names : {no_tables, refused})
    for (const auto& [name, why] : names)
      if (name.find('/') != std::string::npos) {
        EXPECT_TRUE(fs::exists(examples / name)) << name;
      }
}

std::string worded(const ::testing::TestParamInfo<std::string>& info) {
  std::string word = info.param;
  for (char& c : word)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return word;
}

INSTANTIATE_TEST_SUITE_P(Examples, PlayedExample, ::testing::ValuesIn(files()), worded);

}  // namespace
}  // namespace jounce::cli

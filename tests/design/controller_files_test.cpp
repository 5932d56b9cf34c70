// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/report/report_text.hpp"

#include "design/src/convert/time_rounding.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

// Each written file is played by an interpreter of the target's rule, and compared with the closed
// form of the motion at 100 000 places. The interpreters follow the manuals of the controllers and
// use no code of Jounce.
namespace jounce::controller_files_test {
namespace {

using ::testing::HasSubstr;

// The two motions of the notes on formats. E: 40 mm by 3-4-5 over 0 to 120 deg, a dwell to 180, back
// until 300, a dwell to 360. P: 40 mm by 3-4-5 in 0.4 s (from 0 to 0.5 s for Galil).
double law_345(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 + s * (-15 + 6 * s));
}
double motion_e(double master) {
  return 40 * (law_345(master / 120) - law_345((master - 180) / 120));
}

Input cam_e() {
  return input_of(
      {Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
             {{0, 120, 180, 300, 360}, {0, 40, 40, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}),
       {"deg", "mm"},
       {}},
      "e.csv");
}

Input move_p(double seconds) {
  return input_of({Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                         {{0, seconds}, {0, 40}, {0, 0}, {0, 0}}),
                   {"s", "mm"},
                   {}},
                  "p.csv");
}

/// A polynomial between two knots, in powers of the distance from the first one.
struct Piece {
  double from, length;
  std::vector<double> c;

  [[nodiscard]] double at(double x) const {
    double value = 0;
    for (auto power = c.rbegin(); power != c.rend(); ++power) value = value * (x - from) + *power;
    return value;
  }
};

/// A motion as a controller plays it.
struct Played {
  std::vector<Piece> pieces = {};

  [[nodiscard]] double end() const { return pieces.back().from + pieces.back().length; }
  [[nodiscard]] double at(double x) const {
    const auto next = std::partition_point(pieces.begin(), pieces.end(),
                                           [&](const Piece& piece) { return piece.from <= x; });
    return (next == pieces.begin() ? next : std::prev(next))->at(x);
  }
};

struct Knot {
  double x = 0, p = 0, v = 0, a = 0;
};

Played by_lines(const std::vector<Knot>& knots) {
  Played played;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double h = knots[i].x - knots[i - 1].x;
    played.pieces.push_back(
        {knots[i - 1].x, h, {knots[i - 1].p, (knots[i].p - knots[i - 1].p) / h}});
  }
  return played;
}

Played by_cubics(const std::vector<Knot>& knots) {
  Played played;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Knot &a = knots[i - 1], &b = knots[i];
    const double h = b.x - a.x, mean = (b.p - a.p) / h;
    played.pieces.push_back(
        {a.x, h, {a.p, a.v, (3 * mean - 2 * a.v - b.v) / h, (a.v + b.v - 2 * mean) / (h * h)}});
  }
  return played;
}

/// The quintic with p = p0 + v0 u + a0 u^2 / 2 + k3 u^3 + k4 u^4 + k5 u^5, from its three conditions at
/// the end.
Played by_quintics(const std::vector<Knot>& knots) {
  Played played;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Knot &a = knots[i - 1], &b = knots[i];
    const double h = b.x - a.x;
    const double p = b.p - a.p - a.v * h - a.a * h * h / 2, v = (b.v - a.v - a.a * h) * h,
                 r = (b.a - a.a) * h * h;
    const double k3 = 10 * p - 4 * v + r / 2, k4 = -15 * p + 7 * v - r, k5 = 6 * p - 3 * v + r / 2;
    played.pieces.push_back(
        {a.x,
         h,
         {a.p, a.v, a.a / 2, k3 / (h * h * h), k4 / (h * h * h * h), k5 / (h * h * h * h * h)}});
  }
  return played;
}

/// Googol's segments: the velocity is linear; a normal one begins with the velocity before.
struct PtSegment {
  double x = 0, p = 0;
  int type = 0;
};
Played by_parabolas(const std::vector<PtSegment>& segments) {
  Played played;
  double x = 0, p = 0, v = 0;
  for (const PtSegment& each : segments) {
    const double h = each.x - x, mean = (each.p - p) / h;
    const double from = each.type == 1 ? mean : each.type == 2 ? 2 * mean : v;
    v = 2 * mean - from;
    played.pieces.push_back({x, h, {p, from, (v - from) / (2 * h)}});
    x = each.x, p = each.p;
  }
  return played;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The numbers after each occurrence of a word: "dX := " in "(dX := 1.5, dY := 2)".
std::vector<double> numbers_after(const std::string& text, const std::string& word) {
  std::vector<double> all;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    all.push_back(std::strtod(text.c_str() + at + word.size(), nullptr));
  return all;
}

std::vector<Knot> knots_after(const std::string& text, const std::vector<std::string>& words) {
  std::vector<Knot> knots(numbers_after(text, words[0]).size());
  for (std::size_t column = 0; column < words.size(); ++column) {
    const auto values = numbers_after(text, words[column]);
    EXPECT_EQ(values.size(), knots.size()) << words[column];
    for (std::size_t i = 0; i < values.size(); ++i)
      (column == 0   ? knots[i].x
       : column == 1 ? knots[i].p
       : column == 2 ? knots[i].v
                     : knots[i].a) = values[i];
  }
  return knots;
}

Played play_pairs(const std::string& text) {
  std::vector<Knot> knots;
  for (const std::string& line : lines_of(text)) {
    Knot knot;
    if (std::sscanf(line.c_str(), "%lf%*[;\t]%lf", &knot.x, &knot.p) == 2) knots.push_back(knot);
  }
  return by_lines(knots);
}

Played play_xps(const std::string& text) {
  std::vector<Knot> knots{{}};
  for (const std::string& line : lines_of(text)) {
    double dt = 0, dp = 0, v = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf, %lf, %lf", &dt, &dp, &v), 3) << line;
    knots.push_back({knots.back().x + dt, knots.back().p + dp, v});
  }
  EXPECT_EQ(knots.back().v, 0);
  return by_cubics(knots);
}

Played play_zaber(const std::string& text) {
  const auto lines = lines_of(text);
  EXPECT_EQ(lines[0], "Time (s),Axis 1 Position (mm),Axis 1 Velocity (mm/s)");
  std::vector<Knot> knots;
  double x = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    Knot knot;
    double dt = 0;
    EXPECT_EQ(std::sscanf(lines[i].c_str(), "%lf,%lf,%lf", &dt, &knot.p, &knot.v), 3);
    knot.x = x += dt;
    knots.push_back(knot);
  }
  return by_cubics(knots);
}

Played play_ros(const std::string& text) {
  std::vector<Knot> knots;
  for (const std::string& line : lines_of(text)) {
    Knot k;
    long sec = 0, nanosec = 0;
    if (std::sscanf(
            line.c_str(),
            "- {positions: [%lf], velocities: [%lf], accelerations: [%lf], time_from_start: "
            "{sec: %ld, nanosec: %ld}}",
            &k.p, &k.v, &k.a, &sec, &nanosec) != 5)
      continue;
    EXPECT_LT(nanosec, 1'000'000'000);
    k.x = static_cast<double>(sec) + 1e-9 * static_cast<double>(nanosec);
    knots.push_back(k);
  }
  return by_quintics(knots);
}

Played play_galil(const std::string& text) {
  long modulus = 0, advance = 0, interval = 0;
  std::vector<Knot> knots;
  for (const std::string& line : lines_of(text)) {
    long k = 0, p = 0;
    (void)std::sscanf(line.c_str(), "EM %ld,%ld", &modulus, &advance);
    (void)std::sscanf(line.c_str(), "EP %ld", &interval);
    if (std::sscanf(line.c_str(), "ET[%ld]=,%ld", &k, &p) == 2)
      knots.push_back({static_cast<double>(k * interval), static_cast<double>(p)});
  }
  EXPECT_LE(interval, 32767);
  EXPECT_LE(knots.size(), 257U);
  EXPECT_EQ(modulus, interval * static_cast<long>(knots.size() - 1));
  EXPECT_EQ(advance, static_cast<long>(knots.back().p - knots.front().p));
  return by_lines(knots);
}

Played play_galil_pvt(const std::string& text) {
  std::vector<Knot> knots{{}};
  for (const std::string& line : lines_of(text)) {
    long p = 0, v = 0, t = 0;
    if (std::sscanf(line.c_str(), "PVA=%ld,%ld,%ld", &p, &v, &t) != 3 || t <= 0) continue;
    EXPECT_EQ(t % 2, 0);
    knots.push_back({knots.back().x + static_cast<double>(t) * 976.5625e-6,
                     knots.back().p + static_cast<double>(p), static_cast<double>(v)});
  }
  EXPECT_THAT(text, HasSubstr("\nPVA=0,0,0\nBTA\n"));
  return by_cubics(knots);
}

Played play_trio(const std::string& text) {
  std::vector<double> table;
  long first = 0, last = 0, link = 0, options = 0;
  double multiplier = 0, distance = 0;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("TABLE(")) {
      std::istringstream values(line.substr(6));
      std::string cell;
      std::getline(values, cell, ',');
      EXPECT_EQ(std::stoul(cell), 1000 + table.size());
      while (std::getline(values, cell, ',')) table.push_back(std::stod(cell));
    }
    (void)std::sscanf(line.c_str(), "CAMBOX(%ld,%ld,%lf,%lf,%ld,%ld)", &first, &last, &multiplier,
                      &distance, &link, &options);
  }
  EXPECT_EQ(options, 4) << "repeats";
  EXPECT_EQ(table.front(), 0) << "relative to the start";
  std::vector<Knot> knots;
  for (long i = first; i <= last; ++i)
    knots.push_back({distance * static_cast<double>(i - first) / static_cast<double>(last - first),
                     multiplier * table.at(static_cast<std::size_t>(i - 1000))});
  return by_lines(knots);
}

Played play_googol(const std::string& text, const char* call, bool follows) {
  std::vector<PtSegment> segments;
  for (auto at = text.find(call); at != text.npos; at = text.find(call, at + 1)) {
    double a = 0, b = 0;
    int type = 0, fifo = 0;
    EXPECT_EQ(std::sscanf(text.c_str() + at + std::string(call).size(), "(axis, %lf, %lf, %d, %d)",
                          &a, &b, &type, &fifo),
              4);
    segments.push_back(follows ? PtSegment{a, b, type} : PtSegment{b, a, type});
    EXPECT_EQ(segments.back().x, std::round(segments.back().x)) << "a long";
  }
  return by_parabolas(segments);
}

Played play_hmpl(const std::string& text) {
  const auto array = [&](const std::string& name) {
    const auto from = text.find('{', text.find(name)), to = text.find('}', from);
    std::istringstream list(text.substr(from + 1, to - from - 1));
    std::vector<double> values;
    for (std::string cell; std::getline(list, cell, ',');) values.push_back(std::stod(cell));
    return values;
  };
  const auto t = array("pvt_time"), p = array("pvt_position"), v = array("pvt_velocity");
  EXPECT_LE(t.size(), 50U);
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < t.size(); ++i) knots.push_back({t[i] / 1000, p.at(i), v.at(i)});
  return by_cubics(knots);
}

/// A format with its interpreter and the sizes of the file's units.
struct Target345 {
  const char* format;
  std::function<Played(const std::string&)> play;
  double x = 1;  ///< unit of the file in s or deg
  double p = 1;  ///< unit of the file in mm
  double seconds = 0.4;
  double x_count = 0, p_count = 0;  ///< sizes of a count, as the user gives them
  double tolerance = 0;             ///< mm; 0: the default, a ten-thousandth of the stroke
};

const std::vector<Target345>& targets() {
  static const std::vector<Target345> all{
      {"codesys",
       [](const auto& text) {
         return by_quintics(knots_after(text, {"dX := ", "dY := ", "dV := ", "dA := "}));
       }},
      {"plcopen",
       [](const auto& text) {
         const auto member = [](const char* name) {
           return std::string("<value member=\"") + name + "\"><simpleValue value=\"";
         };
         return by_quintics(
             knots_after(text, {member("dX"), member("dY"), member("dV"), member("dA")}));
       }},
      {"twincat",
       [](const auto& text) {
         return by_quintics(
             knots_after(text, {"MasterPos := ", "SlavePos := ", "SlaveVelo := ", "SlaveAcc := "}));
       }},
      {"twincat-mc3",
       [](const auto& text) {
         return by_quintics(knots_after(text, {"MasterPosition := ", "SlavePosition := ",
                                               "SlaveVelocity := ", "SlaveAcceleration := "}));
       }},
      {"siemens",
       [](const auto& text) {
         return by_quintics(knots_after(text, {"leadingValue := ", "followingValue := ",
                                               "velocityRatio := ", "accelerationRatio := "}));
       }},
      {"pairs", play_pairs},
      {"sew", play_pairs},
      {"xps", play_xps},
      {"zaber", play_zaber},
      {"ros", play_ros, 1, 1000},
      {"galil", play_galil, 0.01, 0.001, 0, 0.01, 0.001, 0.005},
      {"galil-pvt", play_galil_pvt, 1, 0.001, 0.5, 0, 0.001},
      {"trio", play_trio, 1, 0.001, 0, 0, 0.001},
      {"googol-pt", [](const auto& text) { return play_googol(text, "GT_PtData", false); }, 1e-3,
       0.001, 0.4, 0, 0.001},
      {"googol-pt-st", [](const auto& text) { return play_googol(text, "GT_PtData", false); }, 1e-3,
       0.001, 0.4, 0, 0.001},
      {"googol-follow", [](const auto& text) { return play_googol(text, "GT_FollowData", true); },
       0.01, 0.001, 0, 0.01, 0.001},
      {"googol-follow-st",
       [](const auto& text) { return play_googol(text, "GT_FollowData", true); }, 0.01, 0.001, 0,
       0.01, 0.001},
      {"hmpl", play_hmpl}};
  return all;
}

struct Written {
  const ExchangeFormat& format;
  Input input;
  Converted made;
  std::string text;
};

Written written(const Target345& target) {
  const ExchangeFormat& format = *exchange_format_named(target.format);
  Conversion wanted{.format = &format};
  if (target.p_count > 0)
    wanted.target = Target{.x_step = target.x_count, .p_step = target.p_count};
  if (target.tolerance > 0) wanted.target->tolerance = target.tolerance;
  Input input = format.axis == Domain::master ? cam_e() : move_p(target.seconds);
  Converted made = converted(input, wanted);
  std::string text = exchange_text(format, made.file);
  return {format, std::move(input), std::move(made), std::move(text)};
}

class ControllerFile : public ::testing::TestWithParam<Target345> {};

TEST_P(ControllerFile, PlaysTheMotionWithTheStatedError) {
  const Target345& target = GetParam();
  const Written file = written(target);
  const Played played = target.play(file.text);
  const bool cam = file.format.axis == Domain::master;
  const double end = cam ? 360 : target.seconds;
  EXPECT_NEAR(played.end() * target.x, end, 1e-9 * end);
  const double stated = file.made.error ? file.made.error->position : 0;
  double greatest = 0;
  constexpr int places = 100'000;
  for (int i = 0; i <= places; ++i) {
    const double x = end * i / places;
    const double wanted = cam ? motion_e(x) : 40 * law_345(x / end);
    greatest = std::max(greatest, std::abs(played.at(x / target.x) * target.p - wanted));
  }
  EXPECT_LE(greatest, stated + 1e-9);
  EXPECT_LE(stated, target.tolerance > 0 ? target.tolerance : 4e-3);
  if (stated > 1e-8) {
    EXPECT_GT(greatest, 0.95 * stated) << "the stated error occurs";
  }
}

TEST_P(ControllerFile, IsReadAgain) {
  const Written file = written(GetParam());
  const std::string name = std::string("f") + file.format.extension;
  EXPECT_EQ(exchange_format_of_text(file.text, name), &file.format);
  const auto tables = parse_exchange_tables(file.text, name);
  ASSERT_EQ(tables.size(), 1U);
  const Table& back = tables[0].file.table;
  EXPECT_EQ(back.axis(), file.format.axis);
  if (file.format.states_period || file.format.keeps_notes) {
    EXPECT_EQ(back.outside(), file.made.file.table.outside());
  }
  EXPECT_EQ(back.rule(), file.made.file.table.rule());
  ASSERT_EQ(back.size(), file.made.file.table.size());
  const Columns &a = back.columns(), &b = file.made.file.table.columns();
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    EXPECT_NEAR(a.x[i], b.x[i] - b.x[0], 1e-12 * b.x.back());
    EXPECT_NEAR(a.p[i], b.p[i], 1e-9);
    if (!a.v.empty()) {
      EXPECT_NEAR(a.v[i], b.v[i], 1e-6);
    }
  }
}

/// The text without the version of the program and without the hash.
std::string anonymous(std::string text) {
  for (const auto& [word, end] : {std::pair{"jounce ", '\0'}, {"sha256: ", '\n'}})
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const auto from = at + std::string(word).size();
      const auto to = end != '\0'
                          ? text.find(end, from)
                          : text.find_first_not_of("0123456789.", from) -
                                (text[text.find_first_not_of("0123456789.", from) - 1] == '.');
      text.replace(from, to - from, "*");
    }
  return text;
}

TEST_P(ControllerFile, IsTheGoldenFile) {
  const Written file = written(GetParam());
  const std::string path =
      std::string(JOUNCE_SOURCE_DIR "/tests/design/controller_files/") + file.format.name;
  if (std::getenv("JOUNCE_WRITE_GOLDEN") != nullptr) write_file(path, anonymous(file.text));
  EXPECT_EQ(anonymous(file.text), read_file(path));
}

TEST_P(ControllerFile, OfAnyTruncationIsReadOrRejected) {
  const Written file = written(GetParam());
  const std::string name = std::string("f") + file.format.extension;
  std::size_t rejected = 0;
  for (std::size_t length = 0; length < file.text.size();
       length += 1 + (length > 2000 && length + 2000 < file.text.size() ? 97 : 0)) {
    try {
      (void)parse_exchange_tables(file.text.substr(0, length), name);
    } catch (const InputError& error) {
      EXPECT_EQ(error.document(), name);
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, ControllerFile, ::testing::ValuesIn(targets()),
                         [](const auto& each) {
                           std::string name = each.param.format;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ControllerFiles, WithTooFewKnotsAreNotWithinTheLimit) {
  const ExchangeFormat& galil = *exchange_format_named("galil");
  Conversion wanted{.rule = Interpolation::linear,
                    .target = Target{.x_step = 0.01, .p_step = 0.001},
                    .intervals = 12,
                    .format = &galil};
  const Converted made = converted(cam_e(), wanted);
  EXPECT_FALSE(made.within_limit());
  EXPECT_NEAR(made.error->position, 1.44, 0.01) << "the notes on formats, 5.9";
  EXPECT_EQ(made.counts, "master: 1 count is 0.01 deg; position: 1 count is 0.001 mm");
  EXPECT_THAT(conversion_text(cam_e(), made, {"galil", &galil}, {}),
              HasSubstr("the error exceeds the tolerance, 0.004 mm (by default, a ten-thousandth "
                        "of the travel)\n"));
}

/// Steps of 0.05 s: their sums round, so a difference of two times is 0.04999999999999999.
TEST(ControllerFiles, IncrementsHaveTheDigitsOfTheirStep) {
  Columns columns{};
  for (int i = 0; i <= 400; ++i) {
    columns.x.push_back(i * 0.05);
    columns.p.push_back(0.1 * i);
    columns.v.push_back(i == 0 || i == 400 ? 0 : 2);
  }
  const std::vector<double> x = columns.x, p = columns.p;
  const TableFile file{
      Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold, std::move(columns)),
      {"s", "mm"},
      {}};
  for (const char* name : {"xps", "zaber"}) {
    std::istringstream text(exchange_text(*exchange_format_named(name), file));
    std::string line;
    double time = 0, position = 0;
    const bool sums = name == std::string("xps");
    if (!sums)
      std::getline(text, line), std::getline(text, line);  // the header, and the first point
    for (std::size_t i = 1; std::getline(text, line); ++i) {
      ASSERT_TRUE(line.starts_with(sums ? "0.05, 0.1, " : "0.05,")) << name << ": " << line;
      time += 0.05;
      position = sums ? position + 0.1 : std::stod(line.substr(5));
      EXPECT_NEAR(time, x[i], 1e-12 * x[i]) << name;
      EXPECT_NEAR(position, p[i], 1e-12 * p[i]) << name;
    }
    EXPECT_NEAR(time, 20, 1e-11) << name;
  }
}

TEST(ControllerFiles, OfFourStepsLoseWhatTheNotesState) {
  const ExchangeFormat& xps = *exchange_format_named("xps");
  const Converted made = converted(
      move_p(0.4), {.rule = Interpolation::cubic_hermite, .intervals = 4, .format = &xps});
  EXPECT_NEAR(made.error->position, 0.110, 0.001) << "the notes on formats, 5.7";
  EXPECT_EQ(exchange_text(xps, made.file).substr(0, 27), "0.1, 4.140625, 105.46875\n0.");
}

TEST(ControllerFiles, NameWhatAFormatNeeds) {
  const auto rule = [](const Input& input, const char* name) {
    const ExchangeFormat& format = *exchange_format_named(name);
    return test::error_of(
        [&] { (void)converted(input, {.rule = rule_of(format), .format = &format}); });
  };
  EXPECT_EQ(rule(cam_e(), "trio"),
            "p_step: is missing: the format trio has the position in counts. Give the size of one "
            "count, such as 0.001mm");
  const ExchangeFormat& galil = *exchange_format_named("galil");
  try {
    (void)converted(cam_e(), {.rule = rule_of(galil), .format = &galil});
    FAIL();
  } catch (const InputErrors& errors) {
    ASSERT_EQ(errors.all().size(), 2U);
    EXPECT_EQ(errors.all()[0].key(), "x_step");
    EXPECT_EQ(errors.all()[1].key(), "p_step");
  }
  EXPECT_THAT(rule(cam_e(), "xps"), HasSubstr("is for motions over time; this table is a cam"));
  EXPECT_THAT(rule(move_p(0.4), "trio"), HasSubstr("is for cams"));
  Input turn = input_of(
      {Table(Domain::time, Interpolation::linear, Extrapolation::hold, {{0, 1}, {0, 90}, {}, {}}),
       {"s", "deg"},
       {}},
      "t.csv");
  EXPECT_THAT(rule(turn, "zaber"), HasSubstr("position_unit = deg: is not possible in the format "
                                             "zaber, whose units are mm cm"));
  EXPECT_EQ(rule(cam_e(), "hmpl-gear"), "") << "the error decides";
  const ExchangeFormat& gear = *exchange_format_named("hmpl-gear");
  EXPECT_FALSE(converted(cam_e(), {.rule = Interpolation::linear, .format = &gear}).within_limit());
}

TEST(ControllerFiles, ApplyTheResolutionsOfTheUser) {
  for (const char* name : {"ros", "zaber", "hmpl", "xps"}) {
    SCOPED_TRACE(name);
    const ExchangeFormat& format = *exchange_format_named(name);
    const Converted made =
        converted(move_p(0.4),
                  {.rule = rule_of(format),
                   .target = Target{.tolerance = 2.0, .x_step = 0.001, .p_step = 0.5, .v_step = 1},
                   .format = &format});
    const Columns& c = made.file.table.columns();
    const double unit = made.file.units.position == "m" ? 1e-3 : 1;
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      EXPECT_NEAR(c.p[i] / unit / 0.5, std::round(c.p[i] / unit / 0.5), 1e-9);
      const double v = c.v[i] / unit * (made.file.units.x == "ms" ? 1000 : 1);
      EXPECT_NEAR(v, std::round(v), 1e-9);
    }
    EXPECT_GE(c.x.size(), 2U);
    EXPECT_TRUE(made.within_limit());
  }
}

/// The greatest third derivative of the pieces, at 65 places of each.
double greatest_jerk(const Played& played) {
  double greatest = 0;
  for (const Piece& piece : played.pieces)
    for (int k = 0; k <= 64; ++k) {
      const double u = piece.length * k / 64;
      greatest = std::max(greatest,
                          std::abs(6 * piece.c[3] + u * (24 * piece.c[4] + u * 60 * piece.c[5])));
    }
  return greatest;
}

/// Knots of a motion a minute after its start, 46 us apart: half a nanosecond of such an interval would
/// change its jerk a thousandfold.
TEST(ControllerFiles, KeepTheMotionAtWholeNanoseconds) {
  constexpr double begin = 60.0000000004, duration = 0.4, jerk = 60 * 40 / (0.4 * 0.4 * 0.4);
  Columns columns{{0}, {0}, {0}, {0}};
  const auto add = [&](double s) {
    columns.x.push_back(begin + s * duration);
    columns.p.push_back(40 * law_345(s));
    columns.v.push_back(40 * 30 * s * s * (1 - s) * (1 - s) / duration);
    columns.a.push_back(40 * 60 * s * (1 - s) * (1 - 2 * s) / (duration * duration));
  };
  for (const double s : {0.0, 0.25, 0.500000001, 0.500116, 0.75, 1.0}) add(s);
  const Input input =
      input_of({Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold, columns),
                {"s", "mm"},
                {}},
               "late.csv");
  const ExchangeFormat& ros = *exchange_format_named("ros");
  const Converted made = converted(input, {.rule = rule_of(ros), .format = &ros});
  ASSERT_EQ(made.file.table.size(), columns.x.size());
  const Played file = play_ros(exchange_text(ros, made.file));
  EXPECT_LT(1000 * greatest_jerk(file), 1.1 * jerk);
  ASSERT_TRUE(made.error);
  double velocity = 0, position = 0;  // the greatest errors, in mm
  for (const Piece& piece : file.pieces)
    for (int k = 1; k < 64; ++k) {
      const double u = piece.length * k / 64;
      const double s = (piece.from + u - begin) / duration;
      const double v =
          piece.c[1] +
          u * (2 * piece.c[2] + u * (3 * piece.c[3] + u * (4 * piece.c[4] + u * 5 * piece.c[5])));
      const double law = s < 0 ? 0 : 40 * 30 * s * s * (1 - s) * (1 - s) / duration;
      velocity = std::max(velocity, std::abs(1000 * v - law));
      position = std::max(position, std::abs(1000 * piece.at(piece.from + u) - 40 * law_345(s)));
    }
  EXPECT_LE(position, made.error->position + 1e-12);
  EXPECT_LE(velocity, made.error->velocity + 1e-8) << "the rounding of the witness";
  EXPECT_LT(made.error->velocity, 1e-5);
}

/// An S-curve that reaches its limits is exported: the file keeps them.
TEST(ControllerFiles, KeepTheLimitsOfAnSCurveAtWholeNanoseconds) {
  const Input input = inputs_of(parse_spec("jounce = 1\nkind = \"move\"\nunits = { position = "
                                           "\"mm\", time = \"s\" }\n[move]\nprofile = "
                                           "\"s_curve\"\nto = 100\nvelocity = 300\n"
                                           "acceleration = 3000\njerk = 1e6\n[limits]\n"
                                           "velocity = 300\nacceleration = 3000\njerk = 1e6\n",
                                           "rot.toml"),
                                "rot.toml")
                          .front();
  const ExchangeFormat& ros = *exchange_format_named("ros");
  const Converted made = converted(input, {.rule = rule_of(ros), .format = &ros});
  EXPECT_TRUE(made.keeps()) << (made.exceeded.findings.empty()
                                    ? ""
                                    : sentence(made.exceeded.findings.front(), input.labels));
  EXPECT_LT(1000 * greatest_jerk(play_ros(exchange_text(ros, made.file))), 1e6 * (1 + 1e-6));
}

/// Phases of jerk last 20.0003 us. Each has a knot that moves by up to 0.5 ns with the constant acceleration beside it.
/// The acceleration there changes by 0.5 ns of the jerk, and the jerk of the phase by 9 / 20 us of this.
TEST(ControllerFiles, MayExceedALimitByTheRoundingOfTheirTimes) {
  const std::string limits = "velocity = 2\nacceleration = 20.0003\njerk = 1e6\n";
  const Input input =
      inputs_of(parse_spec("jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
                           "profile = \"s_curve\"\nto = 4\n" +
                               limits + "[limits]\n" + limits,
                           "short.toml"),
                "short.toml")
          .front();
  const ExchangeFormat& ros = *exchange_format_named("ros");
  const Converted made = converted(input, {.rule = rule_of(ros), .format = &ros});
  EXPECT_TRUE(made.exceeded.ok()) << full_text(made.exceeded, input.labels);
  const double excess = 1000 * greatest_jerk(play_ros(exchange_text(ros, made.file))) / 1e6 - 1;
  EXPECT_GT(excess, 1e-4) << "the rounding acts";
  EXPECT_LT(excess, 9 * 0.5e-9 / 20e-6);
}

/// Knots move by up to 0.5 ns in tables with intervals of 1 us to 0.1 s. The witness makes the moved table, and
/// compares the peaks of each interval.
TEST(ControllerFiles, BoundTheRiseByTheRoundingOfTimes) {
  test::Random random(7);
  double tightest = 0;
  for (int n = 0; n < 200; ++n) {
    Columns c;
    double x = 0;
    for (int i = 0; i < 6; ++i) {
      c.x.push_back(x);
      x += random.log_uniform(1e-6, 0.1);
      c.p.push_back(random.uniform(-1, 1));
      c.v.push_back(random.uniform(-10, 10));
      c.a.push_back(random.uniform(-100, 100));
    }
    const auto table_of = [](const Columns& columns) {
      return Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold, columns);
    };
    const Table given = table_of(c);
    std::vector<double> moved;
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      moved.push_back(random.uniform(-0.5e-9, 0.5e-9));
      const std::size_t from = design_detail::motion_of_knot(given, i);
      const Segment f = given.segment(from);
      const Jet jet =
          evaluate(part(f, -0.5, 1.5), ((from == i ? 0 : 1) + moved[i] / f.length + 0.5) / 2);
      c.x[i] += moved[i];
      c.p[i] = jet[0];
      c.v[i] = jet[1];
      c.a[i] = jet[2];
    }
    const Table after = table_of(c);
    const std::vector<Jet> rises = design_detail::time_rounding(given, moved);
    for (std::size_t i = 0; i < rises.size(); ++i)
      for (std::size_t k = 1; k < 4; ++k) {
        const auto peak = [&](const Table& t) {
          const Segment f = t.segment(i);
          return std::abs(segment_range(f, 0, f.length, static_cast<int>(k)).peak().value);
        };
        const double rise = peak(after) - peak(given);
        const double rounding = 1e-9 * peak(given);
        EXPECT_LE(rise, rises[i][k] + rounding) << n << " " << i << " " << k;
        if (rises[i][k] > 1e3 * rounding) tightest = std::max(tightest, rise / rises[i][k]);
      }
  }
  EXPECT_GT(tightest, 0.3) << "the bound is not much greater than the rise";
}

TEST(ControllerFiles, ApplyTheSpacing) {
  const ExchangeFormat& ros = *exchange_format_named("ros");
  const Input input =
      input_of({Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                      {{0, 0.1, 0.5}, {0, 0, 40}, {0, 0, 0}, {0, 0, 0}}),
                {"s", "mm"},
                {}},
               "p.csv");
  const auto with = [&](double spacing, double x_step, std::optional<double> tolerance) {
    return converted(
        input, {.rule = rule_of(ros),
                .target = Target{.tolerance = tolerance, .spacing = spacing, .x_step = x_step},
                .format = &ros});
  };
  EXPECT_EQ(with(0.1, 0, {}).file.table.size(), 3U) << "its own knots keep the spacing";
  const Columns c = with(0.15, 0, 30.0).file.table.columns();
  for (std::size_t i = 1; i < c.x.size(); ++i) EXPECT_GE(c.x[i] - c.x[i - 1], 0.15 - 1e-9);
  EXPECT_THAT(test::error_of([&] { (void)with(0, 10, {}); }),
              ::testing::StartsWith(
                  "x_step = 10: permits no knots within the default tolerance, 0.004 mm"));
}

TEST(ControllerFiles, RejectRequirementsThatTheyCannotMeet) {
  const auto error = [](const Input& input, const char* name, const Target& target) {
    const ExchangeFormat& format = *exchange_format_named(name);
    return test::error_of([&] {
      (void)converted(input, {.rule = rule_of(format), .target = target, .format = &format});
    });
  };
  EXPECT_EQ(error(move_p(0.5), "galil-pvt", {.p_step = 0.001, .v_step = 1}),
            "v_step = 1: does not apply to the format galil-pvt, whose velocities follow from its "
            "counts");
  EXPECT_EQ(error(cam_e(), "pairs", {.v_step = 1}),
            "v_step = 1: does not apply to the format pairs, which contains no velocities");
  EXPECT_EQ(error(cam_e(), "trio", {.spacing = 5, .p_step = 0.001}),
            "spacing = 5: does not apply to knots at equal distances: give --most or --intervals");
  EXPECT_THAT(
      error(move_p(0.5), "galil-pvt", {.p_step = 1e-9}),
      HasSubstr("p_step = 1e-9: must be at least 1.86265e-8 mm: the controller holds counts in 32 "
                "bits"));
  EXPECT_EQ(error(input_of({Table(Domain::master, Interpolation::linear, Extrapolation::hold,
                                  {{0, 1}, {0, 90}, {}, {}}),
                            {"s", "mm"},
                            {}},
                           "t.csv"),
                  "ros", {}),
            "format = ros: is for motions over time; this table is a cam over a master in s: for a "
            "motion over "
            "time, name the first column of a CSV file time, give it to a spec of kind pvt (key "
            "points), and "
            "convert the spec");
}

TEST(ControllerFiles, StateTheToleranceOfOneCount) {
  const ExchangeFormat& galil = *exchange_format_named("galil-pvt");
  const auto counts = [&](double p_step) {
    return converted(
        move_p(0.5),
        {.rule = rule_of(galil), .target = Target{.p_step = p_step}, .format = &galil});
  };
  const Converted coarse = counts(0.5);
  EXPECT_EQ(coarse.counts, "position: 1 count is 0.5 mm; tolerance: 1 count");
  EXPECT_EQ(coarse.limit, 0.5);
  EXPECT_TRUE(coarse.within_limit());
  EXPECT_EQ(counts(0.001).counts, "position: 1 count is 0.001 mm");
}

TEST(ControllerFiles, OfEqualIntervalsAreInCounts) {
  const ExchangeFormat& trio = *exchange_format_named("trio");
  const Converted made = converted(cam_e(), {.rule = Interpolation::linear,
                                             .target = Target{.p_step = 0.001},
                                             .intervals = 360,
                                             .format = &trio});
  EXPECT_EQ(made.file.table.size(), 361U);
  for (const double p : made.file.table.columns().p) EXPECT_EQ(p, std::round(p));
  EXPECT_TRUE(made.within_limit());
}

TEST(ControllerFiles, BeginAndEndAtRestWhereTheFormatDoes) {
  const ExchangeFormat& xps = *exchange_format_named("xps");
  const TableFile moving{Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                               {{0, 1}, {0, 1}, {0, 1}, {}}),
                         {"s", "mm"},
                         {}};
  EXPECT_THAT(test::error_of([&] { (void)exchange_text(xps, moving); }),
              HasSubstr("velocity = 1: must be 0 at both ends"));
}

}  // namespace
}  // namespace jounce::controller_files_test

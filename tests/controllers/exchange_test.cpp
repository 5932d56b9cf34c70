// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/exchange/exchange.hpp"

#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::exchange_test {
namespace {

/// A table whose numbers do not print in few digits.
TableFile ragged(Interpolation rule, Extrapolation outside = Extrapolation::wrap,
                 std::size_t knots = 40) {
  test::Random random(7);
  Columns c;
  double x = -3.3;
  for (std::size_t i = 0; i < knots; ++i) {
    x += random.log_uniform(1e-6, 1e3);
    c.x.push_back(x);
    c.p.push_back(random.uniform(-1, 1) * random.log_uniform(1e-300, 1e300));
    if (rule != Interpolation::quintic_hermite) continue;
    c.v.push_back(random.uniform(-1, 1) / 3);
    c.a.push_back(i == 3 ? -0.0
                         : random.uniform(-1, 1) * std::numeric_limits<double>::denorm_min() * 1e3);
  }
  return {Table(Domain::master, rule, outside, std::move(c)), {"deg", "mm"}, {}};
}

std::string written(const char* format, const TableFile& file) {
  return exchange_text(*exchange_format_named(format), file);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void expect_same_columns(const TableFile& a, const TableFile& b) {
  EXPECT_EQ(a.table.rule(), b.table.rule());
  EXPECT_TRUE(same_bits(a.table.columns().x, b.table.columns().x));
  EXPECT_TRUE(same_bits(a.table.columns().p, b.table.columns().p));
  EXPECT_TRUE(same_bits(a.table.columns().v, b.table.columns().v));
  EXPECT_TRUE(same_bits(a.table.columns().a, b.table.columns().a));
}

TEST(Exchange, ReadsBackBitExact) {
  for (const char* word : {"xyva", "codesys", "plcopen", "twincat", "siemens", "pairs", "sew"})
    for (const Extrapolation outside : {Extrapolation::wrap, Extrapolation::hold}) {
      SCOPED_TRACE(word);
      const ExchangeFormat& format = *exchange_format_named(word);
      const TableFile file = ragged(rule_of(format), outside);
      const std::string text = exchange_text(format, file);
      EXPECT_EQ(exchange_format_of_text(text), &format);
      expect_same_columns(file, parse_exchange(text, "t"));
    }
}

TEST(Exchange, KeepsUnitsPolicyAndHashWhereThereAreComments) {
  for (const char* word : {"xyva", "codesys", "plcopen", "twincat", "siemens"}) {
    SCOPED_TRACE(word);
    const ExchangeFormat& format = *exchange_format_named(word);
    for (const Extrapolation outside :
         {Extrapolation::hold, Extrapolation::wrap, Extrapolation::advance}) {
      const TableFile file = ragged(rule_of(format), outside);
      const TableFile back = parse_exchange(exchange_text(format, file), "t");
      EXPECT_EQ(back.table.outside(), outside);
      EXPECT_EQ(content_hash(back.table, back.units), content_hash(file.table, file.units));
    }
  }
}

std::string complaint(const std::string& text, bool decimal_comma = false) {
  return test::error_of([&] { (void)parse_exchange(text, "t", decimal_comma); });
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(Exchange, RejectsEveryTruncationThatDropsAKnotOrADigit) {
  const TableFile file = ragged(Interpolation::quintic_hermite, Extrapolation::hold, 4);
  for (const char* word : {"xyva", "codesys", "plcopen", "twincat", "siemens"}) {
    const std::string text = written(word, file);
    const std::size_t end = word == std::string("xyva") ? text.size() - 1 : text.find("];") + 1;
    for (std::size_t length = 0; length < end; ++length)
      EXPECT_NE(complaint(text.substr(0, length)), "") << text.substr(0, length);
  }
}

TEST(Exchange, RejectsOrKeepsEveryChangedByte) {
  const TableFile file = ragged(Interpolation::quintic_hermite, Extrapolation::hold, 4);
  for (const char* word : {"xyva", "codesys", "plcopen", "twincat", "siemens"}) {
    const std::string text = written(word, file);
    const std::size_t first = text.find("sha256");
    for (std::size_t i = text.find('\n', first); i < text.size(); ++i)
      for (const char c : {'0', '9', '-', ' ', '\n', 'x', ',', '\0', '\xff'}) {
        std::string changed = text;
        changed[i] = c;
        try {
          const TableFile back = parse_exchange(changed, "t");
          EXPECT_EQ(content_hash(back.table, back.units), content_hash(file.table, file.units));
        } catch (const InputError&) {
        }
      }
  }
}

TEST(Exchange, ReadsTheDefaultCamOfCodesys) {
  const std::string path = JOUNCE_SOURCE_DIR "/examples/codesys-default/cam.xyva";
  const TableFile file = parse_exchange(read_file(path), path);
  EXPECT_EQ(file.table.outside(), Extrapolation::hold);
  EXPECT_EQ(file.units.x, "");
  const Cam cam = file.table.curve<OverMaster>();
  // The quintic of slope 1 over its chord of slope 1: y = 120 (6 s^3 - 8 s^4 + 3 s^5).
  EXPECT_NEAR(cam.at(60).position, 120 * (6.0 / 8 - 8.0 / 16 + 3.0 / 32), 1e-12);
  // y' = 18 s^2 - 32 s^3 + 15 s^4, whose maximum is at s = 3/5: it overshoots the slope of the stretch.
  EXPECT_NEAR(extrema(cam, 1).max.value, 18 * 0.36 - 32 * 0.216 + 15 * 0.1296, 1e-14);
  EXPECT_NEAR(cam.at(180).geo_velocity, 1, 1e-14);
}

TEST(Exchange, ReadsADeclarationAsPeopleWriteIt) {
  const TableFile file = parse_exchange(
      "(* a cam,\n   SMC_CAMXYVA *)\nVAR\n"
      "cam : ARRAY[1..3] OF SMC_CAMXYVA := [(dX:=0), // dX := 7\n"
      "  (dY:=5,dX:=100,dV:=0.5),(dX := 2.0E2, dY := 10, dV := -1, dA := 0.25)];\n"
      "ref : MC_CAM_REF := (nElements := 3);\nEND_VAR\n",
      "t");
  EXPECT_EQ(file.table.columns().x, (std::vector<double>{0, 100, 200}));
  EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(file.table.columns().v, (std::vector<double>{0, 0.5, -1}));
  EXPECT_EQ(file.table.columns().a, (std::vector<double>{0, 0, 0.25}));
}

// IEC 61131-3: a number before an initial value repeats it.
TEST(Exchange, ReadsRepeatedElements) {
  const auto read = [](const std::string& values) {
    return parse_exchange("a : ARRAY[1..3] OF SMC_CAMXYVA := [" + values + "];", "t");
  };
  const std::string first = "(dX := 0), 1((dX := 180, dY := 40)), ";
  EXPECT_EQ(read(first + "(dX := 360)").table.columns().p, (std::vector<double>{0, 40, 0}));
  const auto error = [](const std::string& values) {
    return complaint("a : ARRAY[1..3] OF SMC_CAMXYVA := [(dX := 0), " + values + "];");
  };
  EXPECT_NE(error("2((dX := 180))").find("must be greater than 180"), std::string::npos);
  EXPECT_NE(error("3((dX := 180))").find("there are 4"), std::string::npos);
  EXPECT_NE(error("0((dX := 180))").find("must be from 1 to 32767"), std::string::npos);
  EXPECT_NE(error("2000000000((dX := 180))").find("must be from 1 to 32767"), std::string::npos);
}

TEST(Exchange, NamesACamOfPointsWithoutSlopes) {
  const std::string text = "a : ARRAY[0..1] OF SMC_CAMXY_LREAL := [(dX := 0), (dX := 1)];";
  EXPECT_NE(exchange_format_of_text(text), nullptr);
  EXPECT_NE(complaint(text).find("SMC_CAMXY: has points without slopes"), std::string::npos)
      << complaint(text);
}

TEST(Exchange, WritesADeclarationThatCodesysUnderstands) {
  const TableFile file{Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::hold,
                             {{0, 360}, {0, 1e-9}, {0, 0}, {0, 0}}),
                       {},
                       {}};
  const std::string text = written("codesys", file);
  EXPECT_NE(text.find("ARRAY[0..1] OF SMC_CAMXYVA"), std::string::npos);
  EXPECT_NE(text.find("(dX := 360.0, dY := 1.0e-09, dV := 0.0, dA := 0.0)"), std::string::npos)
      << "a REAL literal has a decimal point\n"
      << text;
  EXPECT_NE(text.find("byType := 3, nElements := 2, xStart := 0.0, xEnd := 360.0"),
            std::string::npos);
}

TEST(Exchange, ReadsColumnsHoweverTheyAreSeparated) {
  for (const char* text : {"0 0 0 0\n1 2 0 0\n", "0,0,0,0\n1,2,0,0\n", "0, 0, 0, 0\n1, 2, 0, 0\n",
                           "0;0;0;0\r\n1;2;0;0\r\n", "x y v a\n\n0 0 0 0 // start\n1 2 0 0",
                           "X\tY\tV\tA\tJ\tType\n0\t0\t0\t0\t0\t\n1\t2\t0\t0\t0\tPoly5\n"}) {
    const TableFile file = parse_exchange(text, "t");
    EXPECT_EQ(file.table.columns().x, (std::vector<double>{0, 1})) << text;
    EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, 2})) << text;
    EXPECT_EQ(file.table.rule(), Interpolation::quintic_hermite);
  }
}

TEST(Exchange, ReadsCommentsAndSeparatorsAtTheEndOfALine) {
  for (const char* text : {"0 0 // start\n1 2 // end\n", "0 0 //start\n1 2\n", "0;0;\n1;2;\n",
                           "0;0\n1;2;  // end\n", "0, 0,\n1, 2,\n"}) {
    const TableFile file = parse_exchange(text, "t");
    EXPECT_EQ(file.table.columns().x, (std::vector<double>{0, 1})) << text;
    EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, 2})) << text;
    EXPECT_EQ(file.table.rule(), Interpolation::linear) << text;
  }
  EXPECT_EQ(parse_exchange("0;0;0;0;\n1;2;0;0;\n", "t").table.rule(),
            Interpolation::quintic_hermite);
  EXPECT_NE(complaint("0;0;;\n1;2;;\n"), "");
}

TEST(Exchange, ReadsDecimalCommasOnlyWhereTheyAreMeant) {
  EXPECT_EQ(complaint("0 0\n1 0,5\n"),
            "t:2: Y = \"0,5\": has a decimal comma: write 0.5, or convert the file with "
            "`jounce convert --decimal-comma`");
  EXPECT_EQ(parse_exchange("2\n0;0\n1,5;0,5\n", "t", true).table.columns().x[1], 1.5);
  EXPECT_EQ(complaint("0,0 0,0 0,0 0,0\n", false).substr(0, 11), "t:1: X = \"0");
  EXPECT_EQ(
      complaint("x,y,v,a\n0,0,0,0\n1,0,2,5,0,0,0,0\n"),
      "t:3: has 8 values, but the header has 4 columns: if these are decimal commas, convert the "
      "file with "
      "`jounce convert --decimal-comma`");
}

TEST(Exchange, NamesFileLineKeyValueAndRule) {
  const std::string good = "X\tY\tV\tA\n0\t0\t0\t0\n1\t2\t0\t0\n2\t3\t0\t0\n";
  EXPECT_EQ(complaint(good), "");
  EXPECT_EQ(complaint(replaced(good, "1\t2", "1\tnan")),
            "t:3: Y = \"nan\": must be a finite number");
  EXPECT_EQ(complaint(replaced(good, "1\t2", "0\t2")),
            "t:3: knot[2].master = 0: must be greater than 0, the previous knot");
  EXPECT_EQ(complaint(replaced(good, "2\t3\t0\t0", "2\t3\t0")),
            "t:4: has 3 values, but the header has 4 columns");
  EXPECT_EQ(complaint(replaced(good, "X\tY\tV\tA", "X\tY\tA\tV")).substr(0, 13), "t:1: columns ");
  EXPECT_EQ(
      complaint("5\n0;0\n1;1\n"),
      "t:1: number of points = 5: the number of points in the file is 2: is the file complete?");
  EXPECT_EQ(complaint("1 2 3 4\n"), "t: knots = 1: must be at least 2");
  EXPECT_EQ(complaint("# knots: 9\n" + good),
            "t:1: knots = 9: the number of knots in the file is 3: is the file complete?");
  EXPECT_EQ(complaint("# master: degrie\n" + good), "t:1: master = degrie: is not a known unit");
  EXPECT_NE(complaint("CYCLIC;YES;\nTABLE_BEGIN;;\n0;0;SPLINE\n").find("KAS"), std::string::npos);
  EXPECT_EQ(
      exchange_format_of_text("It reads `SMC_CAMXYVA` declarations and MC_MotionFunctionPoint.\n"),
      nullptr);
  EXPECT_NE(exchange_format_of_text("a : ARRAY[0..2]\n  of SM3_Basic.SMC_CamXYVA;\n"), nullptr);
  EXPECT_NE(complaint("a : ARRAY[0..2] OF SMC_CAMXYVA := [(dX := 0), (dX := 1)];"), "");
  EXPECT_NE(complaint("a : ARRAY[0..1] OF SMC_CAMXYVA := [(dX := 0), (dZ := 1)];"), "");
}

TEST(Exchange, DistinguishesASpecFromATable) {
  EXPECT_FALSE(exchange_format_of_text("jounce = 1\nkind = \"cam\"\n"));
  EXPECT_FALSE(exchange_format_of_text("# 1 2 3 4\n[limits]\n"));
  EXPECT_FALSE(exchange_format_of_text(""));
  EXPECT_FALSE(exchange_format_of_text(to_csv(ragged(Interpolation::linear))));
  EXPECT_EQ(exchange_format_of_text("0 0 0 nan\n"), exchange_format_named("xyva"))
      << "so that it is refused as one";
}

TEST(Exchange, RejectsWhatAFormatCannotHold) {
  EXPECT_THROW((void)written("xyva", ragged(Interpolation::linear)), InputError);
  EXPECT_THROW((void)written("pairs", ragged(Interpolation::quintic_hermite)), InputError);
  EXPECT_THROW((void)written("kollmorgen", ragged(Interpolation::linear, Extrapolation::hold, 4)),
               InputError);
  const TableFile timed{
      Table(Domain::time, Interpolation::linear, Extrapolation::hold, {{0, 1}, {0, 1}, {}, {}}),
      {"s", "mm"},
      {}};
  EXPECT_THROW((void)written("pairs", timed), InputError);
}

TEST(Exchange, WritesWhatKasImports) {
  const TableFile file{Table(Domain::master, Interpolation::linear, Extrapolation::wrap,
                             {{0, 1, 2, 3, 4}, {0, 0.5, 2, 0.5, 0}, {}, {}}),
                       {},
                       {}};
  EXPECT_EQ(written("kollmorgen", file),
            "CYCLIC;YES;\nTABLE_BEGIN;;\n0;0;SPLINE\n1;0.5;SPLINE\n2;2;SPLINE\n3;0.5;SPLINE\n4;0;"
            "SPLINE\nTABLE_END;;\n");
}

// Output of "Display generated code" of the cam editor (CODESYS SoftMotion), in manual formatting.
const std::string generated =
    "{attribute 'linkalways'}\nVAR_GLOBAL\n"
    "  e_a : array[0..2] of smc_camxyva := [(dx := LREAL#0.0, DY := 0),\n"
    "    (dX := 1_80, dY := - 40, dV := LREAL#-0.5), (dX := 360.0, dY := 0)];\n"
    "  E : MC_Cam_Ref := (nElements := 3, byType := 3, xStart := 0, xEnd := 360, nTappets := 2,\n"
    "    strCAMName := 'E, the (* first', pce := adr(E_A), xPartofLM := TRUE);\n"
    "  F_A : ARRAY[1..2] OF SM3_Basic.SMC_CAMXYVA := [(dX := 0), (dX := 100, dY := 7)];\n"
    "  F : MC_CAM_REF := (byType := SMC_CAM_TYPE.XYVA, xStart := 0, xEnd := 100,\n"
    "    pce := ADR(GVL.F_A), wCamStructID := 16#DC34);\n"
    "  limits : ARRAY[0..N] OF LREAL;\nEND_VAR\n";

TEST(Exchange, ReadsAllCamsOfGeneratedCode) {
  EXPECT_FALSE(is_table(generated)) << "its first sign is a brace";
  EXPECT_EQ(exchange_format_of_text(generated), exchange_format_named("codesys"));
  const auto cams = parse_exchange_tables(generated, "t");
  ASSERT_EQ(cams.size(), 2U);
  EXPECT_EQ(cams[0].name, "E");
  EXPECT_EQ(cams[0].file.table.columns().x, (std::vector<double>{0, 180, 360}));
  EXPECT_EQ(cams[0].file.table.columns().p, (std::vector<double>{0, -40, 0}));
  EXPECT_EQ(cams[0].file.table.columns().v, (std::vector<double>{0, -0.5, 0}));
  EXPECT_EQ(cams[0].unread, (std::vector<std::string>{"2 tappets of E are not read"}));
  EXPECT_EQ(cams[1].name, "F");
  EXPECT_EQ(cams[1].file.table.columns().p, (std::vector<double>{0, 7}));
  EXPECT_TRUE(cams[1].unread.empty());
  EXPECT_EQ(complaint(generated), "t:1: contains several cams; choose one with --axis: E, F");
}

TEST(Exchange, ReadsCamsOfOursOneAfterAnother) {
  const TableFile first = ragged(Interpolation::quintic_hermite, Extrapolation::wrap, 5);
  const TableFile second = ragged(Interpolation::quintic_hermite, Extrapolation::hold, 9);
  const auto cams =
      parse_exchange_tables(written("codesys", first) + written("codesys", second), "t");
  ASSERT_EQ(cams.size(), 2U);
  for (const auto& [cam, file] : {std::pair{&cams[0], &first}, {&cams[1], &second}})
    EXPECT_EQ(content_hash(cam->file.table, cam->file.units),
              content_hash(file->table, file->units));
}

TEST(Exchange, ReadsTheFormOfCoDeSys23) {
  const TableFile file = parse_exchange(
      "VAR_GLOBAL\n A : ARRAY[1..2] OF SMC_CAMXYVA := (dX:=0,dY:=0,dV:=0,dA:=0),\n"
      "  (dX:=360,dY:=-1.5E+1,dV:=0,dA:=0);\n R : MC_CAM_REF := (byType:=3, xStart:=0, "
      "xEnd:=360);\n",
      "t");
  EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, -15}));
}

TEST(Exchange, RejectsARangeOfTheMasterThatThePointsDoNotCover) {
  EXPECT_EQ(complaint(replaced(generated, "xEnd := 360", "xEnd := 400")),
            "t:5: E.xEnd = 400: the last point is at 360: the points must cover the master's range "
            "(errors 751 and 752 of the controllers)");
  EXPECT_NE(complaint(replaced(generated, "xStart := 0", "xStart := 10")).find("E.xStart = 10"),
            std::string::npos);
  EXPECT_NE(
      complaint(replaced(generated, "nElements := 3", "nElements := 4")).find("E.nElements = 4"),
      std::string::npos);
  EXPECT_NE(
      complaint(replaced(generated, "adr(E_A)", "adr(G_A)")).find("is not an array of SMC_CAMXYVA"),
      std::string::npos);
  EXPECT_NE(complaint(replaced(generated, "byType := 3", "byType := 2")).find("must be 3"),
            std::string::npos);
  EXPECT_NE(complaint(replaced(generated, "1_80", "16#B4")).find("decimal number"),
            std::string::npos);
}

TEST(Exchange, RejectsMorePointsThanSewHolds) {
  const auto points = [](std::size_t n) {
    Columns c;
    for (std::size_t i = 0; i < n; ++i) {
      c.x.push_back(static_cast<double>(i));
      c.p.push_back(0);
    }
    return TableFile{
        Table(Domain::master, Interpolation::linear, Extrapolation::hold, std::move(c)), {}, {}};
  };
  EXPECT_NO_THROW((void)written("sew", points(16383)));
  EXPECT_THROW((void)written("sew", points(16384)), InputError);
}

}  // namespace
}  // namespace jounce::exchange_test

// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/table_file.hpp"

#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/base/detail/lcm_log.hpp"
#include "jounce/base/file.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::table_file_test {
namespace {

/// A table whose numbers do not print in few digits.
TableFile ragged(Interpolation rule = Interpolation::quintic_hermite, std::size_t knots = 40) {
  test::Random random(5);
  Columns c;
  double x = -3.3;
  for (std::size_t i = 0; i < knots; ++i) {
    x += random.log_uniform(1e-6, 1e3);
    c.x.push_back(x);
    c.p.push_back(random.uniform(-1, 1) * random.log_uniform(1e-300, 1e300));
    if (rule != Interpolation::linear) c.v.push_back(random.uniform(-1, 1) / 3);
    if (rule == Interpolation::quintic_hermite)
      c.a.push_back(
          i == 3 ? -0.0 : random.uniform(-1, 1) * std::numeric_limits<double>::denorm_min() * 1000);
  }
  return {Table(Domain::master, rule, Extrapolation::wrap, std::move(c)),
          {"deg", "mm"},
          {"a cam.toml", std::string(64, 'a'), "jounce test"}};
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void expect_same(const TableFile& a, const TableFile& b) {
  EXPECT_EQ(a.table.rule(), b.table.rule());
  EXPECT_EQ(a.table.axis(), b.table.axis());
  EXPECT_EQ(a.table.outside(), b.table.outside());
  EXPECT_EQ(a.units.x, b.units.x);
  EXPECT_EQ(a.units.position, b.units.position);
  EXPECT_EQ(a.provenance.spec, b.provenance.spec);
  EXPECT_EQ(a.provenance.spec_sha256, b.provenance.spec_sha256);
  EXPECT_EQ(a.provenance.made_by, b.provenance.made_by);
  EXPECT_TRUE(same_bits(a.table.columns().x, b.table.columns().x));
  EXPECT_TRUE(same_bits(a.table.columns().p, b.table.columns().p));
  EXPECT_TRUE(same_bits(a.table.columns().v, b.table.columns().v));
  EXPECT_TRUE(same_bits(a.table.columns().a, b.table.columns().a));
}

/// The file in all formats that Jounce reads.
std::vector<std::string> texts_of(const TableFile& file) {
  std::vector<std::string> all;
  for (const OwnForm& form : own_forms())
    if (form.readable) all.push_back(form.write(file));
  EXPECT_EQ(all.size(), 4U);
  return all;
}

TEST(TableFile, ReadsBackBitExactInEachFormat) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
    const TableFile file = ragged(rule);
    for (const std::string& text : texts_of(file)) {
      EXPECT_TRUE(is_table(text));
      expect_same(file, parse_table(text, "t"));
    }
  }
}

TEST(TableFile, FormatsAreNamedByTheirEndings) {
  for (const OwnForm& form : own_forms())
    EXPECT_STREQ(own_form_of_path(std::string("a") + form.ending)->name, form.name);
  EXPECT_EQ(own_form_of_path("a.st"), nullptr);
  EXPECT_TRUE(table_text("a.mcap", ragged()).starts_with("\x89MCAP0\r\n"));
  EXPECT_TRUE(table_text("a.npy", ragged()).starts_with("# jounce table")) << "not readable";
}

TEST(TableFile, OtherLogsAreNoTables) {
  std::string log;
  base_detail::append(log, 0, 0, "JOUNCE.axis", "data");
  EXPECT_FALSE(is_table(log)) << "a record";
  const std::string mcap = to_mcap(ragged());
  std::string other = mcap;
  other.replace(other.find("jounce-table"), 12, "ros2-foxy-it");
  EXPECT_FALSE(is_table(other));
  const std::string table = to_lcm_log(ragged());
  EXPECT_EQ(test::error_of([&] { (void)parse_table(table + log, "t"); }),
            "t: contains more than one event: a file contains one table");
}

TEST(TableFile, HashesTheSameInBothFormatsAndForNothingElse) {
  const TableFile file = ragged();
  const auto hash = content_hash(file.table, file.units);
  const TableFile back = parse_table(to_json(file), "t.json");
  EXPECT_EQ(hash, content_hash(back.table, back.units));
  EXPECT_NE(hash, content_hash(file.table, {"deg", "m"})) << "the unit belongs to the content";
  EXPECT_NE(hash, content_hash(ragged(Interpolation::cubic_hermite).table, file.units));
}

TEST(TableFile, TheHashIsTheOneOfTheProtocolPage) {
  // Python's hashlib: h = lambda *c: sha256(pack('<%dd' % len(c), *c)).digest();
  // sha256(b'jounce table, by columns\ntime\ncubic_hermite\nhold\ns\nmm\n3\n' +
  //        h(0, 1, 3) + h(0, .5, 2) + h(0, 1, 0)).hexdigest()
  const Table table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                    {{0, 1, 3}, {0, 0.5, 2}, {0, 1, 0}, {}});
  EXPECT_EQ(hex(content_hash(table, {"s", "mm"})),
            "1c504ad0bae4a3480ad43b1b894a67857a2dfbad0585394198cedba823dc850e");
}

TEST(TableFile, TheHashIsSha256) {
  EXPECT_EQ(hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")
      << "FIPS 180-4";
}

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)parse_table(text, "t"); });
}

TEST(TableFile, RejectsEveryTruncation) {
  const TableFile file = ragged(Interpolation::cubic_hermite, 4);
  for (const std::string& text : texts_of(file))
    for (std::size_t length = 0; length + 1 < text.size();
         ++length)  // a last line end may be missing
      EXPECT_NE(complaint(text.substr(0, length)), "") << text.substr(0, length);
}

TEST(TableFile, RejectsOrKeepsEveryChangedByte) {
  // For every changed byte, the table read is the table written, or there is an error.
  const TableFile file = ragged(Interpolation::cubic_hermite, 4);
  for (const std::string& text : texts_of(file))
    for (std::size_t i = 0; i < text.size(); ++i)
      for (const char c : {'0', '9', '-', ' ', '\n', 'x', '\0', '\xff'}) {
        std::string changed = text;
        changed[i] = c;
        try {
          const TableFile back = parse_table(changed, "t");
          EXPECT_EQ(content_hash(back.table, back.units), content_hash(file.table, file.units));
        } catch (const InputError&) {
        }
      }
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TableFile small() {
  return {Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                {{0, 1, 3}, {0, 2, 5}, {0, 1.5, 0}, {}}),
          {"s", "mm"},
          {}};
}

TEST(TableFile, NamesLineKeyValueAndRule) {
  const std::string csv = to_csv(small());
  EXPECT_EQ(complaint(""), "t:1: the file is empty");
  EXPECT_EQ(complaint(replaced(csv, "table 1", "table 7")),
            "t:1: jounce table = 7: must be 1, the format version that this program reads");
  EXPECT_EQ(complaint(csv.substr(0, csv.find("# outside"))),
            "t:3: the file ends within its head, before outside: export it again");
  EXPECT_EQ(
      complaint(replaced(csv, "# outside", "1,2,3\n# outside")),
      "t:4: the head of the table continues below this row: remove the row, or export the file "
      "again");
  EXPECT_EQ(complaint(replaced(csv, "# sha256", "# spec")),
            "t:6: sha256: is missing from the head of the table: export the file again");
  EXPECT_EQ(complaint(replaced(csv, "# rule: cubic_hermite", "# rule: cubic")),
            "t:3: rule = \"cubic\": must be one of linear, cubic_hermite, quintic_hermite");
  EXPECT_EQ(complaint(replaced(csv, "1,2,1.5", "1,nan,1.5")),
            "t:9: column 2 = \"nan\": must be a finite number");
  EXPECT_EQ(complaint(replaced(csv, "1,2,1.5", "1,2")), "t:9: row = 2 values: must have 3");
  EXPECT_EQ(complaint(replaced(csv, "1,2,1.5\n", "")),
            "t:5: knots = 3: the number of rows in the file is 2: is the file complete?");
  EXPECT_EQ(complaint(replaced(csv, "1,2,1.5", "0,2,1.5")),
            "t:9: knot[2].time = 0: must be greater than 0, the previous knot");
  EXPECT_EQ(complaint(replaced(csv, "[mm/s]", "[mm/min]")),
            "t:7: velocity = [mm/min]: does not match the position, which is in mm: the unit must "
            "be mm/s");
  EXPECT_TRUE(complaint(replaced(csv, "1,2,1.5", "1,2.5,1.5")).find("does not match the content") !=
              std::string::npos);
  EXPECT_TRUE(complaint(replaced(csv, "[mm]", "[cm]")).find("the unit must be cm/s") !=
              std::string::npos);

  const std::string json = to_json(small());
  EXPECT_EQ(complaint(json.substr(0, json.size() / 2)),
            "t: is not complete: the file ends within its JSON; export it again");
  EXPECT_EQ(complaint(replaced(json, "\"axis\": ", "\"axis\" ")),
            "t:3: is not JSON: its syntax is wrong here");
  EXPECT_EQ(complaint(replaced(json, "\"jounce_table\": 1", "\"jounce_table\": 2")),
            "t: jounce_table = 2: must be 1, the format version that this program reads");
  EXPECT_EQ(complaint(replaced(json, "\"knots\": 3", "\"knots\": 3, \"knots\": 3")),
            "t: knots: is given twice: remove one");
  EXPECT_EQ(complaint(replaced(json, "1.5", "null")),
            "t: columns.velocity[2] = null: must be a finite number");
  EXPECT_EQ(complaint(replaced(json, "\"axis\": \"time\",", "")),
            "t: axis: is missing: a Jounce table in JSON needs this key");
}

TEST(WriteFile, LeavesNothingBehindWhenItCannotWrite) {
  EXPECT_THROW(write_file("/nonexistent/folder/t.csv", "x"), std::system_error);
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "taken");
  EXPECT_THROW(write_file(folder / "taken", "x"), std::system_error) << "a folder stands there";
  write_file(folder / "t.csv", "old");
  write_file(folder / "t.csv", "new");
  EXPECT_EQ(read_file(folder / "t.csv"), "new");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
    ++files;
  EXPECT_EQ(files, 2U) << "no temporary name is left";
}

}  // namespace
}  // namespace jounce::table_file_test

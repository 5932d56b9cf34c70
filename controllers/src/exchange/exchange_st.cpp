// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/st_reader.hpp"

// A cam as CODESYS SoftMotion declares it (library SM3_Basic, MC_CAM_REF and SMC_CAMXYVA): an array
// of points, each with dX (master), dY (slave), dV = dY/dX and dA = d2Y/dX2, and a reference to it.
namespace jounce::controllers_detail {
namespace {

constexpr std::array fields{"dx", "dy", "dv", "da"};
constexpr std::size_t most_points =
    std::numeric_limits<std::int16_t>::max();  // nElements is an INT

/// A REAL literal of IEC 61131-3, which has a decimal point.
std::string real(double value) {
  std::string text = number(value);
  if (text.find('.') != text.npos) return text;
  const auto e = text.find('e');
  return text.insert(e == text.npos ? text.size() : e, ".0");
}

/// `(dX := 0, dY := 0, ...)` after its parenthesis; what is left out is 0, as in the language.
std::array<double, 4> point(StReader& code) {
  std::array<double, 4> values{};
  std::array<bool, 4> given{};
  for (std::string sign = ","; sign == ",";) {
    const std::string word = code.next();
    const auto field = std::find(fields.begin(), fields.end(), word);
    if (field == fields.end()) code.fail("point", word, "must be one of dX, dY, dV, dA");
    const auto i = static_cast<std::size_t>(field - fields.begin());
    const std::string key = std::string("d") + "XYVA"[i];
    if (std::exchange(given[i], true)) code.fail(key, "", "is there twice: remove one");
    code.expect(":=");
    values[i] = code.number(key);
    sign = code.next();
    if (sign != "," && sign != ")")
      code.fail("point", sign, sign.empty() ? "ends: is the file complete?" : "must be `,` or `)`");
  }
  return values;
}

/// `[(...), (...)]`; in CoDeSys 2.3 without the brackets.
void read_points(StReader& code, Exchanged& cam) {
  if (code.peek() == ";") code.fail("points", "", "are missing: give the array initial values");
  code.expect(":=");
  const bool bracket = code.peek() == "[";
  if (bracket) code.expect("[");
  for (std::string sign = ","; sign == ",";) {
    code.expect("(");
    const int line = code.line();
    const auto [x, y, v, a] = point(code);
    cam.columns.x.push_back(x);
    cam.columns.p.push_back(y);
    cam.columns.v.push_back(v);
    cam.columns.a.push_back(a);
    cam.lines.push_back(line);
    sign = code.next();
    if (sign != "," && sign != (bracket ? "]" : ";"))
      code.fail("points", sign,
                sign.empty() ? "end: is the file complete?"
                             : std::string("must be `,` or `") + (bracket ? "]`" : ";`"));
  }
}

/// Number of points of `[0..4]`.
double points_of_range(StReader& code) {
  code.expect("[");
  const double first = code.number("ARRAY");
  code.expect("..");
  const double last = code.number("ARRAY");
  code.expect("]");
  return last - first + 1;
}

/// Without the names of libraries and lists before the last point.
std::string unqualified(const std::string& name) {
  return name.substr(name.find_last_of('.') + 1);
}

/// Fields of an MC_CAM_REF.
struct Reference {
  struct Stated {
    double value = 0;
    int line = 0;
  };
  std::string name;
  std::string array;      ///< name in ADR(...), in lower case; empty if not given
  std::size_t after = 0;  ///< arrays declared before it
  bool xyva = true;       ///< its byType
  int line = 0;
  std::map<std::string, Stated> numbers = {};  ///< by their keys in lower case
};

constexpr std::array numbers_of_reference{"nelements", "ntappets", "xstart", "xend"};

/// `(byType := 3, nElements := 5, ...)`; nothing where it has no initial value.
Reference read_reference(StReader& code) {
  Reference reference;
  reference.line = code.line();
  if (code.peek() == ":=") static_cast<void>(code.next());
  if (code.peek() != "(") return reference;
  for (std::string sign = code.next(); sign == "(" || sign == ","; sign = code.next()) {
    const std::string key = code.next();
    code.expect(":=");
    if (key == "pce" && code.peek() == "adr") {
      static_cast<void>(code.next());
      code.expect("(");
      reference.array = unqualified(code.next());
      code.expect(")");
    } else if (key == "bytype") {
      const std::string type = unqualified(code.next());
      reference.xyva = type == "3" || type == "xyva";
    } else if (std::count(numbers_of_reference.begin(), numbers_of_reference.end(), key) > 0) {
      const double value = code.number(key);
      reference.numbers[key] = {value, code.line()};
    }
    code.skip_value();
  }
  return reference;
}

/// Declarations of a file, in its order.
struct Declared {
  std::vector<Exchanged> arrays;
  std::vector<Reference> references;
};

/// Behind `ARRAY`: one of points is a cam, every other is skipped.
void read_array(StReader& code, const std::string& name, Declared& all) {
  const StReader::Mark range = code.here();
  std::string word = code.next();
  while (word != "of" && word != ";" && !word.empty()) word = code.next();
  if (word != "of" || unqualified(code.next()) != "smc_camxyva") return;
  const StReader::Mark values = code.here();
  code.go_to(range);
  const double points = points_of_range(code);
  code.go_to(values);
  Exchanged cam{.name = name};
  read_points(code, cam);
  const std::size_t count = cam.lines.size();
  if (points != static_cast<double>(count))
    code.fail("ARRAY", jounce::number(points) + " points",
              "there are " + std::to_string(count) + ": is the file complete?");
  all.arrays.push_back(std::move(cam));
}

Declared declared(const std::string& text, const Place& place) {
  StReader code(text, place);
  Declared all;
  std::string name;  // the word before the last colon
  std::string before;
  for (std::string word = code.name(); !word.empty(); word = code.name()) {
    const std::string type = lower(unqualified(word));
    if (word == ":") name = before;
    if (type == "array") read_array(code, name, all);
    if (type == "mc_cam_ref" && before == ":") {
      all.references.push_back(read_reference(code));
      all.references.back().name = name;
      all.references.back().after = all.arrays.size();
    }
    before = word;
  }
  return all;
}

/// The array that it refers to; null where that is none of points. Without ADR(...) it is the one before it.
const Exchanged* array_of(const Reference& reference, const Declared& all, const Place& place) {
  if (reference.array.empty())
    return reference.after == 0 ? nullptr : &all.arrays[reference.after - 1];
  for (const Exchanged& array : all.arrays)
    if (lower(array.name) == reference.array) return &array;
  if (reference.xyva)
    place.fail(reference.line, reference.name + ".pce", reference.array,
               "is not an array of SMC_CAMXYVA in this file: is the file complete?");
  return nullptr;
}

/// The range of the master is that of the points, and so is their number.
void require_consistent(const Reference& reference, const Exchanged& cam, const Place& place) {
  const auto& x = cam.columns.x;
  const auto require = [&](const char* key, const char* shown, double wanted, double near,
                           const std::string& rule) {
    const auto stated = reference.numbers.find(key);
    if (stated == reference.numbers.end() || std::abs(stated->second.value - wanted) <= near)
      return;
    place.fail(stated->second.line, reference.name + "." + shown, number(stated->second.value),
               rule);
  };
  if (!reference.xyva)
    place.fail(reference.line, reference.name + ".byType", "",
               "must be 3 (XYVA) for an array of SMC_CAMXYVA");
  require("nelements", "nElements", static_cast<double>(x.size()), 0,
          "there are " + std::to_string(x.size()) + " points");
  const double near = 1e-9 * std::abs(x.back() - x.front());  // digits that a program leaves out
  const std::string rule =
      ": the points must cover the master's range (errors 751 and 752 of the controllers)";
  require("xstart", "xStart", x.front(), near, "the first point is at " + number(x.front()) + rule);
  require("xend", "xEnd", x.back(), near, "the last point is at " + number(x.back()) + rule);
}

/// Parts of the file that a table does not have.
std::vector<std::string> unread(const Reference& reference) {
  const auto tappets = reference.numbers.find("ntappets");
  if (tappets == reference.numbers.end() || tappets->second.value == 0) return {};
  return {number(tappets->second.value) + " tappets of " + reference.name + " are not read"};
}

}  // namespace

std::vector<Exchanged> parse_st(const std::string& text, const Place& place) {
  const Declared all = declared(text, place);
  if (all.arrays.empty())
    place.fail(1, "", "", "contains no array of SMC_CAMXYVA: is the file complete?");
  std::vector<Exchanged> cams;
  std::vector<const Exchanged*> alone;
  for (const Exchanged& array : all.arrays) alone.push_back(&array);
  for (const Reference& reference : all.references) {
    const Exchanged* const array = array_of(reference, all, place);
    if (array == nullptr) continue;
    require_consistent(reference, *array, place);
    std::erase(alone, array);
    cams.push_back(*array);
    cams.back().name = reference.name;
    cams.back().unread = unread(reference);
  }
  for (const Exchanged* array : alone) cams.push_back(*array);
  return cams;
}

std::string st_text(const TableFile& file) {
  const auto& [x, p, v, a] = file.table.columns();
  if (x.size() > most_points)
    throw InputError("knots", std::to_string(x.size()),
                     "must be at most " + std::to_string(most_points) +
                         ": nElements is an INT. Give a tolerance, or fewer intervals");
  std::string text = "// a cam for CODESYS SoftMotion, by " + made_by() + "\n" +
                     notes_text(file, "//") +
                     "// once, in the program: Cam.pce := ADR(CamPoints);\n" +
                     "VAR_GLOBAL\n  CamPoints : ARRAY[0.." + std::to_string(x.size() - 1) +
                     "] OF SMC_CAMXYVA := [\n";
  for (std::size_t i = 0; i < x.size(); ++i)
    text += "    (dX := " + real(x[i]) + ", dY := " + real(p[i]) + ", dV := " + real(v[i]) +
            ", dA := " + real(a[i]) + (i + 1 < x.size() ? "),\n" : ")\n");
  return text +
         "  ];\n  Cam : MC_CAM_REF := (byType := 3, nElements := " + std::to_string(x.size()) +
         ", xStart := " + real(x.front()) + ", xEnd := " + real(x.back()) + ");\nEND_VAR\n";
}

}  // namespace jounce::controllers_detail

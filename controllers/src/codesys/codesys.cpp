// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "controllers/src/codesys/cam_xyva.hpp"
#include "controllers/src/exchange/formats.hpp"

// A cam as CODESYS SoftMotion declares it (library SM3_Basic, MC_CAM_REF and SMC_CAMXYVA): an array
// of points, each with dX (master), dY (slave), dV = dY/dX and dA = d2Y/dX2, and a reference to it.
namespace jounce::controllers_detail {
namespace {

using profiles_detail::rounded_input;

/// Fields of an MC_CAM_REF.
struct Reference {
  struct Stated {
    double value = 0;
    int line = 0;
  };
  std::string name;
  std::string array;   ///< name in ADR(...), in lower case; empty if not given
  std::size_t at = 0;  ///< its place in the text
  bool xyva = true;    ///< its byType
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

std::vector<Reference> references_of(const std::string& text, const Place& place) {
  StReader code(text, place);
  std::vector<Reference> all;
  std::string name;
  std::string before;
  for (std::string word = code.name(); !word.empty(); before = word, word = code.name()) {
    if (word == ":") name = before;
    if (before != ":" || lower(unqualified(word)) != "mc_cam_ref") continue;
    const std::size_t at = code.here().at;
    all.push_back(read_reference(code));
    all.back().name = name;
    all.back().at = at;
  }
  return all;
}

/// The array that it refers to; null where that is none of points. Without ADR(...) it is the one before it.
const KnotArray* array_of(const Reference& reference, const std::vector<KnotArray>& all,
                          const Place& place) {
  if (reference.array.empty()) {
    const KnotArray* last = nullptr;
    for (const KnotArray& array : all)
      if (array.at < reference.at) last = &array;
    return last;
  }
  for (const KnotArray& array : all)
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
  const double near =
      rounded_input * std::abs(x.back() - x.front());  // digits that a program leaves out
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

/// True for a cam of points without slopes (SMC_CAMXY_REAL, SMC_CAMXY_LREAL).
bool is_cam_xy(const std::string& text) {
  return declares_array(text, "smc_camxy");
}

std::vector<Exchanged> read_codesys(const std::string& text, const Place& place) {
  const std::vector<KnotArray> arrays = knot_arrays(text, cam_xyva, place);
  if (arrays.empty() && is_cam_xy(text))
    place.fail(1, "SMC_CAMXY", "",
               "has points without slopes, which Jounce does not read: write dX and dY to a CSV "
               "with the columns master and slave, and fit a cam to them with `jounce fit`");
  if (arrays.empty())
    place.fail(1, "", "", "contains no array of SMC_CAMXYVA: is the file complete?");
  std::vector<Exchanged> cams;
  std::vector<const KnotArray*> alone;
  for (const KnotArray& array : arrays) alone.push_back(&array);
  for (const Reference& reference : references_of(text, place)) {
    const KnotArray* const array = array_of(reference, arrays, place);
    if (array == nullptr) continue;
    std::erase(alone, array);
    cams.push_back(cam_of_knots(*array, cam_xyva, Interpolation::quintic_hermite));
    require_consistent(reference, cams.back(), place);
    cams.back().name = reference.name;
    cams.back().unread = unread(reference);
  }
  for (const KnotArray* array : alone)
    cams.push_back(cam_of_knots(*array, cam_xyva, Interpolation::quintic_hermite));
  return cams;
}

}  // namespace

const KnotType cam_xyva{.name = "SMC_CAMXYVA", .fields = {"dX", "dY", "dV", "dA"}};

// The slave of a cam that advances is relative: an absolute one would jump back after each period.
std::string coupling_calls(const TableFile& file) {
  const std::vector<double>& slave = file.table.columns().p;
  const bool advances =
      file.table.outside() == Extrapolation::advance && slave.back() != slave.front();
  return std::string(
             "// once, in the program: Cam.pce := ADR(CamPoints);\n"
             "//   MC_CamTableSelect(CamTable := Cam, Periodic := ") +
         (repeats(file.table.outside()) ? "TRUE" : "FALSE") +
         ", MasterAbsolute := TRUE, SlaveAbsolute := " + (advances ? "FALSE" : "TRUE") +
         ", ...)\n" +
         (advances ? "//   FALSE: each period begins where the previous one ended\n" : "") +
         "//   MC_CamIn(MasterOffset := 0, SlaveOffset := 0, MasterScaling := 1,"
         " SlaveScaling := 1, ...)\n"
         "// A negative scaling reverses the direction.\n";
}

namespace {

std::string codesys_text(const TableFile& file) {
  const Columns& columns = file.table.columns();
  const std::vector<double>& x = columns.x;
  return "// a cam for CODESYS SoftMotion, by " + made_by() + "\n" + notes_text(file, "//") +
         coupling_calls(file) + "VAR_GLOBAL\n  CamPoints : ARRAY[0.." +
         std::to_string(x.size() - 1) + "] OF SMC_CAMXYVA := [\n" + knots_text(columns, cam_xyva) +
         "  ];\n  Cam : MC_CAM_REF := (byType := 3, nElements := " + std::to_string(x.size()) +
         ", xStart := " + real_literal(x.front()) + ", xEnd := " + real_literal(x.back()) +
         ");\nEND_VAR\n";
}

}  // namespace

constinit const FormatRow codesys_format{
    .format = {.name = "codesys",
               .maker = "CODESYS SoftMotion, declaration in Structured Text",
               .knot = "an `SMC_CAMXYVA` in a declaration, with its `MC_CAM_REF`",
               .source = "CODESYS SM3_Basic, data types CAM; \"Display generated code\"",
               .extension = ".st",
               .join = KnotJoin::quintic,
               .keeps_notes = true,
               .most = 32767,
               .limits_from = "nElements is an INT"},
    .detects = is_cam_xy,
    .read = read_codesys,
    .write = codesys_text};

}  // namespace jounce::controllers_detail

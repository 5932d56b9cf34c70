// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/formats.hpp"
#include "controllers/src/exchange/knot_arrays.hpp"

// A cam of TwinCAT 3 NC as a motion function (library Tc2_MC2_Camming, table type 22): an array of
// MC_MotionFunctionPoint. The function type of a point is the law of the segment that begins there.
// POLYNOM5_MM (15) is the polynomial of degree 5 through position, velocity and acceleration of both
// points; POLYNOM5 (5) starts and ends at rest.
namespace jounce::controllers_detail {
namespace {

const KnotType function_point{
    .name = "MC_MotionFunctionPoint",
    .fields = {"MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc"},
    .others = {"PointIndex", "FunctionType", "PointType", "RelIndexNextPoint", "SlaveJerk"}};

bool is_rest(const Knot& knot) {
  return knot.values[2] == 0 && knot.values[3] == 0;
}

/// The segment from a point to the next one must be the polynomial of degree 5 through both.
void require_quintic(const Knot& from, const Knot& to, const Place& place) {
  const std::string type = word_of(from, "FunctionType");
  const auto is = [&](const char* word, const char* code) { return type == word || type == code; };
  if (is("motionfunctype_polynom5_mm", "15")) return;
  if (is("motionfunctype_polynom5", "5")) {
    if (is_rest(from) && is_rest(to)) return;
    place.fail(from.line, "FunctionType", type,
               "goes from rest to rest and ignores SlaveVelo and SlaveAcc: use POLYNOM5_MM (15)");
  }
  if (is("motionfunctype_polynom1", "1")) {
    if (is_line(from, to)) return;
    place.fail(from.line, "FunctionType", type,
               "is a straight line, but the velocity or acceleration of its points is not that of "
               "the line: Jounce reads only cams without a jump of these");
  }
  place.fail(from.line, "FunctionType", type.empty() ? "missing" : type,
             "is not a polynomial of degree 5: Jounce reads POLYNOM5_MM (15), POLYNOM5 (5) and "
             "POLYNOM1 (1)");
}

void require_chain(const KnotArray& array, const Place& place) {
  for (std::size_t i = 0; i < array.knots.size(); ++i) {
    const Knot& knot = array.knots[i];
    const bool last = i + 1 == array.knots.size();
    const auto require = [&](const char* field, const std::string& wanted, const char* rule) {
      if (const std::string word = word_of(knot, field);
          !word.empty() && word != wanted && !(last && word == "0"))
        place.fail(knot.line, field, word, rule);
    };
    require("PointIndex", std::to_string(i + 1), "must count from 1 without a gap");
    require("RelIndexNextPoint", "1", "must be 1: Jounce reads a chain of points in their order");
    if (const std::string type = word_of(knot, "PointType");
        type == "motionpointtype_ignore" || type == "0")
      place.fail(knot.line, "PointType", type, "is ignored by TwinCAT: remove the point");
    if (!last) require_quintic(knot, array.knots[i + 1], place);
  }
}

std::vector<Exchanged> read_twincat(const std::string& text, const Place& place) {
  const std::vector<KnotArray> arrays = knot_arrays(text, function_point, place);
  if (arrays.empty())
    place.fail(1, "", "", "contains no array of MC_MotionFunctionPoint: is the file complete?");
  std::vector<Exchanged> cams;
  for (const KnotArray& array : arrays) {
    require_chain(array, place);
    cams.push_back(cam_of_knots(array, function_point, Interpolation::quintic_hermite));
  }
  return cams;
}

std::string twincat_text(const TableFile& file) {
  const Columns& columns = file.table.columns();
  const std::string n = std::to_string(columns.x.size());
  std::string text = "// a cam for Beckhoff TwinCAT 3 NC (Tc2_MC2_Camming), by " + made_by() +
                     "\n" + notes_text(file, "//") +
                     "// once, in the program:\n"
                     "//   Cam.pArray := ADR(CamPoints); Cam.ArraySize := SIZEOF(CamPoints);\n"
                     "//   MC_CamTableSelect(CamTable := Cam, Periodic := " +
                     (repeats(file.table.outside()) ? "TRUE" : "FALSE") +
                     ", ...)\n"
                     "// Some libraries need the names of the enumerations before their values:\n"
                     "//   MC_MotionFunctionType.MOTIONFUNCTYPE_POLYNOM5_MM\n"
                     "VAR_GLOBAL\n  CamPoints : ARRAY[1.." +
                     n + "] OF MC_MotionFunctionPoint := [\n";
  for (std::size_t i = 0; i < columns.x.size(); ++i)
    text += "    (PointIndex := " + std::to_string(i + 1) +
            ", FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM, PointType := MOTIONPOINTTYPE_MOTION,"
            " RelIndexNextPoint := 1,\n     MasterPos := " +
            real_literal(columns.x[i]) + ", SlavePos := " + real_literal(columns.p[i]) +
            ", SlaveVelo := " + real_literal(columns.v[i]) +
            ", SlaveAcc := " + real_literal(columns.a[i]) +
            (i + 1 < columns.x.size() ? "),\n" : ")\n");
  return text +
         "  ];\n  Cam : MC_CAM_REF := (TableType := MC_TABLETYPE_MOTIONFUNCTION, NoOfRows := " + n +
         ", NoOfColumns := 1);\nEND_VAR\n";
}

}  // namespace

constinit const FormatRow twincat_format{
    .format = {.name = "twincat",
               .maker = "Beckhoff TwinCAT 3 NC, motion function in Structured Text",
               .knot = "an `MC_MotionFunctionPoint` of the type POLYNOM5_MM",
               .source = "Beckhoff Tc2_MC2_Camming, MC_MotionFunctionPoint, MC_MotionFunctionType",
               .extension = "",
               .join = KnotJoin::quintic,
               .keeps_notes = true},
    .detects =
        [](const std::string& text) {
          return declares_array(text, "mc_motionfunctionpoint") ||
                 lower(text).find(".masterpos") != text.npos;
        },
    .read = read_twincat,
    .write = twincat_text};

}  // namespace jounce::controllers_detail

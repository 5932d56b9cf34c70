// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/formats.hpp"
#include "controllers/src/exchange/knot_arrays.hpp"

// A cam of TwinCAT 3 MC3 (library Tc3_Mc3Camming): an array of MotionFunctionPoint. The function type
// of a point is the law of the segment that begins there. A velocity or an acceleration that is not
// given is computed by the controller.
namespace jounce::controllers_detail {
namespace {

const KnotType mc3_point{
    .name = "MotionFunctionPoint",
    .fields = {"MasterPosition", "SlavePosition", "SlaveVelocity", "SlaveAcceleration"},
    .others = {"FunctionType", "SlaveJerk", "SymmetryRatio", "Ignored"}};

void require_mc3_segment(const Knot& from, const Knot& to, const Place& place) {
  const std::string type = word_of(from, "FunctionType");
  if (type == "linear" || type == "1") {
    if (is_line(from, to)) return;
    place.fail(from.line, "FunctionType", type,
               "is a straight line, but the velocity or acceleration of its points is not that of "
               "the line: Jounce reads only cams without a jump of these");
  }
  if (type != "polynomial5" && type != "3")
    place.fail(from.line, "FunctionType", type.empty() ? "missing" : type,
               "is not a polynomial of degree 5: Jounce reads Polynomial5 (3) and Linear (1)");
}

void require_mc3_point(const Knot& knot, const Place& place) {
  for (std::size_t i = 0; i < knot.given.size(); ++i)
    if (!knot.given[i])
      place.fail(knot.line, std::string(mc3_point.fields[i]), "",
                 "is missing: the controller would compute it, by a rule that is not documented");
  for (const char* field : {"SlaveJerk", "SymmetryRatio"})
    if (knot.others.contains(field))
      place.fail(
          knot.line, field, "",
          "is not supported: remove it, because the polynomial of degree 5 does not need it");
  if (const std::string ignored = word_of(knot, "Ignored"); !ignored.empty() && ignored != "false")
    place.fail(knot.line, "Ignored", ignored, "is not supported: remove the point");
}

std::vector<Exchanged> read_twincat_mc3(const std::string& text, const Place& place) {
  const std::vector<KnotArray> arrays = knot_arrays(text, mc3_point, place);
  if (arrays.empty())
    place.fail(1, "", "", "contains no array of MotionFunctionPoint: is the file complete?");
  std::vector<Exchanged> cams;
  for (const KnotArray& array : arrays) {
    for (std::size_t i = 0; i < array.knots.size(); ++i) {
      require_mc3_point(array.knots[i], place);
      if (i + 1 < array.knots.size())
        require_mc3_segment(array.knots[i], array.knots[i + 1], place);
    }
    cams.push_back(cam_of_knots(array, mc3_point, Interpolation::quintic_hermite));
  }
  return cams;
}

std::string twincat_mc3_text(const TableFile& file) {
  const Columns& columns = file.table.columns();
  const std::string n = std::to_string(columns.x.size());
  std::string text =
      "// a cam for Beckhoff TwinCAT 3 MC3 (Tc3_Mc3Camming), by " + made_by() + "\n" +
      notes_text(file, "//") +
      "// once, in the program: Cam.PointsAddress := ADR(CamPoints);\n"
      "// load the points into a cam object with its method WriteData()\n" +
      (repeats(file.table.outside()) ? "// the cam repeats: couple it periodically\n" : "") +
      "VAR_GLOBAL\n  CamPoints : ARRAY[1.." + n + "] OF MotionFunctionPoint := [\n";
  for (std::size_t i = 0; i < columns.x.size(); ++i)
    text += "    (FunctionType := EMotionFunctionType.Polynomial5,\n     MasterPosition := " +
            real_literal(columns.x[i]) + ", SlavePosition := " + real_literal(columns.p[i]) +
            ", SlaveVelocity := " + real_literal(columns.v[i]) +
            ", SlaveAcceleration := " + real_literal(columns.a[i]) +
            (i + 1 < columns.x.size() ? "),\n" : ")\n");
  return text + "  ];\n  Cam : MC_CAM_REF := (NumberOfPoints := " + n + ");\nEND_VAR\n";
}

}  // namespace

constinit const FormatRow twincat_mc3_format{
    .format = {.name = "twincat-mc3",
               .maker = "Beckhoff TwinCAT 3 MC3, cam points in Structured Text",
               .knot = "a `MotionFunctionPoint` of the type Polynomial5",
               .source = "Beckhoff TF5550 MC3 Camming, MotionFunctionPoint, EMotionFunctionType",
               .extension = "",
               .join = KnotJoin::quintic,
               .keeps_notes = true},
    .detects =
        [](const std::string& text) {
          return lower(text).find("masterposition") != text.npos &&
                 (declares_array(text, "motionfunctionpoint") ||
                  lower(text).find(".masterposition") != text.npos);
        },
    .read = read_twincat_mc3,
    .write = twincat_mc3_text};

}  // namespace jounce::controllers_detail

// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/formats.hpp"
#include "controllers/src/exchange/knot_arrays.hpp"

// Cams of the SIMATIC S7-1500T, as the points that a program writes to a technology object TO_Cam.
// Two forms are read: the points of LCamHdl_CreateCamBasic (library LCamHdl), joined by polynomials
// of degree 5, and the points of the object, joined by lines or splines.
namespace jounce::controllers_detail {
namespace {

const KnotType basic_point{
    .name = "LCamHdl_typeBasicPoint",
    .fields = {"leadingValue", "followingValue", "velocityRatio", "accelerationRatio"}};
const KnotType cam_point{.name = "TO_Cam_Struct_PointData", .fields = {"x", "y", "", ""}};

std::vector<Exchanged> read_points(const std::string& text, const Place& place,
                                   const KnotType& type, Interpolation rule) {
  const std::vector<KnotArray> arrays = knot_arrays(text, type, place);
  if (arrays.empty())
    place.fail(1, "", "",
               "contains no array of " + std::string(type.name) + ": is the file complete?");
  std::vector<Exchanged> cams;
  for (const KnotArray& array : arrays) cams.push_back(cam_of_knots(array, type, rule));
  return cams;
}

std::string declaration(const TableFile& file, const KnotType& type, const std::string& use) {
  const Columns& columns = file.table.columns();
  return "// a cam for SIMATIC S7-1500T, by " + made_by() + "\n" + notes_text(file, "//") + use +
         "VAR_GLOBAL\n  CamPoints : ARRAY[1.." + std::to_string(columns.x.size()) + "] OF " +
         std::string(type.name) + " := [\n" + knots_text(columns, type) + "  ];\nEND_VAR\n";
}

bool has(const std::string& text, const char* word) {
  return lower(text).find(word) != text.npos;
}

}  // namespace

constinit const FormatRow siemens_format{
    .format = {.name = "siemens",
               .maker = "Siemens S7-1500T, points of LCamHdl_CreateCamBasic",
               .knot = "an `LCamHdl_typeBasicPoint`",
               .source = "Siemens LCamHdl, LCamHdl_CreateCamBasic",
               .extension = ".scl",
               .join = KnotJoin::quintic,
               .keeps_notes = true,
               .most = 51,
               .limits_from = "LCamHdl_CreateCamBasic takes at most 51 points"},
    .detects =
        [](const std::string& text) {
          return declares_array(text, "lcamhdl_typebasicpoint") || has(text, ".leadingvalue");
        },
    .read =
        [](const std::string& text, const Place& place) {
          return read_points(text, place, basic_point, Interpolation::quintic_hermite);
        },
    .write =
        [](const TableFile& file) {
          return declaration(file, basic_point,
                             "// once, in the program: LCamHdl_CreateCamBasic(camProfile := "
                             "CamPoints, cam := ...)\n");
        }};

constinit const FormatRow siemens_points_format{
    .format = {.name = "siemens-points",
               .maker = "Siemens S7-1500T, points of a TO_Cam",
               .knot = "a `TO_Cam_Struct_PointData`: x and y",
               .source = "Siemens, S7-1500T synchronous operation functions; LCamHdl, "
                         "LCamHdl_CreateCamBasedOnXYPoints",
               .extension = "",
               .join = KnotJoin::spline,
               .keeps_notes = true,
               .most = 1000,
               .limits_from = "a TO_Cam holds at most 1000 points"},
    .detects =
        [](const std::string& text) { return declares_array(text, "to_cam_struct_pointdata"); },
    .read =
        [](const std::string& text, const Place& place) {
          std::vector<Exchanged> cams = read_points(text, place, cam_point, Interpolation::linear);
          for (Exchanged& cam : cams)
            cam.unread = {
                "the spline that the controller lays through the points is not read: the "
                "table has straight lines between them"};
          return cams;
        },
    .write =
        [](const TableFile& file) {
          const bool cyclic = repeats(file.table.outside());
          return declaration(
              file, cam_point,
              "// once, in the program: LCamHdl_CreateCamBasedOnXYPoints(camProfile := CamPoints, "
              "cam := ...),\n// with InterpolationSettings.InterpolationMode = 1 (C spline) and "
              "BoundaryConditions = " +
                  std::string(cyclic ? "1 (equal slopes)" : "0") + " of the object\n");
        }};

}  // namespace jounce::controllers_detail

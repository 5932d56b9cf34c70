// SPDX-License-Identifier: Apache-2.0
#include "io/src/gcode/gcode_words.hpp"

#include <array>

namespace jounce::io_detail {
namespace {

struct Unsupported {
  double first, last;  ///< G numbers
  const char* meaning;
  const char* remedy;
};

// The meanings of DIN 66025, RS-274 and LinuxCNC.
constexpr std::array<Unsupported, 17> unsupported{{
    {5, 5.3, "a spline", "have the CAM program write lines and arcs"},
    {10, 10, "the setting of an offset", "give the offset in [gcode], such as G54 = [...]"},
    {28, 30.9, "the return to a reference position", "write the position with G0"},
    {31, 31, "probing", "remove it"},
    {32, 33.9, "thread cutting", "remove it"},
    {38, 38.9, "probing", "remove it"},
    {41, 42.9, "cutter radius compensation", "have the CAM program write the compensated path"},
    {43, 44, "tool length compensation", "add the length to an offset G54 to G59 of [gcode]"},
    {50, 51, "scaling", "have the CAM program write the scaled path"},
    {52, 52, "a shift of the coordinates", "use an offset G54 to G59 of [gcode]"},
    {53, 53, "motion in machine coordinates", "write the position in the offset that is active"},
    {68, 69, "rotation of the coordinates", "have the CAM program write the rotated path"},
    {73, 76.9, "a drilling or thread cycle", "have the CAM program write G0 and G1"},
    {81, 89, "a drilling cycle", "have the CAM program write G0 and G1"},
    {92, 92.9, "a shift of the coordinates", "use an offset G54 to G59 of [gcode]"},
    {93, 95, "a feed per revolution or in inverse time", "write F in length per minute (G94)"},
    {96, 99, "the control of spindle or retract", "remove it"},
}};

}  // namespace

std::string rule_of_unsupported(double g_number) {
  for (const Unsupported& each : unsupported)
    if (g_number >= each.first && g_number <= each.last)
      return std::string(each.meaning) + " is not supported: " + each.remedy;
  return "is not supported: use G0 to G4, G17 to G21, G54 to G59, G61, G61.1, G64, G90, G90.1, "
         "G91, G91.1";
}

std::string rule_of_unsupported(const std::string& letters) {
  if (letters == "D") return "a tool number for G41 and G42 is not supported: remove it";
  if (letters == "L" || letters == "Q")
    return "a parameter of a cycle or of G10 is not supported: remove it";
  if (letters == "O")
    return "is the number of a subprogram, which is not supported (the number of the program is "
           "permitted as the first word of the file): have the CAM program write all motions in "
           "one program";
  return "is not a word of a program for Jounce, which takes N G M, X Y Z A B C U V W, I J K R P, "
         "F E FF EF, H S T: remove it";
}

}  // namespace jounce::io_detail

// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/detail/law_names.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

// Sources: VDI 2143 (German names); R. Norton, Cam Design and Manufacturing Handbook, ch. 3; the segments of the cam
// editors of CODESYS (Poly5, InclinedSine, ModifiedSine_Lambda) and TwinCAT (Bestehorn, acceleration trapezoid).

namespace jounce {
namespace {

constexpr const char* as_345 = "between two rests it is the same as \"345\"";
constexpr const char* as_4567 = "between two rests it is the same as \"4567\"";
constexpr const char* as_56789 = "between two rests it is the same as \"56789\"";
constexpr const char* sine_steps =
    "its acceleration steps beside a dwell; \"inclined_sine\" and \"modified_sine\" have no step";
constexpr const char* velocity_trapezoid =
    "with shares = [0, 1, 0] and straight = 0.3333 its velocity is a trapezoid";

constexpr LawAlias aliases[] = {
    {"linear", Law::line},
    {"straight line", Law::line},
    {"constant velocity", Law::line},
    {"Gerade", Law::line},
    {"rest", Law::dwell},
    {"stop", Law::dwell},
    {"standstill", Law::dwell},
    {"Rast", Law::dwell},
    {"Poly5", Law::quintic, as_345},
    {"polynomial 5", Law::quintic, as_345},
    {"5th order polynomial", Law::quintic, as_345},
    {"5th degree polynomial", Law::quintic, as_345},
    {"POLYNOM5_MM", Law::quintic},
    {"Poly7", Law::septic, as_4567},
    {"polynomial 7", Law::septic, as_4567},
    {"7th order polynomial", Law::septic, as_4567},
    {"7th degree polynomial", Law::septic, as_4567},
    {"POLYNOM7_MM", Law::septic, "its jerks are the key geo_jerk of the knots"},
    {"Poly7Com", Law::septic, "its third derivatives are the key geo_jerk of the knots"},
    {"Poly9", Law::nonic, as_56789},
    {"polynomial 9", Law::nonic, as_56789},
    {"9th degree polynomial", Law::nonic, as_56789},
    {"free polynomial", Law::polynomial},
    {"spline", Law::cubic_spline, "\"quintic_spline\" has a continuous jerk"},
    {"natural spline", Law::cubic_spline},
    {"PVT", Law::cubic_spline},
    {"smoothing spline", Law::quintic_spline, "give its points a tolerance"},
    {"XYVA", Law::hermite},
    {"piecewise polynomial", Law::hermite},
    {"Bezier", Law::b_spline, "without the key knots"},
    {"Bezier curve", Law::b_spline, "without the key knots"},
    {"NURBS", Law::b_spline, "with equal weights only"},
    {"2-3", Law::cubic},
    {"Poly3", Law::cubic},
    {"polynomial 3", Law::cubic},
    {"Poly345", Law::poly345},
    {"3-4-5 polynomial", Law::poly345},
    {"polynomial 3-4-5", Law::poly345},
    {"Poly4567", Law::poly4567},
    {"4-5-6-7 polynomial", Law::poly4567},
    {"polynomial 4-5-6-7", Law::poly4567},
    {"Poly56789", Law::poly56789},
    {"5-6-7-8-9 polynomial", Law::poly56789},
    {"polydyne", Law::poly56789, "give the mode of the follower in [polydyne]"},
    {"constant acceleration", Law::parabola},
    {"parabolic", Law::parabola},
    {"quadratic", Law::parabola},
    {"quadratic parabola", Law::parabola},
    {"quadratische Parabel", Law::parabola},
    {"harmonic", Law::simple_sine, sine_steps},
    {"simple harmonic", Law::simple_sine, sine_steps},
    {"simple harmonic motion", Law::simple_sine, sine_steps},
    {"SHM", Law::simple_sine, sine_steps},
    {"cosine", Law::simple_sine, sine_steps},
    {"sine", Law::simple_sine, sine_steps},
    {"einfache Sinoide", Law::simple_sine},
    {"cycloid", Law::inclined_sine},
    {"cycloidal", Law::inclined_sine},
    {"cycloidal motion", Law::inclined_sine},
    {"Bestehorn", Law::inclined_sine},
    {"Bestehorn sine", Law::inclined_sine},
    {"Bestehorn sinoid", Law::inclined_sine},
    {"inclined sinoid", Law::inclined_sine},
    {"geneigte Sinoide", Law::inclined_sine},
    {"Sinoide nach Bestehorn", Law::inclined_sine},
    {"mod sine", Law::modified_sine},
    {"MS", Law::modified_sine},
    {"modified sinusoid", Law::modified_sine},
    {"ModifiedSine_Lambda", Law::modified_sine, "its lambda is the key inflection"},
    {"modifizierte Sinoide", Law::modified_sine},
    {"MODSINUSLINIE_VV", Law::modified_sine_gg},
    {"C_C_MOD_SINE", Law::modified_sine_gg},
    {"D_C_MOD_SINE", Law::modified_sine_gg},
    {"C_D_MOD_SINE", Law::modified_sine_gg},
    {"mod trap", Law::modified_trapezoid},
    {"MT", Law::modified_trapezoid},
    {"modified trapezoidal", Law::modified_trapezoid},
    {"modified trapezoidal acceleration", Law::modified_trapezoid},
    {"acceleration trapezoid", Law::modified_trapezoid},
    {"trapezoidal acceleration", Law::modified_trapezoid},
    {"modifiziertes Beschleunigungstrapez", Law::modified_trapezoid},
    {"MCV", Law::modified_constant_velocity},
    {"MCV50", Law::modified_constant_velocity},
    {"sine-constant-cosine", Law::scca},
    {"trapezoid", Law::scca, velocity_trapezoid},
    {"trapezoidal", Law::scca, velocity_trapezoid},
    {"trapezoidal velocity", Law::scca, velocity_trapezoid},
    {"Gutman", Law::gutman13},
    {"Freudenstein", Law::freudenstein13},
    {"three harmonics", Law::triple_harmonic},
    {"perfect spline", Law::minimum_peak_jerk},
    {"sine-straight combination", Law::sine_straight},
    {"Sinus-Gerade-Kombination", Law::sine_straight},
    {"harmonische Kombination", Law::harmonic_combination},
    {"HARMONIC_KOMBI_RT", Law::harmonic_combination},
    {"HARMONIC_KOMBI_TR", Law::harmonic_combination},
    {"D_R_HARMONIC_COMBINATION", Law::harmonic_combination},
    {"R_D_HARMONIC_COMBINATION", Law::harmonic_combination},
    {"HARMONIC_KOMBI_VT", Law::harmonic_combination_gu},
    {"HARMONIC_KOMBI_TV", Law::harmonic_combination_gu},
    {"C_R_HARMONIC_COMBINATION", Law::harmonic_combination_gu},
    {"R_C_HARMONIC_COMBINATION", Law::harmonic_combination_gu},
    {"BESCHLTRAPEZ_RT", Law::modified_trapezoid_ru},
    {"BESCHLTRAPEZ_TR", Law::modified_trapezoid_ru},
    {"D_R_MOD_ACCEL_TRAPEZOID", Law::modified_trapezoid_ru},
    {"R_D_MOD_ACCEL_TRAPEZOID", Law::modified_trapezoid_ru},
};

/// Lower-case letters and digits of a name, which alone distinguish it.
std::string key_of(std::string_view name) {
  std::string key;
  for (const char c : name)
    if (const auto u = static_cast<unsigned char>(c); std::isalnum(u) != 0)
      key += static_cast<char>(std::tolower(u));
  return key;
}

/// The laws of Jounce under their own names, for another spelling.
const std::vector<LawAlias>& spellings() {
  static const std::vector<LawAlias> all = [] {
    std::vector<LawAlias> names;
    for (const LawInfo& law : all_laws()) names.push_back({law.name, law.law});
    return names;
  }();
  return all;
}

const LawAlias* found(std::span<const LawAlias> among, const std::string& key) {
  const auto it = std::find_if(among.begin(), among.end(),
                               [&](const LawAlias& each) { return key_of(each.name) == key; });
  return it == among.end() ? nullptr : &*it;
}

}  // namespace

std::span<const LawAlias> law_aliases() {
  return aliases;
}

const LawAlias* law_alias(std::string_view name) {
  if (law_named(name)) return nullptr;
  const std::string key = key_of(name);
  if (key.empty()) return nullptr;
  const LawAlias* const own = found(spellings(), key);
  return own != nullptr ? own : found(aliases, key);
}

std::string rule_of(const LawAlias& alias) {
  const std::string note = alias.note;
  return std::string("is called \"") + name(alias.law) + "\" here" +
         (note.empty() ? "" : "; " + note);
}

}  // namespace jounce

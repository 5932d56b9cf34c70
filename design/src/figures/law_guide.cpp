// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/law_guide.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/cam/detail/law_names.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

std::string shown(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "∞";
}

/// The value, right-aligned in `width` columns of a terminal. The sign ∞ is one column, but three
/// bytes.
std::string cell(double value, std::size_t width) {
  const std::string text = shown(value);
  const std::size_t columns = std::isfinite(value) ? text.size() : 1;
  return std::string(width > columns ? width - columns : 0, ' ') + text;
}

const char* letters(Ends ends) {
  switch (ends) {
    case Ends::given:
      return "any";
    case Ends::straight:
      return "G-G";
    case Ends::standing:
      return "R-R";
    case Ends::moving:
      return "R, G";
    case Ends::moving_free:
      return "U, B";
    case Ends::moving_to_reversal:
      return "G-U, U-G";
    case Ends::rest_to_reversal:
      break;
  }
  return "R-U, U-R";
}

std::string keys_of(Law law) {
  std::string keys;
  const auto add = [&](const char* key) {
    keys += (keys.empty() ? "`" : ", `") + std::string(key) + "`";
  };
  if (info(law).inflection) add("inflection");
  if (law == Law::scca) add("shares");
  if (law == Law::scca || law == Law::modified_constant_velocity || law == Law::sine_straight)
    add("straight");
  if (law == Law::triple_harmonic) add("harmonics");
  if (takes_points(law)) add("points");
  if (law == Law::b_spline) add("control"), add("knots");
  return keys;
}

/// The names of a law in books and other tools.
std::string other_names(Law law) {
  std::string names;
  for (const LawAlias& alias : law_aliases())
    if (alias.law == law) names += (names.empty() ? "" : ", ") + std::string(alias.name);
  return names;
}

struct Row {
  const char* label;
  double value;
  const char* meaning;
};

std::vector<Row> rows(const Characteristics& c) {
  return {{"Cv", c.cv.value, "peak velocity"},
          {"Ca", c.ca.value, "peak acceleration"},
          {"Ca*", c.ca_star.value, "peak deceleration"},
          {"Cj", c.cj.value, "peak jerk"},
          {"Cm", c.cm.value, "peak of velocity times acceleration, for the dynamic torque"},
          {"rms", c.rms, "rms acceleration, for the heat of the motor"}};
}

constexpr const char* introduction = R"(# The laws, and how to choose one

This page is the output of `jounce laws --markdown`, so its names, texts and numbers are those of the program.

A motion law moves the slave over a stroke h while the master moves by a length b. If the master runs at the
constant speed ω, the peaks of the slave's motion, and of the torque on the master, are

    velocity Cv h ω / b,   acceleration Ca h (ω / b)²,   jerk Cj h (ω / b)³,   torque Cm J h² (ω / b)³ / ω

J is the inertia of the slave. Cv, Ca, Cj and Cm are characteristic values of the law. The tables below list
them, together with the peak deceleration Ca* and the rms acceleration. Choose a law by the limit of the machine,
or by the motion:

| limit or motion | law |
|---|---|
| no particular limit | `modified_sine`, or `345` if the controller accepts only polynomials |
| speed of the motor | `modified_sine`; for long strokes `modified_constant_velocity` |
| torque of the motor (inertia) | `modified_trapezoid` |
| heat of the motor | `modified_sine`; `cubic` if steps of the acceleration are permitted |
| vibration | `inclined_sine`, `4567`; if the natural frequency is known, compare the results of `jounce validate` |
| back and forth without a dwell | `simple_sine` |
| from a dwell to a reversal, or back | `harmonic_combination` |
| from a line to a reversal, or back | `harmonic_combination_gu` |
| given velocities at the ends | `quintic`; any law with the ends "R, G" can also begin and end at a velocity |
| measured points | `quintic_spline` with a `tolerance` |
| a B-spline or Bezier curve from CAD | `b_spline` |
| your own shape, or an optimized one | `hermite`, which `jounce optimize` writes: see [the best shape of a cam](optimize/cams.md) |

The letters of VDI 2143 describe the motion at each end of a segment: R rest, G constant velocity, U reversal
(acceleration without velocity), B motion (velocity and acceleration). A spec does not contain these letters,
because they follow from its knots. If a knot omits a value, the laws before and after the knot, or the key
`boundaries`, determine this value.

Some laws from rest to rest have the key `inflection`. It is the share λ of the segment before the velocity peak,
by default 1/2. It does not change Cv. The peak acceleration becomes Ca / (2λ), and the peak deceleration
Ca / (2(1 − λ)). For R-U and G-U laws with an inflection, Jounce computes λ from the acceleration at the knot of
the reversal.

The laws `septic` and `nonic` also accept a jerk at their ends: the key `geo_jerk` of the knots, by default 0.

)";

std::string markdown(Law law) {
  const LawInfo& about = info(law);
  std::string text = fmt::format("## {}: `{}`\n\n", about.title, about.name);
  const bool rises = law != Law::line && law != Law::dwell && has_own_shape(law);
  if (rises) text += fmt::format("![{}](pictures/laws/{}.svg)\n\n", about.title, about.name);
  text += fmt::format("| | |\n|---|---|\n| use | {} |\n| strength | {} |\n| weakness | {} |\n",
                      about.use, about.strength, about.weakness);
  text += fmt::format("| at its ends | {} |\n", ends_in_words(about.ends));
  if (const std::string keys = keys_of(law); !keys.empty())
    text += fmt::format("| keys | {} |\n", keys);
  if (const std::string names = other_names(law); !names.empty())
    text += fmt::format("| other names | {} |\n", names);
  if (rises)
    for (const Row& row : rows(characteristics(law)))
      text += fmt::format("| {} | {} ({}) |\n", row.label, shown(row.value), row.meaning);
  return text + "\n";
}

}  // namespace

LawForm shown_form(Law law) {
  LawForm form;
  if (law == Law::scca) form.shares = {0.25, 0.25, 0.5};
  return form;
}

std::vector<Law> rising_laws() {
  std::vector<Law> laws;
  for (const LawInfo& law : all_laws())
    if (law.law != Law::line && law.law != Law::dwell && has_own_shape(law.law))
      laws.push_back(law.law);
  return laws;
}

Characteristics characteristics(Law law) {
  // The values next to a dwell, the usual case. A law whose acceleration steps there has an
  // infinite jerk.
  return characteristics(
      Cam(normalized(law, shown_form(law)), 0,
          reverses(info(law).ends) ? Extrapolation::refuse : Extrapolation::hold));
}

const char* ends_in_words(Ends ends) {
  switch (ends) {
    case Ends::given:
      return "any velocity and acceleration (R, G, U, B)";
    case Ends::straight:
      return "the constant velocity of the line, acceleration 0 (G-G)";
    case Ends::standing:
      return "velocity and acceleration 0 (R-R), no stroke";
    case Ends::moving:
      return "any velocity, acceleration 0 (R or G)";
    case Ends::moving_free:
      return "any velocity; the law determines the acceleration (U or B)";
    case Ends::moving_to_reversal:
      return "any velocity with acceleration 0 at one end, reversal with an acceleration at the "
             "other (G-U or U-G)";
    case Ends::rest_to_reversal:
      break;
  }
  return "rest at one end, reversal with an acceleration at the other (R-U or U-R)";
}

std::string law_table() {
  std::string text = fmt::format("{:<28}{:<10}{:>8}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "law", "ends",
                                 "Cv", "Ca", "Ca*", "Cj", "Cm", "rms");
  for (const LawInfo& law : all_laws()) {
    text += fmt::format("{:<28}{:<10}", law.name, letters(law.ends));
    const bool rises = law.law != Law::line && law.law != Law::dwell && has_own_shape(law.law);
    if (rises)
      for (const Row& row : rows(characteristics(law.law)))
        text += cell(row.value, row.label == std::string("Cv") ? 8 : 9);
    text += "\n";
  }
  return text;
}

std::string law_text(Law law) {
  const LawInfo& about = info(law);
  std::string text = fmt::format("{} (law = \"{}\")\n", about.title, about.name);
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("  {:<10}{}\n", label, value);
  };
  line("use", about.use);
  line("strength", about.strength);
  line("weakness", about.weakness);
  line("ends", ends_in_words(about.ends));
  if (const std::string keys = keys_of(law); !keys.empty()) line("keys", keys);
  if (const std::string names = other_names(law); !names.empty()) line("names", names);
  if (law != Law::line && law != Law::dwell && has_own_shape(law))
    for (const Row& row : rows(characteristics(law)))
      line(row.label, fmt::format("{:<9} {}", shown(row.value), row.meaning));
  return text;
}

std::string laws_markdown() {
  std::string text = introduction;
  text += "| law | ends | Cv | Ca | Ca* | Cj | Cm | rms |\n|---|---|---|---|---|---|---|---|\n";
  for (const Law law : rising_laws()) {
    text += fmt::format("| `{}` | {}", name(law), letters(info(law).ends));
    for (const Row& row : rows(characteristics(law))) text += " | " + shown(row.value);
    text += " |\n";
  }
  text +=
      "\nThe values of `scca` are for shares of 0.25, 0.25 and 0.5, and those of `triple_harmonic` "
      "for its "
      "default\namplitudes. All values are for ends at rest, or at rest and at a reversal.\n\n";
  for (const LawInfo& law : all_laws()) text += markdown(law.law);
  text.pop_back();
  return text;
}

std::string law_json(Law which) {
  const LawInfo& law = info(which);
  Json document{{"law", law.name},
                {"title", law.title},
                {"use", law.use},
                {"strength", law.strength},
                {"weakness", law.weakness},
                {"ends", ends_in_words(law.ends)},
                {"inflection", law.inflection}};
  const auto rising = rising_laws();
  if (std::find(rising.begin(), rising.end(), which) == rising.end()) return document.dump();
  const Characteristics c = characteristics(which);
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  for (const auto& [key, value] : {std::pair{"cv", c.cv.value},
                                   {"ca", c.ca.value},
                                   {"ca_star", c.ca_star.value},
                                   {"cj", c.cj.value},
                                   {"cm", c.cm.value},
                                   {"rms", c.rms}})
    document[key] = finite(value);
  return document.dump();
}

std::string laws_json() {
  Json all = Json::array();
  for (const LawInfo& law : all_laws()) all.push_back(Json::parse(law_json(law.law)));
  return all.dump();
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawInfo& one : all_laws()) names.emplace_back(one.name);
  return names;
}

Law law_of(const std::string& word) {
  if (const auto law = law_named(word)) return *law;
  if (const LawAlias* alias = law_alias(word)) throw InputError("law", word, rule_of(*alias));
  const std::string near = nearest(word, law_names());
  throw InputError("law", word,
                   "is not a law: " + (near.empty() ? "`jounce laws` lists them all"
                                                    : "did you mean " + near + "?"));
}

}  // namespace jounce

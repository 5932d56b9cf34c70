// SPDX-License-Identifier: Apache-2.0
#include <sstream>
#include <utility>

#include "jounce/design/detail/diagnostics.hpp"
#include "jounce/design/disc.hpp"

#include "proof/src/page_sections.hpp"

namespace jounce {
namespace {

bool needs_attention(const Diagnostic& each) {
  return each.level > Level::note || each.rule.starts_with("unlimited/");
}

/// The place of a finding in the picture; nullopt for one elsewhere, such as a frequency.
std::optional<DataTable::Place> picture_place(const Diagnostic& each) {
  if (!each.where || !each.where_unit.empty()) return std::nullopt;
  return DataTable::Place{*each.where, *each.where};
}

}  // namespace

Section spec_section(const Input& input, const Report& findings) {
  const auto& document = input.spec->document;
  Listing listing{.caption = document.name, .text = document.text};
  for (const Diagnostic& each : diagnostics_of(findings, input, document.name))
    if (needs_attention(each) && each.place.line > 0 && each.place.file == document.name)
      listing.remarks.push_back({each.place.line,
                                 each.message + (each.advice.empty() ? "" : ": " + each.advice),
                                 each.level >= Level::broken, picture_place(each)});
  return {"Spec", {std::move(listing)}};
}

Section disc_section(const Input& input) {
  const Spec& spec = *input.spec;
  const Disc disc = make_disc(spec, std::get<Cam>(*input.curve));
  Section section{"Disc",
                  {Image{contour_svg(drawing_of(spec, disc)), "The plate of the cam",
                         "The plate at master 0, in mm; a print has the scale 1:1. Solid: "
                         "profile. Dashed: pitch curve, base circle and path of the cutter."}}};
  std::istringstream lines(extremes_text(spec, disc));
  Facts facts;
  for (std::string line; std::getline(lines, line);)
    if (const auto colon = line.find(": "); colon != std::string::npos)
      facts.rows.emplace_back(line.substr(0, colon), line.substr(colon + 2));
  section.blocks.emplace_back(std::move(facts));
  return section;
}

}  // namespace jounce

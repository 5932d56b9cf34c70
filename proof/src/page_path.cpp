// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/design/detail/path_text.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/plot/path_picture.hpp"

#include "proof/src/page_sections.hpp"

namespace jounce {
namespace {

constexpr double no_loss = 1e-9;  ///< share of the duration

constexpr std::size_t shown_places = 20;

constexpr double phone = 370;  // px

Facts facts_of(const PathSummary& s, const Units& units) {
  const auto time = [&](double value) { return short_number(value) + " " + units.x; };
  Facts facts;
  facts.rows = {{"duration", time(s.duration)},
                {"length", short_number(s.length) + " " + units.position},
                {"with a stop at each corner", time(s.stop_duration)},
                {"proven lower bound on this path", time(s.lower_bound) + " (without jerk limits)"},
                {"at full speed", time(s.cost.at_full_speed)}};
  for (std::size_t k = 0; k < loss_causes; ++k) {
    const auto cause = static_cast<LossCause>(k);
    if (const double lost = s.cost.of(cause); lost > no_loss * s.duration)
      facts.rows.emplace_back(std::string("lost: ") + name(cause), time(lost));
  }
  return facts;
}

DataTable places_of(const PathSummary& s, const Units& units) {
  std::vector<SpeedLoss> losses = s.cost.losses;
  std::stable_sort(losses.begin(), losses.end(),
                   [](const SpeedLoss& a, const SpeedLoss& b) { return a.loss > b.loss; });
  DataTable table{
      .caption = "The places that cost most",
      .columns = {"line", "cause", "cost [" + units.x + "]", "at [" + units.position + "]",
                  "speed [" + rate_unit(units.position, units.x, 1) + "]",
                  "deviation [" + units.position + "]"}};
  for (std::size_t i = 0; i < std::min(shown_places, losses.size()); ++i) {
    const SpeedLoss& loss = losses[i];
    table.rows.push_back({{std::to_string(loss.line), name(loss.cause), short_number(loss.loss),
                           short_number(loss.where), short_number(loss.velocity),
                           loss.corner ? short_number(s.corners[*loss.corner].deviation) : ""},
                          false});
  }
  return table;
}

}  // namespace

Section path_section(const Input& input) {
  const PathSummary summary = summary_of(*input.spec, *input.plan);
  const Units& units = input.spec->units;
  Section section{"Path", {}};
  if (const auto figure = path_figure(input))
    section.blocks.emplace_back(
        Image{svg(*figure), "The path, colored by its speed",
              "The path in the plane of " + input.spec->axes[0].name + " and " +
                  input.spec->axes[1].name +
                  ". Its color shows the speed. Marked are the places that cost most time.",
              svg(*figure, {.width = phone})});
  section.blocks.emplace_back(facts_of(summary, units));
  section.blocks.emplace_back(places_of(summary, units));
  return section;
}

}  // namespace jounce

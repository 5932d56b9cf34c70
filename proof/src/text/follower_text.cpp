// SPDX-License-Identifier: Apache-2.0
#include "proof/src/text/follower_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string follower_text(const FollowerResult& run, const std::string& unit) {
  constexpr std::size_t shown = 5;
  if (!run.integration.ok())
    return fmt::format("  {:<12} BROKEN: not integrated to its end\n", "follower");
  std::string text =
      fmt::format("  {:<12} {}: contact force {} to {} N, least at {} s\n", "follower",
                  run.report.ok() ? "ok" : "BROKEN", rounded(run.least_force.value),
                  rounded(run.greatest_force.value), rounded(run.least_force.where));
  for (std::size_t i = 0; i < std::min(shown, run.flights.size()); ++i) {
    const Flight& f = run.flights[i];
    text +=
        fmt::format("  {:<12} off the cam from {} to {} s, up to {} {}, {}\n", "", rounded(f.from),
                    rounded(f.to), rounded(f.height), unit,
                    f.impact_speed == 0 ? "still in the air at the end"
                                        : fmt::format("lands at {} m/s", rounded(f.impact_speed)));
  }
  if (run.flights.size() > shown)
    text += fmt::format("  {:<12} and {} more\n", "", run.flights.size() - shown);
  if (run.residual.value != 0)
    text +=
        fmt::format("  {:<12} residual vibration {} {}\n", "", rounded(run.residual.value), unit);
  return text;
}

nlohmann::ordered_json follower_json(const FollowerResult& run) {
  Json flights = Json::array();
  for (const Flight& f : run.flights)
    flights.push_back(
        {{"from", f.from}, {"to", f.to}, {"height", f.height}, {"impact_speed", f.impact_speed}});
  return {{"least_force", run.least_force.value},
          {"least_force_at", run.least_force.where},
          {"greatest_force", run.greatest_force.value},
          {"residual", run.residual.value},
          {"flights", flights}};
}

}  // namespace jounce

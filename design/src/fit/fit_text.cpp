// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/detail/fit.hpp"

namespace jounce {
namespace {

std::string law_text(const CamSegment& segment) {
  std::string text = name(segment.law);
  if (segment.form.inflection) text += fmt::format(" ({})", rounded(*segment.form.inflection));
  if (!segment.points.empty()) text += fmt::format(" ({} points)", segment.points.size());
  return text;
}

}  // namespace

std::string fit_text(const FittedCam& fitted) {
  const CamFit& fit = fitted.fit;
  const std::string& u = fitted.units.position;
  std::string text =
      fmt::format("{}: {} points -> {} segment{}\n", fitted.source, fitted.points,
                  fit.spec.segments.size(), fit.spec.segments.size() == 1 ? "" : "s");
  double from = fit.spec.start.master;
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const CamSegment& segment = fit.spec.segments[i];
    const SegmentFit& found = fit.segments[i];
    text += fmt::format("{:3} {:<26} {:>10} .. {:<10} distance {} {}", i + 1, law_text(segment),
                        rounded(from), rounded(segment.end.master), rounded(found.gap), u);
    if (found.next)
      text += fmt::format("; next law {}: {}", name(*found.next), rounded(found.next_gap));
    text += "\n";
    from = segment.end.master;
  }
  text += fmt::format("distance from the points: at most {} {}, at {} {} (tolerance {})\n",
                      rounded(fit.gap), u, rounded(fit.where), fitted.units.x,
                      rounded(fitted.tolerance));
  if (fit.excess > 0)
    text += fmt::format(
        "BROKEN: the cam is beyond the tolerance of a point by {} {} -> give a greater tolerance; "
        "with --period, the first and the last point must be equal within their tolerances\n",
        rounded(fit.excess), u);
  return text + fmt::format("distance from the {}: at most {} {} (certified), at {} {}\n",
                            fitted.curved ? "curve of the table" : "lines between the points",
                            rounded(fitted.between.position), u, rounded(fitted.between.where),
                            fitted.units.x);
}

std::string fit_json(const FittedCam& fitted, const std::string& file) {
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < fitted.fit.segments.size(); ++i) {
    const CamSegment& segment = fitted.fit.spec.segments[i];
    const SegmentFit& found = fitted.fit.segments[i];
    nlohmann::ordered_json row{
        {"law", name(segment.law)}, {"end", segment.end.master}, {"distance", found.gap}};
    if (found.next) row["next"] = {{"law", name(*found.next)}, {"distance", found.next_gap}};
    segments.push_back(std::move(row));
  }
  return nlohmann::ordered_json{
      {"ok", fitted.ok()},
      {"spec", file},
      {"points", fitted.points},
      {"tolerance", fitted.tolerance},
      {"distance", {{"from_points", fitted.fit.gap}, {"where", fitted.fit.where}}},
      {"between_points", {{"distance", fitted.between.position}, {"where", fitted.between.where}}},
      {"segments", std::move(segments)}}
      .dump();
}

}  // namespace jounce

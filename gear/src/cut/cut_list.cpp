// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_list.hpp"

#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/cut/knife_parts.hpp"

namespace jounce {
namespace {

void require_piece(const std::string& key, double length, const Cutter& cutter) {
  const bool shear = !(cutter.turn() > 0);
  if (!(shear ? length >= cutter.shortest() : length > cutter.shortest()))
    throw InputError(key, length,
                     shear ? "must be at least " + six_digits_up(cutter.shortest()) +
                                 ", the shortest piece at this speed of the line"
                           : "must be longer than the sync zone on the web, " +
                                 six_digits_up(cutter.shortest()));
  if (!(length <= cutter.longest()))
    throw InputError(key, length,
                     "must be at most " + six_digits_down(cutter.longest()) +
                         ", the longest piece without a stop of the knife: set dwell = true");
}

/// Zones of the parts with the name "sync"; adjacent ones are one zone.
std::vector<SyncZone> zones_of(const Cam& cam, const std::vector<std::string>& names) {
  std::vector<SyncZone> zones;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != "sync") continue;
    const bool goes_on = i > 0 && names[i - 1] == "sync";
    if (!goes_on) zones.push_back({cam.breaks()[i], 0, "sync"});
    zones.back().to = cam.breaks()[i + 1];
  }
  return zones;
}

void add_rest(Cutter::Parts& parts, double length, double position) {
  if (!(length > 0)) return;
  parts.segments.push_back(line(length, position, position));
  parts.names.emplace_back("wait");
}

}  // namespace

void require_valid(const CutList& list, const Cutter& cutter) {
  if (list.lengths.empty()) throw InputError("lengths", "", "must have at least one length");
  for (std::size_t i = 0; i < list.lengths.size(); ++i)
    require_piece("lengths[" + std::to_string(i + 1) + "]", list.lengths[i], cutter);
  if (list.waste) require_piece("waste", *list.waste, cutter);
  if (list.first && !(*list.first >= cutter.approach()))
    throw InputError("first", *list.first,
                     "must be at least " + six_digits_up(cutter.approach()) +
                         ", the travel of the web while the cutter moves from home to the cut");
}

SyncCam cut_list(const CutListSpec& spec) {
  const Cutter cutter(spec.machine, spec.line);
  require_valid(spec.list, cutter);
  const bool shear = !(cutter.turn() > 0);
  Cutter::Parts parts;
  double length = 0;
  if (spec.list.first || shear) {
    const double lead = spec.list.first.value_or(cutter.approach());
    add_rest(parts, lead - cutter.approach(), cutter.home() - cutter.turn());
    cutter.add_approach(parts, 0);
    length += lead;
  }
  const std::size_t pieces = spec.list.size();
  for (std::size_t i = 0; i < pieces; ++i) {
    const double offset = static_cast<double>(i) * cutter.turn();
    const bool closes = shear && !spec.list.first && i + 1 == pieces;
    if (!closes) {
      cutter.add_piece(parts, spec.list[i], offset);
      length += spec.list[i];
      continue;
    }
    Cutter::Parts last;  // the last run-up is that of the next pass
    cutter.add_piece(last, spec.list[i], offset);
    Cutter::Parts run_up;
    cutter.add_approach(run_up, 0);
    const auto own = static_cast<std::ptrdiff_t>(last.segments.size() - run_up.segments.size());
    parts.segments.insert(parts.segments.end(), last.segments.begin(), last.segments.begin() + own);
    parts.names.insert(parts.names.end(), last.names.begin(), last.names.begin() + own);
    length += spec.list[i] - cutter.approach();
  }
  const double advance = static_cast<double>(pieces) * cutter.turn();
  double end = shear ? 0 : advance;
  if (spec.list.first) {
    cutter.add_retreat(parts, advance);
    length += cutter.retreat();
    end = cutter.home() + advance;
  }
  Cam cam = gear_detail::closed(std::move(parts.segments), length, end);
  if (spec.list.first)
    cam = with(cam, Extrapolation::hold);
  else if (shear)
    cam = with(cam, Extrapolation::wrap);
  std::vector<SyncZone> zones = zones_of(cam, parts.names);
  return {std::move(cam), std::move(parts.names), std::move(zones)};
}

}  // namespace jounce

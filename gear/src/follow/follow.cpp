// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/follow/follow_passes.hpp"

namespace jounce {
namespace {

using gear_detail::FollowPass;

using profiles_detail::rounded_input;
constexpr std::size_t most_segments = 1'000'000;

std::string prefix(const FollowSpec& spec, std::size_t table) {
  return spec.tables.size() == 1 ? "" : "table[" + std::to_string(table + 1) + "].";
}

/// Renames a key of a PT table, such as "point[3].position", to that of a follow table.
InputError renamed(const InputError& error, const std::string& where) {
  std::string key = error.key();
  if (key.starts_with("point")) key.replace(0, 5, "segment");
  if (key.ends_with(".position")) key.replace(key.size() - 8, 8, "slave");
  return {where + key, error.value(), error.rule()};
}

std::vector<PtRate> ratios_of(const FollowSpec& spec, std::size_t table, double entry) {
  try {
    return pt_rates<OverMaster>(spec.tables[table].segments, entry);
  } catch (const InputError& error) {
    throw renamed(error, prefix(spec, table));
  }
}

void require_valid(const FollowSpec& spec) {
  if (spec.tables.empty()) throw InputError("table", "", "is missing: give at least one");
  require_finite("start_ratio", spec.start_ratio);
  std::size_t total = 0;
  for (std::size_t i = 0; i < spec.tables.size(); ++i) {
    const auto& [segments, loops, end] = spec.tables[i];
    const std::string key = prefix(spec, i) + "loops";
    if (loops < 1 && i + 1 < spec.tables.size())
      throw InputError(key, std::to_string(loops),
                       "is endless: only the last table can be. Give the number of passes before "
                       "the next table");
    const auto passes = static_cast<std::size_t>(std::max<std::int64_t>(loops, 1));
    if (!segments.empty() && passes > (most_segments - total) / segments.size())
      throw InputError(key, std::to_string(loops),
                       "makes more than 1e6 segments: use fewer passes, or 0 for an endless table");
    total += passes * segments.size();
  }
}

/// Number of passes of a table that its cam contains.
std::int64_t shown(const FollowTable& table, const FollowPass& first) {
  if (table.loops >= 1) return table.loops;
  const bool continued = table.segments.front().type == PtType::continued;
  const double end = first.ratios.back().end;
  const double scale = std::max(std::abs(end), std::abs(first.entry));
  return continued && std::abs(end - first.entry) > rounded_input * scale ? 2 : 1;
}

}  // namespace

namespace gear_detail {

std::string place(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.12g", x);
  return text.data();
}

std::vector<FollowPass> follow_passes(const FollowSpec& spec) {
  require_valid(spec);
  std::vector<FollowPass> all;
  double entry = spec.start_ratio;
  FollowEnd at;
  for (std::size_t i = 0; i < spec.tables.size(); ++i) {
    const FollowTable& table = spec.tables[i];
    const FollowEnd origin = at;
    std::int64_t passes = 1;
    for (std::int64_t n = 0; n < passes; ++n) {
      all.push_back({i, at.master, at.slave, entry, n > 0, ratios_of(spec, i, entry)});
      if (n == 0) passes = shown(table, all.back());
      entry = all.back().ratios.back().end;
      const auto done = static_cast<double>(n + 1);  // a product does not accumulate rounding
      at = {origin.master + done * table.segments.back().x,
            origin.slave + done * table.segments.back().position};
    }
  }
  return all;
}

bool repeats(const FollowSpec& spec, const std::vector<FollowPass>& passes) {
  return spec.tables.back().loops < 1 && passes.size() == 1;
}

}  // namespace gear_detail

namespace {

Extrapolation outside_of(const FollowSpec& spec, const std::vector<FollowPass>& passes) {
  if (gear_detail::repeats(spec, passes))
    return spec.tables.back().segments.back().position == 0 ? Extrapolation::wrap
                                                            : Extrapolation::advance;
  const bool from_rest = spec.start_ratio == 0 && spec.tables.back().loops >= 1;
  return from_rest ? Extrapolation::hold : Extrapolation::refuse;
}

const char* name(PtType type) {
  constexpr std::array names{"normal", "even", "stop", "continue"};
  return names[static_cast<std::size_t>(type)];
}

std::string table_name(const FollowSpec& spec, std::size_t table) {
  return spec.tables.size() == 1 ? "" : "table " + std::to_string(table + 1) + " ";
}

/// The intervals of constant ratio; adjacent intervals of equal ratio are joined.
std::vector<SyncZone> zones_of(const Cam& cam, const std::vector<PtRate>& ratios) {
  double peak = 0;
  for (const PtRate& r : ratios) peak = std::max({peak, std::abs(r.start), std::abs(r.end)});
  const auto same = [&](double a, double b) { return std::abs(a - b) <= rounded_input * peak; };
  std::vector<SyncZone> zones;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto& [start, end] = ratios[i];
    if (!same(start, end) || same(start, 0)) continue;
    const bool goes_on =
        !zones.empty() && zones.back().to == cam.breaks()[i] && same(ratios[i - 1].end, start);
    if (goes_on)
      zones.back().to = cam.breaks()[i + 1];
    else
      zones.push_back({cam.breaks()[i], cam.breaks()[i + 1], "ratio " + six_digits(start)});
  }
  return zones;
}

}  // namespace

SyncCam follow(const FollowSpec& spec) {
  const auto passes = gear_detail::follow_passes(spec);
  std::vector<Segment> segments;
  std::vector<std::string> names;
  std::vector<PtRate> ratios;
  for (const FollowPass& pass : passes) {
    const auto& table = spec.tables[pass.table];
    const Cam cam = pt<OverMaster>(table.segments, pass.entry);
    for (const Segment& f : cam.segments()) segments.push_back(scaled(f, 1, pass.slave));
    for (const PtPoint& point : table.segments)
      names.push_back(table_name(spec, pass.table) + name(point.type) + " to " +
                      gear_detail::place(pass.master + point.x));
    ratios.insert(ratios.end(), pass.ratios.begin(), pass.ratios.end());
  }
  Cam cam(std::move(segments), 0, outside_of(spec, passes));
  std::vector<SyncZone> zones = zones_of(cam, ratios);
  return {std::move(cam), std::move(names), std::move(zones)};
}

std::vector<PtRate> follow_ratios(const FollowSpec& spec) {
  std::vector<PtRate> all;
  for (const FollowPass& pass : gear_detail::follow_passes(spec))
    all.insert(all.end(), pass.ratios.begin(), pass.ratios.end());
  return all;
}

std::optional<double> master_period(const FollowSpec& spec) {
  if (!gear_detail::repeats(spec, gear_detail::follow_passes(spec))) return std::nullopt;
  return spec.tables.back().segments.back().x;
}

}  // namespace jounce

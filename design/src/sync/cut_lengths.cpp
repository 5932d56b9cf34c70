// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/cut_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/in_document.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

template <class Kind>
std::optional<CutLengths> lengths_of(const Kind&) {
  return std::nullopt;
}

CamOfLength cams_of(const RotaryKnifeSpec& spec, double sync_length) {
  return [spec, sync_length](double length) -> std::optional<Cam> {
    if (!(length > sync_length)) return std::nullopt;
    RotaryKnifeSpec other = spec;
    other.cut_length = length;
    return rotary_knife(other).cam;
  };
}

std::optional<CutLengths> lengths_of(const RotaryKnifeSpec& spec) {
  const RotaryKnifeFigures f = figures(spec);
  const CamOfLength cams = cams_of(spec, f.sync_length);
  CutLengths all;
  if (!spec.dwell) all.turns_back = f.longest * (1 + rounded_sum);  // the longest does not reverse
  all.fastest = [cams, back = all.turns_back](double length, const CutLimits& limits) -> CutSpeed {
    if (length > back) return {length, 0, "reversal", 0};
    return fastest_cut(cams, length, limits);
  };
  all.shortest = [cams, f](double speed, const CutLimits& limits) {
    return shortest_length(cams, limits, speed, f.sync_length, f.synchronous);
  };
  all.marks = {{f.synchronous, "synchronous"}, {f.longest, "longest without a stop"}};
  all.from = std::max(f.sync_length, 0.25 * f.synchronous);
  all.to = 1.25 * f.longest;
  return all;
}

/// The last word of a quantity: "return acceleration" -> "acceleration".
std::string limit_of(const ShearBound& bound) {
  return bound.quantity.substr(bound.quantity.find(' ') + 1);
}

CutSpeed fastest_shear_at(FlyingShear shear, double length, const CutLimits& limits) {
  shear.cut_length = length;
  shear.limits = limits.slave;
  const ShearBound most = greatest_line_speed(shear);
  if (most.value < limits.line_speed) return {length, most.value, limit_of(most), 0};
  return {length, limits.line_speed, std::isinf(limits.line_speed) ? "" : "line", 0};
}

std::optional<double> shortest_shear(FlyingShear shear, double speed, const CutLimits& limits) {
  shear.line_speed = speed;
  shear.limits = limits.slave;
  const double least = least_cut_length(shear).value;
  return std::isfinite(least) ? std::optional(least) : std::nullopt;
}

/// The cut lengths of a shear: the line is faster for longer cuts, up to the limit of its speed.
std::optional<CutLengths> lengths_of(const FlyingShear& spec) {
  if (!spec.sync_time && !spec.sync_length)
    throw InputError("shear.sync_time", "",
                     "is missing: a map of cut lengths needs sync_time or sync_length");
  const double least =
      spec_detail::in_document("shear.", [&] { return least_cut_length(spec).value; });
  const double scale = std::isfinite(least) ? least : spec.cut_length;
  CutLengths all;
  all.fastest = [spec](double length, const CutLimits& limits) {
    return fastest_shear_at(spec, length, limits);
  };
  all.shortest = [spec](double speed, const CutLimits& limits) {
    return shortest_shear(spec, speed, limits);
  };
  all.from = 0.25 * scale;
  all.to = 2 * scale;
  return all;
}

std::optional<CutLengths> lengths_of(const CutListSpec& spec) {
  return std::visit([](const auto& machine) { return lengths_of(machine); }, spec.machine);
}

}  // namespace

CutLengths cut_lengths(const Spec& spec) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  try {
    if (sync != nullptr)
      if (auto found = std::visit([](const auto& kind) { return lengths_of(kind); }, *sync))
        return std::move(*found);
    throw InputError("kind", '"' + spec_kind(spec.document.text) + '"',
                     "must be \"knife\" or \"shear\": other kinds have no map of cut lengths");
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace jounce

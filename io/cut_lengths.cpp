#include "jounce/io/cut_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

template <class Kind>
std::optional<CutLengths> lengths_of(const Kind&) {
  return std::nullopt;
}

std::optional<CutLengths> lengths_of(const RotaryKnifeSpec& spec) {
  const RotaryKnifeFigures f = figures(spec);
  CutLengths all;
  all.cams = [spec, shortest = f.sync_length](double length) -> std::optional<Cam> {
    if (!(length > shortest)) return std::nullopt;
    RotaryKnifeSpec other = spec;
    other.cut_length = length;
    return rotary_knife(other).cam;
  };
  all.shortest = f.sync_length;
  all.synchronous = f.synchronous;
  all.marks = {{f.synchronous, "synchronous"}, {f.longest, "longest without a stop"}};
  all.from = std::max(f.sync_length, 0.25 * f.synchronous);
  all.to = 1.25 * f.longest;
  return all;
}

/// A shear gets faster with every length: the line's own speed ends it.
std::optional<CutLengths> lengths_of(const FlyingShear& spec) {
  (void)fastest_shear(spec, spec.cut_length);  // what is missing, is missing for every length
  const double least = least_cut_length(spec).value;
  const double scale = std::isfinite(least) ? least : spec.cut_length;
  CutLengths all;
  all.cams = [spec](double length) -> std::optional<Cam> {
    const auto made = fastest_shear(spec, length);
    return made ? std::optional(made->cam) : std::nullopt;
  };
  all.shortest = 0.01 * scale;
  all.synchronous = 100 * scale;
  all.from = 0.25 * scale;
  all.to = 2 * scale;
  return all;
}

}  // namespace

CutLengths cut_lengths(const Spec& spec) {
  if (const auto* sync = std::get_if<SyncSpec>(&spec.subject))
    if (auto found = std::visit([](const auto& kind) { return lengths_of(kind); }, *sync))
      return std::move(*found);
  throw spec.document.located(InputError("kind", "", "has no map of cut lengths; a knife has"));
}

}  // namespace jounce

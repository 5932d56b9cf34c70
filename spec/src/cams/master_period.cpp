// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/sync_spec.hpp"

#include "spec/src/cams/of_follow.hpp"

namespace jounce {
namespace {

std::optional<double> period(const GearSpec& spec) {
  return spec.master_period;
}

std::optional<double> period(const GearCourse&) {
  return std::nullopt;
}

std::optional<double> period(const GearInPosPart&) {
  return std::nullopt;
}

std::optional<double> period(const FollowPart& spec) {
  return spec_detail::of_follow(spec, [](const auto& slave) { return master_period(slave); });
}

std::optional<double> period(const RotaryKnifeSpec& spec) {
  return spec.cut_length;
}

std::optional<double> period(const FlyingShear& spec) {
  return spec.cut_length;
}

std::optional<double> period(const Indexer& spec) {
  return spec.cycle;
}

std::optional<double> period(const CutListSpec& spec) {
  if (spec.list.first) return std::nullopt;
  double length = 0;
  for (std::size_t i = 0; i < spec.list.size(); ++i) length += spec.list[i];
  return length;
}

}  // namespace

std::optional<double> master_period(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return period(each); }, spec);
}

}  // namespace jounce

#include "jounce/gear/gear.hpp"
#include "jounce/io/detail/in_document.hpp"
#include "jounce/io/detail/sync_gear.hpp"
#include "jounce/io/sync_spec.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using detail::in_document;

SyncCam made(const GearSpec& spec) {
  const Gear gear = Gear::ratio(spec.numerator, spec.denominator);
  const double travel = spec.master_period * static_cast<double>(gear.numerator()) /
                        static_cast<double>(gear.denominator());
  return {Cam({line(spec.master_period, 0, travel)}, 0, Outside::advance),
          {"gear"},
          {{0, spec.master_period, "gear"}}};
}

std::optional<double> period(const GearSpec& spec) {
  return spec.master_period;
}

SyncCam made(const GearCourse& spec) {
  return detail::made_gear(spec);
}

SyncCam made(const GearInPosPart& spec) {
  return detail::made_gear(spec);
}

std::optional<double> period(const GearCourse&) {
  return std::nullopt;
}

std::optional<double> period(const GearInPosPart&) {
  return std::nullopt;
}

/// What is said of the whole stands under [follow].
template <class Find>
auto of_follow(const FollowPart& spec, Find find) {
  try {
    return std::visit(find, spec.slave);
  } catch (const InputError& error) {
    const std::string& key = error.key();
    const bool of_all =
        !key.starts_with("segment") && !key.starts_with("point") && !key.starts_with("zone");
    throw InputError((of_all ? "follow." : "") + key, error.value(), error.rule());
  }
}

SyncCam made(const FollowPart& spec) {
  return of_follow(spec, [](const auto& slave) { return follow(slave); });
}

std::optional<double> period(const FollowPart& spec) {
  return of_follow(spec, [](const auto& slave) { return master_period(slave); });
}

SyncCam made(const RotaryKnifeSpec& spec) {
  return in_document("knife.", [&] { return rotary_knife(spec); });
}

std::optional<double> period(const RotaryKnifeSpec& spec) {
  return spec.cut_length;
}

SyncCam made(const FlyingShear& spec) {
  return in_document("shear.", [&] { return flying_shear(spec); });
}

std::optional<double> period(const FlyingShear& spec) {
  return spec.cut_length;
}

SyncCam made(const Indexer& spec) {
  return in_document("indexer.", [&] { return indexer(spec); });
}

std::optional<double> period(const Indexer& spec) {
  return spec.cycle;
}

}  // namespace

SyncCam sync_cam_of(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return made(each); }, spec);
}

std::optional<double> master_period(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return period(each); }, spec);
}

}  // namespace jounce

#include "jounce/gear/gear.hpp"
#include "jounce/io/sync_spec.hpp"

namespace jounce {
namespace {

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

}  // namespace

SyncCam sync_cam_of(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return made(each); }, spec);
}

std::optional<double> master_period(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return period(each); }, spec);
}

}  // namespace jounce

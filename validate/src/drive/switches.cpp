// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/switches.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::validate_detail {
namespace {

using profiles_detail::rounded_sum;

int sign_of(double x) {
  return (x > 0) - (x < 0);
}

template <class Switch>
bool set(int& mode, Switch to) {
  const bool changed = mode != to;
  mode = to;
  return changed;
}

int at(std::span<const int> crossed, std::size_t event) {
  return crossed.empty() ? 0 : crossed[event];
}

}  // namespace

Switches::Switches(DriveModel& model, double tolerance, double torque, double speed)
    : model_(model),
      tolerance_(tolerance),
      torque_(torque),
      speed_(speed),
      feed_(model.drive().controller.friction_feed_forward > 0 && model.dry_friction() > 0 &&
            !model.sampled()) {
  for (std::size_t i = 0; i < model.train().size(); ++i) {
    if (model.train()[i].rubs()) rubbing_.push_back(i);
    if (model.train()[i].half_gap > 0) gaps_.push_back(i);
  }
  slip_ = model.sampled() ? 0 : 2;
  contact_ = slip_ + rubbing_.size();
  feed_event_ = contact_ + 2 * gaps_.size();
  events_ = static_cast<int>(feed_event_ + (feed_ ? 1 : 0));
}

/// The commanded torque at which the limit of the given sign is entered or, in that mode, left.
double Switches::threshold(int sign, const Jet& r, const double* y, double widths) const {
  const double band = widths * tolerance_ * model_.drive().motor.torque_limit;
  return model_.limit(sign, model_.motor_speed(r, y)) +
         sign * (model_.mode().torque == sign ? -band : band);
}

/// The torque by which a sticking body is below breaking away: (11) of drive_model.cpp.
double Switches::margin(std::size_t body, const Jet& r, const double* y, double widths) const {
  const double band = widths * tolerance_ * torque_;
  const double net = model_.net(body, r, y);
  return std::min(model_.holding(body, 1, y) - net, model_.holding(body, -1, y) + net) + band;
}

void Switches::evaluate(const Jet& r, const double* y, double* g) const {
  if (!model_.sampled()) {
    const double asked = model_.commanded(r, y);
    g[0] = asked - threshold(1, r, y, 1);
    g[1] = asked - threshold(-1, r, y, 1);
  }
  std::size_t k = slip_;
  for (const std::size_t i : rubbing_)
    g[k++] = model_.mode().slip[i] == 0 ? margin(i, r, y, 1)
                                        : y[2 * i + 1] + model_.radians_per_unit() * r[1];
  for (const std::size_t i : gaps_)
    for (const int flank : {1, -1})
      g[k++] = model_.pressed(i, flank, y) +
               tolerance_ * torque_ * (model_.mode().contact[i] == flank ? 1 : -1);
  if (feed_) g[k] = r[1];
}

bool Switches::update_torque(const Jet& r, const double* y, std::span<const int> crossed) {
  int& mode = model_.mode().torque;
  if (const int up = at(crossed, 0); up != 0) return set(mode, up > 0 ? 1 : 0);
  if (const int up = at(crossed, 1); up != 0) return set(mode, up < 0 ? -1 : 0);
  const double asked = model_.commanded(r, y);
  int to = mode;
  if (to != 0 && to * asked < to * threshold(to, r, y, 2)) to = 0;
  if (to == 0)
    for (const int sign : {1, -1})
      if (sign * asked > sign * model_.limit(sign, model_.motor_speed(r, y)) +
                             2 * tolerance_ * model_.drive().motor.torque_limit)
        to = sign;
  return set(mode, to);
}

bool Switches::update_slip(std::size_t body, const Jet& r, double* y, int crossed) {
  int& mode = model_.mode().slip[body];
  double& speed = y[2 * body + 1];
  const double w_r = model_.radians_per_unit() * r[1];
  if (mode == 0) {
    if (crossed >= 0 && margin(body, r, y, 2) >= 0) return false;
    mode = sign_of(model_.net(body, r, y));
    speed = -w_r;
    return true;
  }
  if (crossed * mode >= 0 && mode * (speed + w_r) >= -tolerance_ * speed_) return false;
  speed = -w_r;  // at rest: (11) decides if it stays at rest
  const double net = model_.net(body, r, y);
  mode = margin(body, r, y, 1) >= 0 ? 0 : sign_of(net);
  return true;
}

bool Switches::update_contact(std::size_t i, const double* y, std::span<const int> crossed) {
  int& mode = model_.mode().contact[i];
  const double band = 2 * tolerance_ * torque_;
  const auto pressed = [&](int flank) { return model_.pressed(i, flank, y); };
  const auto way = [&](int flank) { return at(crossed, flank > 0 ? 0 : 1); };
  if (mode != 0) {
    if (way(mode) >= 0 && pressed(mode) >= -band) return false;
    mode = 0;
    return true;
  }
  for (const int flank : {1, -1})
    if (way(flank) > 0 || pressed(flank) > band) {
      mode = flank;
      ++impacts_;
      return true;
    }
  return false;
}

bool Switches::update(const Jet& r, double* y, std::span<const int> crossed) {
  bool changed = false;
  if (feed_ && at(crossed, feed_event_) != 0)
    changed |= set(model_.mode().feed, crossed[feed_event_]);
  // A change may cause another: a flank that meets, a body that breaks away.
  for (int round = 0; round < 8; ++round) {
    bool again = !model_.sampled() && update_torque(r, y, crossed);
    for (std::size_t k = 0; k < gaps_.size(); ++k)
      again |= update_contact(gaps_[k], y,
                              crossed.empty() ? crossed : crossed.subspan(contact_ + 2 * k, 2));
    for (std::size_t k = 0; k < rubbing_.size(); ++k)
      again |= update_slip(rubbing_[k], r, y, at(crossed, slip_ + k));
    if (!again) break;
    changed = true;
    crossed = {};
  }
  return changed;
}

void Switches::begin(const Jet& r, double fastest) {
  if (!feed_) return;
  const bool standing = std::abs(r[1]) <= rounded_sum * fastest;  // torque that sets it in motion
  model_.mode().feed = sign_of(!standing ? r[1] : r[2] != 0 ? r[2] : r[3]);
}

}  // namespace jounce::validate_detail

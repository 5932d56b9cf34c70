// SPDX-License-Identifier: Apache-2.0
#include "executor/record/log_judge.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "executor/record/log_line.hpp"
#include "executor/server/homing_judge.hpp"

namespace jounce::test {
namespace {

using What = Accepted::What;

/// Faults that leave the setpoint where it is: nothing brakes it.
constexpr std::string_view freezing[] = {"disabled_in_motion", "following_error", "drive_fault",
                                         "drive_not_ready", "stalled"};

class Judge {
 public:
  Judge(const Bounds& bounds, const std::vector<Accepted>& orders, const std::string& leader)
      : bounds_(bounds), orders_(orders), homing_(bounds), leader_(leader) {}

  void take(const Line& now) {
    obey(now);
    follow(now);
    homing_.take(
        now, begun_ ? std::optional(last_) : std::nullopt, placed_,
        [&](const char* what, double value, double limit) { find(now, what, value, limit); });
    placed_ = placed_ || homing_.named();
    const bool stalled = now.tick - last_.tick > bounds_.longest_gap;
    if (stalled || now.state == "disabled") may_freeze_ = true;
    frozen_ = begun_ && now.failed() &&
              (last_.failed() ? may_freeze_ && now.v == 0 && now.p == last_.p : freezes(now));
    if (begun_) {
      place(now);
      within_limits(now);
      together(now);
      rest(now);
    }
    begun_ = true;
    last_ = now;
  }

  std::vector<std::string> findings;

 private:
  template <class... Values>
  void find(const Line& now, const char* what, double value, double limit) {
    if (findings.size() >= 20) return;
    std::ostringstream text;
    text.precision(17);
    text << "tick " << now.tick << ": " << what << " " << value << ", limit " << limit << " (state "
         << now.state << ", p " << now.p << ", v " << now.v << ", a " << now.a << ", before p "
         << last_.p << ", v " << last_.v << ", a " << last_.a << "); last order: " << words_;
    findings.push_back(text.str());
  }

  /// Applies the orders answered so far: the permitted and the required motion.
  void obey(const Line& now) {
    placed_ = may_freeze_ = false;
    if (!coupled(last_)) ratio_ = 0;
    for (; next_ < orders_.size() && orders_[next_].sent <= now.tick; ++next_)
      open_.push_back(&orders_[next_]);
    for (const Accepted*& order : open_) {
      if (order == nullptr) continue;
      const bool done = now.tick > order->answered;  // or in a tick that was left out
      words_ = order->words;
      if (order->what == What::places) placed_ = true;
      if (order->what == What::moves || order->what == What::homes) begin(*order);
      if (order->what == What::homes) homing_.offer(*order);
      if (order->what == What::homes && (order->method == 35 || order->method == 37))
        placed_ = true;
      if (order->what == What::disables || order->aborts) may_freeze_ = true;
      if (!done) continue;
      if (order->what == What::rests) demand_rest(now, *order);
      if (order->what == What::stops) demand_stop(now, order->words);
      if (order->what == What::stops || order->what == What::disables) revoke(*order);
    }
    std::erase_if(open_, [&](const Accepted* order) {
      return order == nullptr || now.tick > order->answered;
    });
    if (now.failed() && !last_.failed()) demand_stop(now, "fault");
  }

  /// By how much the leader's acceleration and velocity change up to this tick.
  void follow(const Line& now) {
    const Line before = master_;
    while (master_.tick < now.tick)
      if (const auto next = leader_.next())
        master_ = *next;
      else
        break;
    master_step_ = std::abs(master_.a - before.a);
    master_dv_ = std::abs(master_.v - before.v);
  }

  /// Revokes orders that were accepted before it and wait for their tick.
  void revoke(const Accepted& by) {
    licensed_ = false;
    for (const Accepted*& order : open_)
      if (order != nullptr && (order->what == What::moves || order->what == What::homes) &&
          order->sent < by.sent)
        order = nullptr;
  }

  void begin(const Accepted& order) {
    licensed_ = true;
    rest_by_.reset();
    ratio_ = std::max(ratio_, order.ratio);
  }

  static double given(double value, double limit) { return value > 0 ? value : limit; }

  [[nodiscard]] bool freezes(const Line& now) const {
    if (now.fault == "aborted") return bounds_.abort_acceleration == 0;
    return std::find(std::begin(freezing), std::end(freezing), now.fault) != std::end(freezing);
  }

  void demand_stop(const Line& now, const std::string& by) {
    demanded_by_ = by;
    stops_ = true;
    const double jerk = bounds_.jerk ? bounds_.stop_jerk : HUGE_VAL;
    demand(now, now.failed() ? bounds_.gentlest_brake() : bounds_.stop_acceleration, jerk);
  }

  /// No other motion may have begun after it. Of orders that overlap, who came first is not known.
  [[nodiscard]] bool last_of_motions(const Accepted& order) const {
    const auto sent = orders_.begin() + static_cast<std::ptrdiff_t>(next_);
    return std::none_of(orders_.begin(), sent, [&](const Accepted& other) {
      return &other != &order &&
             (other.what == What::moves || other.what == What::homes ||
              other.what == What::rests) &&
             other.answered > order.sent;
    });
  }

  void demand_rest(const Line& now, const Accepted& order) {
    if (!last_of_motions(order)) {
      if (!stops_) rest_by_.reset();
      return;
    }
    stops_ = false;
    demanded_by_ = order.words;
    double a = given(order.acceleration, bounds_.acceleration);
    double j = given(order.jerk, bounds_.jerk.value_or(HUGE_VAL));
    if (homing_.unranged()) {  // a halt of a homing is a stop, also where it asks for less
      a = std::min(a, bounds_.stop_acceleration);
      j = bounds_.jerk ? std::min(j, bounds_.stop_jerk) : HUGE_VAL;
    }
    demand(now, a, j);
  }

  void demand(const Line& now, double a, double j) {
    double time = time_to_rest(now.v, now.a, a, j);
    if (now.path || last_.path) time = std::max(time, 1.01 * bounds_.path_stop_time);
    constexpr double longest = 1e6;  // s: an order may ask for as little as it likes
    time = std::min(time, longest);
    // A fault in a late cycle begins where the tick before it was.
    const std::int64_t late = now.tick - last_.tick - 1;
    rest_by_ = now.tick + static_cast<std::int64_t>(std::ceil(time / bounds_.period)) + 3 + late;
  }

  void place(const Line& now) {
    const double low = bounds_.lowest.value_or(-HUGE_VAL);
    const double high = bounds_.highest.value_or(HUGE_VAL);
    const double rounding = 1e-9 * std::max(1.0, std::abs(now.p));
    const auto out = [&](double p) { return std::max({low - p, p - high, 0.0}); };
    // Outside, what turns back may end its acceleration by the jerk of a stop first.
    const double a = bounds_.hardest_brake();
    double tail =
        out(last_.p) > 0 && bounds_.jerk ? a * a * a / (bounds_.stop_jerk * bounds_.stop_jerk) : 0;
    // Outside, a fault may come where a coupling has just turned the axis round.
    if (now.failed()) tail += last_.v * last_.v / (2 * bounds_.gentlest_brake());
    if (out(now.p) > (placed_ || homing_.unranged() ? HUGE_VAL : out(last_.p)) + tail + rounding)
      find(now, "position out of the range", now.p, now.p > high ? high : low);
  }

  void within_limits(const Line& now) {
    const double rounding = 1e-6;
    // An acceleration that a fault ends goes down by the jerk of a stop: meanwhile the velocity rises.
    const double a = bounds_.hardest_brake();
    const bool rises = now.failed() && bounds_.jerk;
    const double fastest = bounds_.velocity + (rises ? a * a / (2 * bounds_.stop_jerk) : 0);
    if (std::abs(now.v) > fastest * (1 + 1e-9) + rounding) find(now, "velocity", now.v, fastest);
    if (frozen_) return;
    const bool stop_limits = now.state == "stopping" || now.path || last_.path;
    const bool fails = now.failed() || last_.failed();
    const double most = fails         ? bounds_.hardest_brake()
                        : stop_limits ? bounds_.stop_acceleration
                                      : bounds_.acceleration;
    // A motion that leaves a live master or a path may begin above its own limit; it must come
    // down.
    const double highest = std::max(most, std::abs(last_.a));
    if (std::abs(now.a) > highest * (1 + 1e-9) + rounding) find(now, "acceleration", now.a, most);
    if (!bounds_.jerk) return;
    const double dt = static_cast<double>(now.tick - last_.tick) * bounds_.period;
    const double jerk = (now.a - last_.a) / dt;
    const double masters = std::isinf(ratio_) ? HUGE_VAL : ratio_ * master_step_ / dt;
    if (std::abs(jerk) > (bounds_.stop_jerk + masters) * (1 + 2e-6))
      find(now, "jerk", jerk, bounds_.stop_jerk + masters);
  }

  /// Position and velocity are what the velocity and the acceleration make of those before.
  void together(const Line& now) {
    if (placed_) return;
    if (frozen_) {
      if (now.v != 0 || now.p != last_.p) find(now, "a frozen setpoint moves", now.p, last_.p);
      return;
    }
    const double dt = static_cast<double>(now.tick - last_.tick) * bounds_.period;
    const double most = bounds_.hardest_brake();
    const double rounding = 1e-9 * std::max(1.0, std::abs(now.p));
    const double dv = std::abs(now.v - last_.v);
    if (dv > most * dt * (1 + 1e-9) + rounding) find(now, "step of the velocity", dv, most * dt);
    // A leader may use its own limits within a tick: its mean velocity lies between both all the same.
    const double leaders =
        std::isinf(ratio_) ? bounds_.velocity * dt : ratio_ * master_dv_ * dt / 2;
    const double furthest = most * dt * dt / 4 + leaders;
    const double dp = std::abs(now.p - last_.p - dt * (now.v + last_.v) / 2);
    if (dp > furthest * (1 + 1e-6) + rounding) find(now, "step of the position", dp, furthest);
  }

  static bool coupled(const Line& line) { return line.state == "synchronized_motion"; }

  void rest(const Line& now) {
    const double step = std::abs(now.p - last_.p);
    const bool moves = std::abs(now.v) > 1e-9 * bounds_.velocity ||
                       (!placed_ && step > 1e-9 * std::max(1.0, std::abs(now.p)));
    if (now.state == "disabled" && moves) find(now, "moves while disabled", now.v, 0);
    // The motion in ticks that were left out is unknown.
    const bool late = rest_by_ && (now.v != 0 ? now.tick : last_.tick) > *rest_by_;
    if (late && moves) {
      words_ = demanded_by_ + " until tick " + std::to_string(*rest_by_) + "; " + words_;
      find(now, "not at rest in the time of its stop", now.v, 0);
      rest_by_.reset();
    }
    if (moves && !moved_ && !licensed_ && !now.failed())
      find(now, "begins to move without an order", now.v, 0);
    if (moves && braked_) find(now, "moves again in its fault", now.v, 0);
    braked_ = now.failed() && last_.failed() && !moves && !moved_ && now.a == 0;
    moved_ = moves;
  }

  const Bounds& bounds_;
  const std::vector<Accepted>& orders_;
  std::size_t next_ = 0;
  std::vector<const Accepted*> open_;
  std::string words_;
  std::string demanded_by_;
  Line last_;
  bool begun_ = false;
  bool placed_ = false;
  bool moved_ = false;
  bool braked_ = false;  // in a fault, for two ticks
  bool licensed_ = false;
  bool frozen_ = false;  // in this tick
  bool may_freeze_ = false;
  bool stops_ = false;  // a stop or a fault requires the rest
  double ratio_ = 0;    // the greatest of the gears so far
  HomingJudge homing_;
  Lines leader_;
  Line master_;             // in this tick
  double master_step_ = 0;  // u/s^2
  double master_dv_ = 0;    // u/s
  std::optional<std::int64_t> rest_by_;
};

}  // namespace

double Bounds::gentlest_brake() const {
  const auto own = [&](double brake) { return brake > 0 ? brake : stop_acceleration; };
  return std::min({stop_acceleration, own(limit_acceleration), own(abort_acceleration)});
}

double Bounds::hardest_brake() const {
  return std::max({stop_acceleration, limit_acceleration, abort_acceleration});
}

std::vector<std::string> judged(const std::string& csv, const Bounds& bounds,
                                const std::vector<Accepted>& orders, const std::string& leader) {
  Judge judge(bounds, orders, leader);
  Lines lines(csv);
  while (const auto line = lines.next()) judge.take(*line);
  return judge.findings;
}

}  // namespace jounce::test

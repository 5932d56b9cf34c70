#include "executor/log_judge.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

namespace jounce::test {
namespace {

using What = Accepted::What;

struct Line {
  std::int64_t tick = 0;
  std::string_view state{};
  double p = 0, v = 0, a = 0;
  bool path = false;         // a table, a stream or a coupling is played
  std::string_view fault{};  // "none", or why the axis is in error
  [[nodiscard]] bool failed() const { return fault != "none"; }
};

/// Faults that leave the setpoint where it is: nothing brakes it.
constexpr std::string_view freezing[] = {"disabled_in_motion", "following_error", "drive_fault",
                                         "drive_not_ready", "stalled"};

double number(std::string_view text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

Line line_of(std::string_view text) {
  std::string_view cells[10];
  for (std::string_view& cell : cells) {
    const std::size_t comma = text.find(',');
    cell = text.substr(0, comma);
    text.remove_prefix(std::min(text.size(), cell.size() + 1));
  }
  return {static_cast<std::int64_t>(number(cells[0])),
          cells[2],
          number(cells[5]),
          number(cells[6]),
          number(cells[7]),
          cells[8] != "0",
          cells[9]};
}

/// The lines of a log, without its head.
class Lines {
 public:
  explicit Lines(const std::string& csv) : rest_(csv) { static_cast<void>(text()); }

  std::optional<Line> next() {
    const std::string_view line = text();
    return line.empty() ? std::nullopt : std::optional(line_of(line));
  }

 private:
  std::string_view text() {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return line;
  }
  std::string_view rest_;
};

class Judge {
 public:
  Judge(const Bounds& bounds, const std::vector<Accepted>& orders, const std::string& leader)
      : bounds_(bounds), orders_(orders), leader_(leader) {}

  void take(const Line& now) {
    obey(now);
    follow(now);
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

  /// What the orders that have been answered by now allow, and what they demand.
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
      if (order->what == What::moves) begin(*order);
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

  /// What was accepted before it and waits for its tick is void.
  void revoke(const Accepted& by) {
    licensed_ = false;
    for (const Accepted*& order : open_)
      if (order != nullptr && order->what == What::moves && order->sent < by.sent) order = nullptr;
  }

  void begin(const Accepted& order) {
    licensed_ = true;
    rest_by_.reset();
    ratio_ = std::max(ratio_, order.ratio);
  }

  static double given(double value, double limit) { return value > 0 ? value : limit; }

  /// Of the three that the axis is configured with; an order that it did not take while it failed changes nothing.
  [[nodiscard]] double gentlest_brake() const {
    const double stop = bounds_.stop_acceleration;
    return std::min(
        {stop, given(bounds_.limit_acceleration, stop), given(bounds_.abort_acceleration, stop)});
  }
  [[nodiscard]] double hardest_brake() const {
    return std::max(
        {bounds_.stop_acceleration, bounds_.limit_acceleration, bounds_.abort_acceleration});
  }

  [[nodiscard]] bool freezes(const Line& now) const {
    if (now.fault == "aborted") return bounds_.abort_acceleration == 0;
    return std::find(std::begin(freezing), std::end(freezing), now.fault) != std::end(freezing);
  }

  void demand_stop(const Line& now, const std::string& by) {
    demanded_by_ = by;
    stops_ = true;
    const double jerk = bounds_.jerk ? bounds_.stop_jerk : HUGE_VAL;
    demand(now, now.failed() ? gentlest_brake() : bounds_.stop_acceleration, jerk);
  }

  /// No other motion may have begun after it. Of orders that overlap, who came first is not known.
  [[nodiscard]] bool last_of_motions(const Accepted& order) const {
    const auto sent = orders_.begin() + static_cast<std::ptrdiff_t>(next_);
    return std::none_of(orders_.begin(), sent, [&](const Accepted& other) {
      return &other != &order && (other.what == What::moves || other.what == What::rests) &&
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
    demand(now, given(order.acceleration, bounds_.acceleration),
           given(order.jerk, bounds_.jerk.value_or(HUGE_VAL)));
  }

  /// First the acceleration must end, then the velocity, and the braking too.
  void demand(const Line& now, double a, double j) {
    const double first = std::abs(now.a) / j;
    const double faster = std::abs(now.v) + std::abs(now.a) * first / 2;
    double time = first + faster / a + 2 * a / j + std::sqrt(2 * faster / j);
    if (now.path || last_.path) time = std::max(time, bounds_.path_stop_time);
    constexpr double longest = 1e6;  // s: an order may ask for as little as it likes
    time = std::min(1.01 * time, longest);
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
    const double a = hardest_brake();
    double tail =
        out(last_.p) > 0 && bounds_.jerk ? a * a * a / (bounds_.stop_jerk * bounds_.stop_jerk) : 0;
    // Outside, a fault may come where a coupling has just turned the axis round.
    if (now.failed()) tail += last_.v * last_.v / (2 * gentlest_brake());
    if (out(now.p) > (placed_ ? HUGE_VAL : out(last_.p)) + tail + rounding)
      find(now, "position out of the range", now.p, now.p > high ? high : low);
  }

  void within_limits(const Line& now) {
    const double rounding = 1e-6;
    // An acceleration that a fault ends goes down by the jerk of a stop: meanwhile the velocity rises.
    const double a = hardest_brake();
    const bool rises = now.failed() && bounds_.jerk;
    const double fastest = bounds_.velocity + (rises ? a * a / (2 * bounds_.stop_jerk) : 0);
    if (std::abs(now.v) > fastest * (1 + 1e-9) + rounding) find(now, "velocity", now.v, fastest);
    if (frozen_) return;
    const bool stop_limits = now.state == "stopping" || now.path || last_.path;
    const bool fails = now.failed() || last_.failed();
    const double most = fails         ? hardest_brake()
                        : stop_limits ? bounds_.stop_acceleration
                                      : bounds_.acceleration;
    // What leaves a live master or a path may begin above its own limit; it must come down.
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
    const double most = hardest_brake();
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
    // What it did in ticks that were left out is not known.
    const bool late = rest_by_ && (now.v != 0 ? now.tick : last_.tick) > *rest_by_;
    if (late && moves) {
      words_ = demanded_by_ + " until tick " + std::to_string(*rest_by_) + "; " + words_;
      find(now, "not at rest in the time of its stop", now.v, 0);
      rest_by_.reset();
    }
    if (moves && !moved_ && !licensed_ && !now.failed())
      find(now, "begins to move without an order", now.v, 0);
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
  bool licensed_ = false;
  bool frozen_ = false;  // in this tick
  bool may_freeze_ = false;
  bool stops_ = false;  // what it must rest for is a stop or a fault
  double ratio_ = 0;    // the greatest of the gears so far
  Lines leader_;
  Line master_;             // of this tick
  double master_step_ = 0;  // u/s^2
  double master_dv_ = 0;    // u/s
  std::optional<std::int64_t> rest_by_;
};

}  // namespace

std::vector<std::string> judged(const std::string& csv, const Bounds& bounds,
                                const std::vector<Accepted>& orders, const std::string& leader) {
  Judge judge(bounds, orders, leader);
  Lines lines(csv);
  while (const auto line = lines.next()) judge.take(*line);
  return judge.findings;
}

}  // namespace jounce::test

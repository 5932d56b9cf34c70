// SPDX-License-Identifier: Apache-2.0
// adversary [ORDERS [SEED [WITHOUT...]]]: random orders of all kinds, valid and not, from several
// sessions, through the protocol to an executor on a virtual clock; a judge that reads only its
// tick logs reports the violations. ORDERS up to 1000 run on one executor, print what it accepted,
// and leave its logs. WITHOUT: kinds that are not sent.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/drive/machine_sensors.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/stream_group.hpp"

#include "executor/record/log_judge.hpp"
#include "executor/record/log_line.hpp"
#include "executor/site.hpp"
#include "stream/src/transport/lossy_transport.hpp"
#include "support/random.hpp"

namespace jounce::test {
namespace {

using namespace std::chrono_literals;
using test::Random;

constexpr int client_commands = std::variant_size_v<ClientCommand>;
constexpr int orders_each = 1000;   // per executor
std::vector<std::string> left_out;  // names of kinds, to look for what else there is

/// A machine of two axes: the second one follows the first. Its numbers are drawn; every other axis has switches.
struct Drawn {
  Bounds bounds[2];
  std::vector<ExecutorOptions> axes;
};

std::filesystem::path log_path(std::size_t axis) {
  return std::filesystem::temp_directory_path() /
         ("jounce-adversary-" + std::to_string(getpid()) + "-" + std::to_string(axis) + ".csv");
}

/// There and back within half of the axis's limits, so that it may also run twice as fast.
std::shared_ptr<const Table> own_table(const Bounds& b, double reach) {
  double time = 4 * reach / b.velocity * 1.9;
  time = std::max(time, 2 * std::sqrt(5.8 * reach * 4 / b.acceleration));
  if (b.jerk) time = std::max(time, 2 * std::cbrt(60 * reach * 8 / *b.jerk));
  return std::make_shared<const Table>(
      Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
      Columns{{0, time / 2, time}, {0, reach, 0}, {0, 0, 0}, {0, 0, 0}});
}

/// Limit switches, a home switch and an index, so close together that a search takes a second or so. A switch is
/// wider than what an axis goes while it stops.
void add_switches(Random& random, ExecutorOptions& axis, Bounds& b) {
  const HomingSpec& homing = axis.axis.homing;
  const double fastest = std::max(homing.search_velocity, homing.index_velocity);
  const double braking =
      fastest * time_to_rest(fastest, 0, homing.acceleration, b.jerk.value_or(HUGE_VAL));
  const double reach = fastest * random.uniform(0.2, 1) + 4 * braking;
  const double bounce = random.below(2) == 0 ? 0 : random.uniform(0.001, 0.005);
  MachineBounds m;
  m.negative = -reach;
  m.positive = reach * random.uniform(0.5, 2);
  m.start = random.uniform(m.negative, m.positive);
  m.home_low = random.uniform(m.negative / 2, m.positive / 2);
  const bool to_the_end = random.below(3) == 0;
  m.home_high = to_the_end ? HUGE_VAL : m.home_low + braking * random.uniform(1.5, 4);
  m.index_period = reach * random.log_uniform(0.02, 0.5);
  m.index_offset = random.uniform(0, m.index_period);
  m.tolerance = bounce * homing.index_velocity;
  axis.drive = std::make_shared<DriveOnMachine>(
      std::make_shared<NullDrive>(),
      MachineSensorsSpec{.encoder_offset = m.start,
                         .home = MachineSwitch{.position = m.home_low,
                                               .width = m.home_high - m.home_low,
                                               .bounce = bounce},
                         .negative = negative_switch(m.negative, bounce),
                         .positive = positive_switch(m.positive, bounce),
                         .index = MachineIndex{.period = m.index_period, .offset = m.index_offset}},
      b.period);
  b.machine = m;
  axis.axis.require_home = random.below(6) == 0;
}

ExecutorOptions axis_of(Random& random, std::size_t i, Bounds& b) {
  const char* const names[] = {"feeder", "knife"};
  ExecutorOptions axis = axis_named(names[i], {}, {"mm", "mm"});
  b.velocity = random.log_uniform(10, 2000);
  b.acceleration = b.velocity * random.log_uniform(2, 100);
  if (random.below(3) != 0) b.jerk = b.acceleration * random.log_uniform(5, 500);
  b.stop_acceleration = b.acceleration * (random.below(2) != 0 ? 2 : random.uniform(1.1, 6));
  if (b.jerk) b.stop_jerk = *b.jerk * (random.below(2) != 0 ? 2 : random.uniform(1.1, 6));
  if (random.below(4) != 0) {
    b.lowest = -random.uniform(0, 500);
    b.highest = random.uniform(10, 500);
  }
  axis.axis.limits = {.position_min = b.lowest,
                      .position_max = b.highest,
                      .velocity = b.velocity,
                      .acceleration = b.acceleration,
                      .jerk = b.jerk};
  if (random.below(3) == 0) b.limit_acceleration = b.acceleration * random.uniform(0.3, 1.5);
  if (random.below(3) == 0) b.abort_acceleration = b.acceleration * random.uniform(0.5, 4);
  axis.axis.limit_acceleration = b.limit_acceleration;
  axis.axis.abort_acceleration = b.abort_acceleration;
  axis.axis.stop_acceleration = b.stop_acceleration;
  axis.axis.stop_jerk = b.stop_jerk;
  if (i == 0 && random.below(5) == 0) axis.axis.modulo = random.uniform(5, 400);
  const auto table = own_table(b, 0.5 * b.highest.value_or(100));
  axis.table =
      StoredTable{.hash = content_hash(*table, {"s", "mm"}), .units = {"s", "mm"}, .table = table};
  b.path_stop_time = 2 * table->columns().x.back() + 6 * b.velocity / b.acceleration;
  axis.log = log_path(i);
  axis.axis.homing = {.method = 24,
                      .search_velocity = b.velocity * random.uniform(0.1, 1),
                      .index_velocity = b.velocity * random.uniform(0.02, 0.3),
                      .acceleration = b.acceleration * random.uniform(0.3, 1),
                      .offset = random.uniform(-20, 20),
                      .timeout = random.below(4) == 0 ? random.uniform(0.1, 2) : 20};
  if (random.below(2) == 0) add_switches(random, axis, b);
  axis.adopt_start = random.below(2) == 0;
  axis.receiver.session_timeout = 300ms;
  return axis;
}

Drawn drawn(Random& random) {
  Drawn all;
  for (std::size_t i = 0; i < 2; ++i) all.axes.push_back(axis_of(random, i, all.bounds[i]));
  all.axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  return all;
}

/// Numbers that an operator, a program or a fault may send.
double nasty(Random& random) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double some[] = {0,     -0.0,  1,      -1,   2,     0.5, 1e-9, -1e-9, 1e-300, 1e9,
                             -1e9,  1e300, -1e300, inf,  -inf,  NAN, 3,    4,     5,      6,
                             1e-12, 1e15,  100,    -100, 0.001, 1e6, -2,   7,     10,     1e-6};
  return some[random.below(static_cast<int>(std::size(some)))];
}

/// A magnitude that the axis may take, of a limit; NaN: not given, as it is configured.
double share(Random& random, double limit) {
  const int what = random.below(8);
  if (what < 3) return NAN;
  if (what == 3) return limit;
  if (what == 4) return limit * random.log_uniform(1e-3, 1);
  if (what == 5) return nasty(random);
  return limit * random.uniform(0.1, 1);
}

double place(Random& random, const Bounds& b) {
  if (random.below(12) == 0) return nasty(random);
  const double low = b.lowest.value_or(-400);
  const double high = b.highest.value_or(400);
  const int what = random.below(8);
  if (what == 0) return low;
  if (what == 1) return high;
  return random.uniform(low - 10, high + 10);
}

/// A homing by any method, and by numbers that are none; mostly by one that searches where there are switches.
CommandValues home_values(Random& random, const Bounds& b) {
  const int method = b.machine && random.below(8) != 0 ? 1 + random.below(34) : random.below(40);
  const auto seldom = [&](double some) { return random.below(4) == 0 ? some : NAN; };
  return CommandValues{random.below(3) == 0 ? NAN : place(random, b),
                       static_cast<double>(method),
                       seldom(share(random, b.velocity)),
                       seldom(share(random, b.velocity) * 0.2),
                       seldom(share(random, b.acceleration)),
                       seldom(random.uniform(0.05, 3)),
                       seldom(b.velocity * random.uniform(0.01, 2))};
}

/// `state`: what the axis does now.
wire::Command order_of(Random& random, const Bounds& b, State state) {
  wire::Command order{
      .kind = sent_commands()[static_cast<std::size_t>(random.below(client_commands))]->kind};
  // Half of all orders move: otherwise what is in motion would be rare.
  if (random.below(2) == 0)
    order.kind = *kind_of_number(8 + random.below(5));
  else if (random.below(6) == 0)
    order.kind = CommandKind::enable;
  if (b.machine && state == State::standstill && random.below(4) == 0)
    order.kind = CommandKind::home;
  // A coupling with something on top of it would be rare, too.
  if (state == State::synchronized_motion && random.below(3) == 0)
    order.kind = CommandKind::move_superimposed;
  auto& value = order.value;
  const double j = b.jerk.value_or(b.acceleration * 10);
  const auto rates = [&](std::size_t first) {
    value[first] = share(random, b.velocity);
    value[first + 1] = share(random, b.acceleration);
    value[first + 2] = share(random, b.acceleration);
    value[first + 3] = share(random, j);
  };
  const double mode = random.below(2) == 0 ? 0 : random.below(6);
  switch (order.kind) {
    case CommandKind::move_absolute:
      value[0] = place(random, b);
      rates(1);
      value[5] = random.below(3) - 1;
      value[6] = mode;
      break;
    case CommandKind::move_relative:
    case CommandKind::move_additive:
    case CommandKind::move_superimposed:
      value[0] = place(random, b) * random.uniform(0, 1);
      rates(1);
      if (order.kind == CommandKind::move_relative) value[5] = mode;
      break;
    case CommandKind::move_velocity:
      rates(0);
      if (std::isnan(value[0])) value[0] = 0;  // a velocity of 0 is rest, and has to be given
      value[0] *= random.below(2) == 0 ? 1 : -1;
      value[4] = mode;
      value[5] = random.below(4) == 0 ? 1 : 0;  // hold-to-run
      break;
    case CommandKind::halt:
      value[0] = share(random, b.acceleration);
      value[1] = share(random, j);
      break;
    case CommandKind::override_:
      value[0] = random.below(4) == 0 ? nasty(random) : random.uniform(0, 2);
      break;
    case CommandKind::gear_in:
    case CommandKind::gear_in_pos:
      value[0] = random.below(9) - 4;
      value[1] = random.below(6);
      if (order.kind == CommandKind::gear_in) {
        value[2] = share(random, b.acceleration);
        value[3] = share(random, b.acceleration);
        value[4] = share(random, j);
      } else {
        value[2] = random.uniform(-100, 100);
        value[3] = place(random, b);
        value[4] = random.uniform(0, 100);
      }
      break;
    case CommandKind::home:
      value = home_values(random, b);
      break;
    case CommandKind::phasing_absolute:
    case CommandKind::phasing_relative:
      value[0] = place(random, b);
      rates(1);
      break;
    case CommandKind::combine_axes:
      for (std::size_t i : {0U, 2U}) value[i] = random.below(9) - 4;
      for (std::size_t i : {1U, 3U}) value[i] = random.below(6);
      for (std::size_t i : {4U, 5U}) value[i] = share(random, b.acceleration);
      value[6] = share(random, j);
      break;
    case CommandKind::change_velocity:
      value[0] = share(random, b.velocity);
      value[1] = random.below(2) == 0 ? NAN : place(random, b);
      value[2] = random.below(3) - 1;
      break;
    case CommandKind::move_repetitive:
      value[0] = place(random, b);
      rates(1);
      value[5] = random.below(2) == 0 ? 0 : random.uniform(0, 0.2);
      value[6] = random.below(5);
      break;
    default:
      for (std::size_t i = 0; i < info(order.kind).fields.size(); ++i)
        value[i] = random.below(3) == 0 ? nasty(random) : place(random, b);
      if (order.kind == CommandKind::set_position) value[1] = random.below(2);
  }
  if (random.below(20) == 0) value[static_cast<std::size_t>(random.below(8))] = nasty(random);
  return order;
}

std::string words_of(const wire::Command& order, std::size_t axis) {
  std::ostringstream text;
  text.precision(17);
  text << (axis == 0 ? "feeder " : "knife ") << name(order.kind) << " at " << order.at << " [";
  for (const double value : order.value) text << value << ' ';
  text << ']';
  return text.str();
}

/// 0: the axis's own.
double given(double magnitude) {
  return magnitude > 0 ? magnitude : 0;
}

Accepted accepted(const wire::Command& order, const HomingSpec& homing) {
  using What = Accepted::What;
  const auto& v = order.value;
  switch (order.kind) {
    case CommandKind::enable:
    case CommandKind::reset:
    case CommandKind::queue_switch:
    case CommandKind::queue_clear:
    case CommandKind::queue_end:
      return {.what = What::other};
    case CommandKind::disable:
      return {.what = What::disables};
    case CommandKind::set_position:
      return {.what = What::places};
    case CommandKind::home: {
      const auto chosen = [&](std::size_t i, double own) { return std::isnan(v[i]) ? own : v[i]; };
      return {
          .what = What::homes,
          .acceleration = chosen(4, homing.acceleration),
          .method = std::isnan(v[1]) || v[1] == 0 ? homing.method
                                                  : static_cast<int>(std::clamp(v[1], 0.0, 99.0)),
          .fastest = std::max(chosen(2, homing.search_velocity), chosen(3, homing.index_velocity)),
          .home = chosen(0, homing.offset),
          .timeout = chosen(5, homing.timeout)};
    }
    case CommandKind::hold:
      return {.what = What::rests};
    case CommandKind::halt:
      return {.what = What::rests, .acceleration = given(v[0]), .jerk = given(v[1])};
    case CommandKind::move_velocity: {
      const double a = std::min(v[1] > 0 ? v[1] : HUGE_VAL, v[2] > 0 ? v[2] : HUGE_VAL);
      const bool rests = v[0] == 0 && v[4] == 0;
      return {.what = rests ? What::rests : What::moves,
              .acceleration = std::isinf(a) ? 0 : a,
              .jerk = given(v[3])};
    }
    case CommandKind::move_absolute:
    case CommandKind::move_relative:
    case CommandKind::move_additive:
    case CommandKind::move_superimposed: {
      const double a = std::min(v[2] > 0 ? v[2] : HUGE_VAL, v[3] > 0 ? v[3] : HUGE_VAL);
      return {.what = What::moves, .acceleration = std::isinf(a) ? 0 : a, .jerk = given(v[4])};
    }
    case CommandKind::gear_in: {
      const double a = std::min(v[2] > 0 ? v[2] : HUGE_VAL, v[3] > 0 ? v[3] : HUGE_VAL);
      return {.what = What::moves,
              .acceleration = std::isinf(a) ? 0 : a,
              .jerk = given(v[4]),
              .ratio = std::abs(v[0] / v[1])};
    }
    case CommandKind::gear_in_pos:
    case CommandKind::phasing_absolute:
    case CommandKind::phasing_relative:
    case CommandKind::combine_axes:
      return {.what = What::moves, .ratio = HUGE_VAL};
    default:
      return {.what = What::moves};
  }
}

std::size_t times_homed(const std::string& csv) {
  std::size_t times = 0;
  std::optional<Line> before;
  Lines lines(csv);
  while (const auto now = lines.next()) {
    times += before && now->homed && !before->homed && before->state == "homing" ? 1 : 0;
    before = now;
  }
  return times;
}

/// Sends orders to one executor, and has its logs judged.
class Episode {
 public:
  explicit Episode(std::uint64_t seed) : random_(seed), drawn_(drawn(random_)), site_(drawn_.axes) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (int session = 0; session < 2; ++session)
        clients_[axis].push_back(
            std::make_unique<Client>(site_.link, drawn_.axes[axis].receiver.executor,
                                     ClientOptions{.patience = 100ms, .repeat = 1ms}, site_.clock));
    site_.after = [this] { watch_groups(); };
  }

  std::vector<std::string> run(int orders) {
    for (int i = 0; i < orders; ++i) step();
    site_.advance(500ms);
    site_.dispatcher.close();
    std::vector<std::string> all;
    judge_groups(all);
    std::string leader;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::ifstream file(log_path(axis));
      std::string csv{std::istreambuf_iterator<char>(file), {}};
      ticks += std::count(csv.begin(), csv.end(), '\n');
      homed += times_homed(csv);
      for (const std::string& one : judged(csv, drawn_.bounds[axis], accepted_[axis], leader))
        all.push_back((axis == 0 ? "feeder: " : "knife: ") + one);
      leader = std::move(csv);
      file.close();
      if (keep)
        for (const Accepted& order : accepted_[axis])
          std::printf("ticks %lld to %lld: %s\n", static_cast<long long>(order.sent),
                      static_cast<long long>(order.answered), order.words.c_str());
      else
        std::filesystem::remove(log_path(axis));
    }
    return all;
  }

  std::int64_t ticks = 0;
  std::size_t taken = 0;
  std::size_t homed = 0;                  ///< searches that found their home
  std::size_t together = 0, neither = 0;  ///< groups of both axes that began, and that did not
  bool keep = false;                      ///< its logs

 private:
  /// Most searches may go on: their session sends heartbeats meanwhile.
  void let_search() {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (site_.last(axis).state != State::homing || random_.below(3) == 0) continue;
      for (int i = 0; i < 20 && site_.last(axis).state == State::homing; ++i) {
        for (const auto& client : clients_[axis])
          if (client->session() != 0) static_cast<void>(client->beat());
        site_.advance(Nanos(random_.below(100) * 1'000'000));
      }
    }
  }

  void step() {
    let_search();
    const auto axis = static_cast<std::size_t>(random_.below(3) == 0);
    Client& client = *clients_[axis][random_.below(10) == 0];
    const int what = random_.below(40);
    if (what == 0) {
      stop(axis, client);
    } else if (what == 1) {
      operators(axis);
    } else if (what == 2) {
      stream(axis);
    } else if (what == 3) {
      static_cast<void>(client.release());
    } else {
      const wire::Command order = timed(wanted(axis), axis);
      if (std::count(left_out.begin(), left_out.end(), name(order.kind)) > 0) return;
      give(axis, client, order);
      if (random_.below(20) == 0) give(axis, client, order);
    }
    // A cycle that comes late leaves ticks out; one as late as longest_gap, which is rare, is a fault.
    if (random_.below(30) == 0)
      site_.pacer.delay = (random_.below(10) == 0 ? 120 : random_.below(30)) * 1'000'000;
    const int pause = random_.below(40);
    site_.advance(pause == 0 ? 400ms : pause < 4 ? 60ms : Nanos(random_.below(12) * 1'000'000));
  }

  /// Often what brings an axis back that takes nothing else now.
  wire::Command wanted(std::size_t axis) {
    const State state = site_.last(axis).state;
    const bool idle = random_.below(2) == 0;
    if (idle && state == State::disabled) return {.kind = CommandKind::enable};
    if (idle && state == State::error_stop) return {.kind = CommandKind::reset};
    wire::Command order = order_of(random_, drawn_.bounds[axis], state);
    if (axis == 1 && state == State::standstill && random_.below(3) == 0) {
      order = {.kind = CommandKind::gear_in};
      order.value = {double(random_.below(5) - 2), double(1 + random_.below(3)), NAN, NAN, NAN};
    }
    return order;
  }

  wire::Command timed(wire::Command order, std::size_t axis) {
    if (random_.below(15) == 0) order.at = site_.last(axis).tick + random_.below(200) - 20;
    return order;
  }

  [[nodiscard]] std::int64_t tick(std::size_t axis) const { return site_.last(axis).tick; }

  void note(std::size_t axis, Accepted done, std::int64_t sent, const std::string& words) {
    done.sent = sent;
    done.answered = tick(axis);
    done.words = words;
    accepted_[axis].push_back(std::move(done));
    ++taken;
  }

  void give(std::size_t axis, Client& client, const wire::Command& order) {
    const std::int64_t sent = tick(axis);
    const CallOutcome outcome = client.request(order);
    if (outcome.error == StreamError::refused) return;
    Accepted done = accepted(order, drawn_.axes[axis].axis.homing);
    using What = Accepted::What;
    // Without an answer it takes effect soon, or never.
    const std::int64_t by = tick(axis) + (outcome.ok() ? 0 : 300);
    if ((order.at >= 0 || !outcome.ok()) && done.what == What::places) {
      done.sent = sent;
      done.answered = std::max(order.at, by);
      done.words = words_of(order, axis);
      accepted_[axis].push_back(done);
      return;
    }
    // A later order may replace another stop, so the axis need not stop by then.
    if ((order.at >= 0 || !outcome.ok()) && done.what != What::moves && done.what != What::homes)
      done.what = done.what == What::rests ? What::moves : What::other;
    note(axis, done, sent, words_of(order, axis));
    accepted_[axis].back().answered = std::max(order.at, by);
    // If a table adopts the position, its start names it.
    if (order.kind == CommandKind::start_table) also(axis, Accepted::What::places);
  }

  void also(std::size_t axis, Accepted::What what) {
    accepted_[axis].push_back(accepted_[axis].back());
    accepted_[axis].back().what = what;
  }

  /// Both axes at once, over a link that loses packets: the streamer may give up between two starts.
  void lose_both(std::vector<StreamPlan> plans) {
    const std::int64_t sent[] = {tick(0), tick(1)};
    const LossSpec loss{.seed = random_.next(), .lost = random_.uniform(0.05, 0.7)};
    LossyTransport lossy(site_.link, loss, site_.clock);
    StreamOptions brief;
    brief.total = 500ms;
    static_cast<void>(stream_group(lossy, std::move(plans), {.watch = false}, brief, site_.clock));
    constexpr std::int64_t at_most = 400;  // ticks: the lead of a start, and what is on its way
    for (std::size_t axis = 0; axis < 2; ++axis) {
      note(axis, {.what = Accepted::What::moves}, sent[axis],
           "tables are streamed to both axes, with loss");
      accepted_[axis].back().answered += at_most;
      also(axis, Accepted::What::places);
    }
  }

  /// The groups in which each axis was armed, and the ticks of their first point (where it stands) and second point.
  void watch_groups() {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Tick& now = site_.last(axis);
      if (now.next.group != 0) armed_[axis].insert(now.next.group);
      if (now.group == 0) continue;
      const auto first = first_[axis].try_emplace(now.group, now.tick).first;
      if (now.tick > first->second) second_[axis].try_emplace(now.group, now.tick);
    }
  }

  /// A group that was armed on both axes began in one tick, or neither has given out more than its first point.
  void judge_groups(std::vector<std::string>& findings) {
    for (const std::int64_t group : armed_[0]) {
      if (!armed_[1].contains(group)) continue;
      const auto x = first_[0].find(group), y = first_[1].find(group);
      const bool none = !second_[0].contains(group) && !second_[1].contains(group);
      const bool both = x != first_[0].end() && y != first_[1].end() && x->second == y->second;
      together += both ? 1 : 0;
      neither += none && !both ? 1 : 0;
      if (none || both) continue;
      findings.push_back(
          "a group began at tick " + (x == first_[0].end() ? "-" : std::to_string(x->second)) +
          " of the feeder and " + (y == first_[1].end() ? "-" : std::to_string(y->second)) +
          " of the knife");
    }
  }

  /// Both axes at rest where their tables begin, and free: otherwise both would seldom be armed.
  void prepare_both() {
    for (std::size_t axis = 0; axis < 2; ++axis) stop(axis, *clients_[axis][0]);
    site_.advance(300ms);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Client& client = *clients_[axis][0];
      give(axis, client, {.kind = CommandKind::reset});
      give(axis, client, {.kind = CommandKind::enable});
      site_.advance(5ms);
      give(axis, client, wire::message_of(command::Home{.offset = 0, .method = 37}));
      static_cast<void>(client.release());
      static_cast<void>(clients_[axis][1]->release());
    }
  }

  /// Both axes at once: what one session has started stops together.
  void stream_both() {
    if (random_.below(4) != 0) prepare_both();
    const std::int64_t sent[] = {tick(0), tick(1)};
    std::vector<StreamPlan> plans;
    for (const ExecutorOptions& axis : drawn_.axes)
      plans.push_back(
          {.executor = axis.receiver.executor, .tables = {{*axis.table->table, {"s", "mm"}}}});
    if (random_.below(3) != 0) return lose_both(std::move(plans));
    StreamOptions brief;
    brief.total = 500ms;
    const auto outcomes =
        stream_group(site_.link, std::move(plans), {.watch = false}, brief, site_.clock);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!outcomes[axis].armed) continue;
      note(axis, {.what = Accepted::What::moves}, sent[axis], "tables are streamed to both axes");
      also(axis, Accepted::What::places);
    }
    if (!outcomes[0].armed || !outcomes[1].armed || random_.below(2) == 0) return;
    site_.advance(Nanos(random_.below(200) * 1'000'000));
    const auto first = static_cast<std::size_t>(random_.below(2));
    stop(first, *clients_[first][0]);
  }

  /// The other axis of a group, after a stop that ended this one's motion.
  void stop_other(std::size_t axis, std::int64_t sent) {
    const Tick& now = site_.last(axis);
    const bool ended = now.state == State::stopping || now.reason == Cause::stopped ||
                       now.reason == Cause::aborted;
    if (!ended) return;
    site_.turn();
    note(1 - axis, {.what = Accepted::What::stops}, sent,
         "the other axis of the group was stopped");
  }

  void stop(std::size_t axis, Client& client) {
    const auto of = [&](std::size_t i) {
      const Tick& now = site_.last(i);
      return now.next.accepted ? now.next.group : now.group;
    };
    const bool tied = of(axis) != 0 && of(axis) == of(1 - axis);
    const bool abort = random_.below(4) == 0;
    const std::int64_t sent = tick(axis);
    const wire::StopMode mode = abort ? wire::StopMode::abort : wire::StopMode::stop;
    const bool operators = random_.below(2) == 0;
    const std::string& name = drawn_.axes[axis].receiver.executor;
    const bool done = operators ? operator_stop(site_.link, name, mode, 100ms, {}, site_.clock)
                                : client.stop(mode).ok();
    if (done)
      note(axis, {.what = Accepted::What::stops, .aborts = abort}, sent,
           name + (abort ? " abort" : " stop"));
    if (done && tied) stop_other(axis, sent);
  }

  void operators(std::size_t axis) {
    constexpr CommandKind kinds[] = {CommandKind::hold, CommandKind::resume,
                                     CommandKind::override_};
    wire::Command order{.kind = kinds[random_.below(3)]};
    if (order.kind == CommandKind::override_) order.value[0] = random_.uniform(-0.1, 2.1);
    const std::int64_t sent = tick(axis);
    const wire::Reply reply = operator_command(site_.link, drawn_.axes[axis].receiver.executor,
                                               order, 100ms, {}, site_.clock);
    if (reply.outcome == wire::Outcome::accepted)
      note(axis, accepted(order, drawn_.axes[axis].axis.homing), sent, words_of(order, axis));
  }

  void stream(std::size_t axis) {
    if (random_.below(3) == 0) return stream_both();
    const std::int64_t sent = tick(axis);
    const bool follows = axis == 1 && random_.below(2) == 0;
    StreamPlan plan;
    plan.executor = drawn_.axes[axis].receiver.executor;
    if (follows)
      plan = cam(std::move(plan));
    else
      plan.tables = {{*drawn_.axes[axis].table->table, {"s", "mm"}}};
    const StreamOutcome outcome = site_.stream(std::move(plan));
    if (outcome.error == StreamError::refused && !outcome.armed) return;
    note(axis, {.what = Accepted::What::moves, .ratio = follows ? HUGE_VAL : 0}, sent,
         follows ? "a cam is streamed and coupled" : "a table is streamed and started");
    also(axis, Accepted::What::places);
  }

  /// Behind the live master, from where both are.
  StreamPlan cam(StreamPlan plan) {
    const double reach = random_.uniform(1, 20);
    const double period = reach * random_.log_uniform(5, 50);
    const Table table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                      Columns{{0, period / 2, period}, {0, reach, 0}, {0, 0, 0}, {0, 0, 0}});
    plan.tables = {{table, {"mm", "mm"}}};
    plan.mode = wire::ArmMode::follow_input;
    plan.coupling.start = StartMode::relative;
    return plan;
  }

  Random random_;
  Drawn drawn_;
  std::set<std::int64_t> armed_[2];                            // groups
  std::map<std::int64_t, std::int64_t> first_[2], second_[2];  // ticks, by group
  std::vector<Accepted> accepted_[2];
  // Last, so destroyed first: a client sends its release then, and watch_groups() runs again.
  Site site_;
  std::vector<std::unique_ptr<Client>> clients_[2];
};

}  // namespace
}  // namespace jounce::test

int main(int count, char** arguments) {
  using namespace jounce::test;
  const long orders = count > 1 ? std::atol(arguments[1]) : 100'000;
  const std::uint64_t first = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 20261122;
  for (int i = 3; i < count; ++i) left_out.emplace_back(arguments[i]);
  std::int64_t ticks = 0;
  std::size_t taken = 0;
  std::size_t homed = 0, together = 0, neither = 0;
  std::size_t findings = 0;
  for (long i = 0; i * orders_each < orders; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    Episode episode(seed);
    episode.keep = orders <= orders_each;
    if (episode.keep) std::printf("%s\n%s\n", log_path(0).c_str(), log_path(1).c_str());
    for (const std::string& finding : episode.run(orders_each)) {
      if (++findings <= 200)
        std::printf("adversary %d %llu: %s\n", orders_each, static_cast<unsigned long long>(seed),
                    finding.c_str());
    }
    ticks += episode.ticks;
    taken += episode.taken;
    homed += episode.homed;
    together += episode.together;
    neither += episode.neither;
  }
  std::printf(
      "%ld orders, %zu of them accepted; %zu homings ended at home; of the groups of both axes %zu "
      "began and "
      "%zu did not; %lld ticks of log; %zu findings\n",
      orders, taken, homed, together, neither, static_cast<long long>(ticks), findings);
  const bool tried = (homed > 0 && together > 0 && neither > 0) || orders < 10 * orders_each;
  if (!tried)
    std::printf("no homing ended at home, or no group began, or all did: too little was tried\n");
  return findings == 0 && tried ? 0 : 1;
}

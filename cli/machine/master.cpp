// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/master.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/design/executor_tables.hpp"
#include "jounce/drive/encoder.hpp"
#include "jounce/executor/cycle.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/input.hpp"
#include "cli/common/interrupt.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {
namespace {

struct MasterArguments {
  std::string file;
  std::string axis;
  std::string name;
  LinkOptions link;
  double rate = 1000;
  double before = 1;
  double after = 1;
  std::optional<double> seconds;
  std::optional<std::int32_t> epoch;
  std::string noise;  // quantities, of the table's unit
  std::string resolution;
  std::uint64_t seed = EncoderErrors{}.seed;
  bool json = false;
};

/// A sender that begins later has a greater number: seconds of the clock on the wall, since 2020.
std::int32_t epoch_now() {
  constexpr std::int64_t since = 1577836800;
  const auto now = static_cast<std::int64_t>(std::time(nullptr)) - since;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(now, 0, std::numeric_limits<std::int32_t>::max()));
}

/// A quantity of the table's unit; empty: 0.
double magnitude_of(const char* option, const std::string& text, const std::string& unit) {
  if (text.empty()) return 0;
  const auto refuse = [&](const std::string& rule) { throw InputError(option, text, rule); };
  double value = 0;
  try {
    value = quantity(text, unit);
  } catch (const InputError& error) {
    refuse(error.rule());
  }
  if (!(value >= 0 && value <= 1e9)) refuse("must be from 0 to 1e9 " + unit);
  return value;
}

EncoderErrors errors_of(const MasterArguments& options, const std::string& unit) {
  return {.resolution = magnitude_of("--resolution", options.resolution, unit),
          .noise = magnitude_of("--noise", options.noise, unit),
          .seed = options.seed};
}

/// The motion in seconds, and the duration of the transmission; infinite if it repeats.
struct Play {
  TableFile file;
  double length = 0;
};

Play play_of(const MasterArguments& options) {
  ExecutorTables tables = executor_tables(load(options.file, options.axis));
  const Table& table = tables.slave.table;
  if (tables.master || table.axis() != Domain::time)
    throw InputError("FILE", options.file, "must be over time: a master is a function of time");
  const bool endless = repeats(table.outside());
  double length = options.before + options.after + table.end() - table.start();
  if (endless) length = std::numeric_limits<double>::infinity();
  return {std::move(tables.slave), options.seconds.value_or(length)};
}

struct Said {
  std::int64_t samples = 0;
  std::int64_t late = 0;  ///< instants that were left out
  double seconds = 0;
  double position = 0;
};

/// Sends the position of the master, at instants of its own clock.
class Speaker {
 public:
  Speaker(const MasterArguments& options, Link& link, std::string unit)
      : options_(options), link_(link), reading_(errors_of(options, unit)) {
    said_.unit = std::move(unit);
    said_.clock = options.epoch.value_or(epoch_now());
  }

  void say(std::int64_t instant, const Jet& x, bool valid) {
    said_.seq = instant / 1000;  // rises, also from one sender on a machine to the next
    said_.stamp_ns = instant;
    said_.valid = valid;
    said_.position = reading_(x[0]);
    said_.velocity = x[1];
    send_message(link_.transport(), {options_.name, 0, said_}, link_.key());
  }

 private:
  const MasterArguments& options_;
  Link& link_;
  EncoderReading reading_;
  wire::Master said_;
};

/// The last words: it is lost, a few times, for some may be.
void leave(Speaker& speaker, Pacer& pacer, std::int64_t period, const Jet& x) {
  const std::int64_t begin = pacer.now();
  for (std::int64_t k = 0; k < 5; ++k) {
    pacer.sleep_until(begin + k * period);
    speaker.say(begin + k * period, x, false);
  }
}

Said speak(const Play& play, const MasterArguments& options, Link& link) {
  const auto period = static_cast<std::int64_t>(std::llround(1e9 / options.rate));
  const auto table = std::make_shared<const Table>(play.file.table);
  TableMaster master(table, options.before);
  Speaker speaker(options, link, play.file.units.position);
  MonotonicPacer pacer;
  Progress progress("master " + options.name);
  const Interrupt interrupt;  // sends that the master is lost before the program ends
  const std::int64_t begin = pacer.now();
  Said said;
  Jet x{};
  for (std::int64_t k = 0;; ++k) {
    pacer.sleep_until(begin + k * period);
    const std::int64_t missed = std::max<std::int64_t>((pacer.now() - begin) / period - k, 0);
    said.late += missed;  // one sample, where the time is: never a burst
    k += missed;
    const double t = static_cast<double>(k * period) * 1e-9;
    if (interrupt.asked() || t > play.length) break;
    x = master.at(t);
    speaker.say(begin + k * period, x, true);
    said = {said.samples + 1, said.late, t, x[0]};
    const double share = std::isinf(play.length) ? 0 : t / play.length;
    progress.show(share, fmt::format("{:.1f} s, at {:.6g} {}", t, x[0], play.file.units.position));
  }
  leave(speaker, pacer, period, x);
  return said;
}

int report(const Said& said, const MasterArguments& options, const std::string& unit) {
  if (options.json) {
    const nlohmann::ordered_json document{{"name", options.name},      {"samples", said.samples},
                                          {"late", said.late},         {"seconds", said.seconds},
                                          {"position", said.position}, {"unit", unit}};
    fmt::print("{}\n", document.dump(1));
  } else {
    fmt::print("{}: {} samples in {:.3f} s, {} instants left out; at {:.9g} {}\n", options.name,
               said.samples, said.seconds, said.late, said.position, unit);
  }
  return fine;
}

/// Rejects a second sender: it would replace the first one, even the line itself if that is on this bus.
void require_alone(Link link, const MasterArguments& options) {
  link.transport().subscribe(wire::channel(options.name, wire::Lane::master), 16);
  const Nanos end = steady_now() + std::chrono::milliseconds(300);
  Rejects rejects;
  for (Nanos left = end - steady_now(); left > Nanos{}; left = end - steady_now()) {
    const auto message = next_message(link.transport(), left, rejects, link.key());
    const auto* const heard = message ? std::get_if<wire::Master>(&message->body) : nullptr;
    if (heard != nullptr && heard->valid)
      throw InputError(
          "--as", options.name,
          "another sender of this --url uses this name: stop it, or choose another name");
  }
}

int run_master(const MasterArguments& options) {
  require_name_on_bus("--as", options.name);
  const Play play = play_of(options);
  (void)errors_of(options,
                  play.file.units.position);  // reports errors before it uses the bus
  require_alone(Link(options.link), options);
  Link link(options.link);
  return report(speak(play, options, link), options, play.file.units.position);
}

}  // namespace

void add_master(CommandLine& line) {
  const auto options = std::make_shared<MasterArguments>();
  const Verb verb = line.verb(
      "master", "Send the positions of a simulated master, for tests without the machine",
      "jounce master line.toml --as line\n"
      "jounce master line.csv --as line --noise 20um --resolution 50um\n"
      "The machine that follows it has [master.line] of kind \"external\"; see jounce run.");
  verb.option("FILE", options->file, "Spec or table over time; - is standard input").required();
  verb.axis(options->axis);
  verb.option("--as", options->name, "Name of the master").required();
  verb.option("--rate", options->rate, "Samples per second").check(within(1.0, 10000.0)).shown();
  verb.option("--before", options->before, "Seconds at rest at the first point")
      .check(within(0.0, 1e6))
      .shown();
  verb.option("--after", options->after, "Seconds at rest at the last point, before it leaves")
      .check(within(0.0, 1e6))
      .shown();
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; a table that repeats has no end")
      .check(seconds());
  verb.option("--epoch", options->epoch,
              "Epoch of the sender; executors reject samples unless it is greater than all before. "
              "Default: seconds since 2020")
      .check(whole(0, std::numeric_limits<std::int32_t>::max()));
  verb.option("--noise", options->noise,
              "White noise of the encoder, rms: 20um, or a number in the unit of the table");
  verb.option("--resolution", options->resolution,
              "Size of an encoder count: 50um, or a number in the unit of the table");
  verb.option("--noise-seed", options->seed, "Seed of the noise").shown();
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_master(*options); });
}

}  // namespace jounce::cli

// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/progress_line.hpp"
#include "jounce/base/units.hpp"
#include "jounce/machine/detail/line_master.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
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

/// A quantity of the table's unit; empty: 0.
double magnitude_of(const char* option, const std::string& text, const std::string& unit) {
  if (text.empty()) return 0;
  const double value = under_option(option, [&] { return quantity(text, unit); });
  if (!(value >= 0 && value <= 1e9))
    throw InputError(option, text, "must be from 0 to 1e9 " + unit);
  return value;
}

LineMaster line_of(const MasterArguments& options) {
  auto motion = line_motion(load(options.file, options.axis));
  if (!motion)
    throw InputError("FILE", options.file, "must be over time: give a motion, not a cam");
  const std::string unit = motion->units.position;
  return {.name = options.name,
          .motion = std::move(*motion),
          .rate = options.rate,
          .before = options.before,
          .after = options.after,
          .seconds = options.seconds,
          .epoch = options.epoch,
          .errors = {.resolution = magnitude_of("--resolution", options.resolution, unit),
                     .noise = magnitude_of("--noise", options.noise, unit),
                     .seed = options.seed}};
}

/// Rejects a second sender: it would replace the first one, even the line itself if that is on this bus.
void require_alone(KeyedLink link, const std::string& name) {
  if (has_sender(link.transport(), name, link.key()))
    throw InputError(
        "--as", name,
        "another sender of this --url uses this name: stop it, or choose another name");
}

int run_master(const MasterArguments& options) {
  require_name_on_bus("--as", options.name);
  LineMaster line = line_of(options);
  require_alone(open_link(options.link), options.name);
  KeyedLink link = open_link(options.link);
  line.key = link.key();
  const std::string& unit = line.motion.units.position;
  WatchedWork work("master " + options.name);
  const auto result =
      send_line_master(link.transport(), line, [&](double time, double position, double share) {
        return work.goes_on(share, fmt::format("{:.1f} s, at {:.6g} {}", time, position, unit));
      });
  if (options.json)
    print_json(line_master_json(line, result));
  else
    fmt::print("{}", line_master_text(line, result));
  return fine;
}

}  // namespace

void add_master(CommandLine& line) {
  const auto options = std::make_shared<MasterArguments>();
  const Verb verb = line.verb(
      "master", "Send the positions of a simulated master, for tests without the machine",
      "jounce master line.toml --as line\n"
      "jounce master line.csv --as line --noise 20um --resolution 50um\n"
      "A machine that follows this master has [master.line] of kind \"external\"; see jounce run.");
  verb.option("FILE", options->file, "Spec or table over time; - is standard input").required();
  verb.axis(options->axis);
  verb.option("--as", options->name, "Name of the master").required();
  verb.option("--rate", options->rate, "Samples per second").check(within(1.0, 10000.0)).shown();
  verb.option("--before", options->before, "Seconds at rest at the first point, before the motion")
      .check(within(0.0, 1e6))
      .shown();
  verb.option(
          "--after", options->after,
          "Seconds at rest at the last point, before the samples report that the master is lost")
      .check(within(0.0, 1e6))
      .shown();
  verb.option("--seconds", options->seconds,
              "End after this number of seconds; without it, a table that repeats never ends")
      .check(seconds());
  verb.option(
          "--epoch", options->epoch,
          "Number of this run of the sender: executors reject samples with a lower number than "
          "one received before; without --key, they forget that number after 1 s without samples. "
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

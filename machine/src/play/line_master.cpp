// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/line_master.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/axis/master.hpp"
#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/executor/detail/cycle.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce {
namespace {

/// A sender that begins later has a greater number: seconds of the clock on the wall, since 2020.
std::int32_t epoch_now() {
  constexpr std::int64_t since = 1577836800;
  const auto now = static_cast<std::int64_t>(std::time(nullptr)) - since;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(now, 0, std::numeric_limits<std::int32_t>::max()));
}

/// Sends the position of the master, with instants of the sender's clock.
class Samples {
 public:
  Samples(Transport& link, const LineMaster& line)
      : link_(link), line_(line), reading_(line.errors) {
    sample_.unit = line.motion.units.position;
    sample_.clock = line.epoch.value_or(epoch_now());
  }

  void send(std::int64_t instant, const Jet& x, bool valid) {
    sample_.seq = instant / 1000;  // rises, also from one sender on a machine to the next
    sample_.stamp_ns = instant;
    sample_.valid = valid;
    sample_.position = reading_(x[0]);
    sample_.velocity = x[1];
    send_message(link_, {line_.name, 0, sample_}, line_.key);
  }

 private:
  Transport& link_;
  const LineMaster& line_;
  EncoderReading reading_;
  wire::Master sample_;
};

/// Reports several times that the master is lost: a message may be, too.
void leave(Samples& samples, Pacer& pacer, std::int64_t period, const Jet& x) {
  const std::int64_t begin = pacer.now();
  for (std::int64_t k = 0; k < 5; ++k) {
    pacer.sleep_until(begin + k * period);
    samples.send(begin + k * period, x, false);
  }
}

/// s; infinite if the table repeats.
double duration_of(const LineMaster& line) {
  if (line.seconds) return *line.seconds;
  const Table& table = line.motion.table;
  if (repeats(table.outside())) return std::numeric_limits<double>::infinity();
  return line.before + line.after + table.end() - table.start();
}

}  // namespace

std::optional<TableFile> line_motion(const Input& input) {
  if (input.labels.over_master && !input.spec) return std::nullopt;  // no master to ask for
  ExecutorTables tables = executor_tables(input);
  if (tables.master || tables.slave.table.axis() != Domain::time) return std::nullopt;
  return std::move(tables.slave);
}

LineMasterResult send_line_master(Transport& link, const LineMaster& line,
                                  const LineProgress& keep_going) {
  const auto period = static_cast<std::int64_t>(std::llround(1e9 / line.rate));
  const double length = duration_of(line);
  TableMaster master(std::make_shared<const Table>(line.motion.table), line.before);
  Samples samples(link, line);
  MonotonicPacer pacer;
  const std::int64_t begin = pacer.now();
  LineMasterResult result;
  Jet x{};
  for (std::int64_t k = 0;; ++k) {
    pacer.sleep_until(begin + k * period);
    const std::int64_t missed = std::max<std::int64_t>((pacer.now() - begin) / period - k, 0);
    result.late += missed;  // one sample, where the time is: never a burst
    k += missed;
    const double t = static_cast<double>(k * period) * 1e-9;
    const double share = std::isinf(length) ? 0 : t / length;
    if (t > length) break;
    x = master.at(t);
    samples.send(begin + k * period, x, true);
    result = {result.samples + 1, result.late, t, x[0]};
    if (keep_going && !keep_going(t, x[0], share)) break;
  }
  leave(samples, pacer, period, x);
  return result;
}

std::string line_master_text(const LineMaster& line, const LineMasterResult& result) {
  const std::string late =
      result.late > 0
          ? fmt::format(", {} skipped because the program was late", counted(result.late, "sample"))
          : "";
  return fmt::format("{}: {} sent in {:.3f} s{}; the master is at {:.9g} {}\n", line.name,
                     counted(result.samples, "sample"), result.seconds, late, result.position,
                     line.motion.units.position);
}

std::string line_master_json(const LineMaster& line, const LineMasterResult& result) {
  const nlohmann::ordered_json document{
      {"name", line.name},           {"samples", result.samples},
      {"late", result.late},         {"seconds", result.seconds},
      {"position", result.position}, {"unit", line.motion.units.position}};
  return document.dump();
}

bool has_sender(Transport& link, const std::string& master, const std::optional<wire::Key>& key) {
  link.subscribe(wire::channel(master, wire::Lane::master), 16);
  const Nanos end = steady_now() + std::chrono::milliseconds(300);
  Rejects rejects;
  for (Nanos left = end - steady_now(); left > Nanos{}; left = end - steady_now()) {
    const auto message = next_message(link, left, rejects, key);
    const auto* const sample = message ? std::get_if<wire::Master>(&message->body) : nullptr;
    if (sample != nullptr && sample->valid) return true;
  }
  return false;
}

}  // namespace jounce

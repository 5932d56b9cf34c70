// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/await_home.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {
namespace {

using wire::OrderKind;

struct OrderArguments {
  std::string executor;
  std::string what;
  std::string value;
  std::map<std::string, std::string> named;  // by option, without --
  bool relative = false;
  bool buffered = false;
  bool hold_to_run = false;
  double seconds = 0;  // of a hold-to-run jog; 0: until Ctrl-C
  bool avoid_reversal = false;
  std::int64_t at = -1;
  LinkOptions link;
  bool json = false;
};

/// What the axis counts in, and so what the values of its orders are.
Units units_of(Transport& link, const OrderArguments& options,
               const std::optional<wire::Key>& key) {
  link.subscribe(wire::channel(options.executor, wire::Lane::status), 1);
  const auto message =
      next_status(link, options.executor, std::chrono::seconds(1), steady_now, key);
  if (!message) {
    throw TransportError("no message from " + options.executor + ": " + unheard_hint);
  }
  return std::get<wire::Status>(message->body).units;
}

double number_of(const std::string& name, const std::string& text, const std::string& unit) {
  try {
    return quantity(text, unit);
  } catch (const InputError& error) {
    throw InputError(name, text, error.rule());
  }
}

/// A quantity of position / s^order, of an option or of VALUE; NaN where an option is not given.
double quantity_of(const OrderArguments& options, const std::string& option, const Units& units,
                   int order = 0) {
  const bool is_value = option == "VALUE";
  const auto found = options.named.find(option);
  const std::string text = is_value ? options.value : found->second;
  if (text.empty() && !is_value) return std::numeric_limits<double>::quiet_NaN();
  const double value =
      number_of(is_value ? option : "--" + option, text,
                order == 0 ? units.position : rate_unit(units.position, "s", order));
  if (!is_value && order > 0 && !(value > 0))
    throw InputError("--" + option, text,
                     options.what == "home"
                         ? "must be greater than 0; leave it out to use [homing] of the axis's spec"
                         : "must be greater than 0; leave it out to use the limit of the axis");
  return value;
}

/// One that has to be given, of the axis or of its master.
double required(const OrderArguments& options, const std::string& option, const std::string& unit) {
  const std::string& text = options.named.at(option);
  if (text.empty()) throw InputError("--" + option, "missing", options.what + " needs it");
  return number_of("--" + option, text, unit);
}

/// --buffered, --blend: as a number on the wire.
double buffer_mode_of(const OrderArguments& options) {
  const std::map<std::string, double> blends{{"low", 2}, {"previous", 3}, {"next", 4}, {"high", 5}};
  const std::string& blend = options.named.at("blend");
  if (!blend.empty() && options.buffered)
    throw InputError("--blend", blend,
                     "cannot be combined with --buffered: a move that blends is buffered");
  return !blend.empty() ? blends.at(blend) : options.buffered ? 1 : 0;
}

void require_unbuffered(const OrderArguments& options, const std::string& what) {
  if (buffer_mode_of(options) != 0)
    throw InputError(options.buffered ? "--buffered" : "--blend", what,
                     "applies to move --to, move --by and jog only");
}

/// " VALUE relative " as VALUE, --relative.
std::string listed(const std::string& options) {
  std::istringstream words(options);
  std::string list;
  for (std::string word; words >> word;)
    list += (list.empty() ? "" : ", ") + (word == "VALUE" ? word : "--" + word);
  return list;
}

/// "50%" or "0.5".
double factor_of(const std::string& text) {
  const bool percent = !text.empty() && text.back() == '%';
  const auto factor = number_in(percent ? text.substr(0, text.size() - 1) : text);
  if (!factor || !(*factor >= 0 && *factor <= (percent ? 200 : 2)))
    throw InputError("VALUE", text, "must be 0% to 200%, or 0 to 2");
  return percent ? *factor / 100 : *factor;
}

/// "3:2" or "3".
std::pair<double, double> ratio_of(const std::string& text) {
  const auto colon = text.find(':');
  const auto numerator = number_in(text.substr(0, colon));
  const auto denominator = number_in(colon == std::string::npos ? "1" : text.substr(colon + 1));
  if (!numerator || !denominator)
    throw InputError("VALUE", text, "must be a ratio of whole numbers like 3:2");
  return {*numerator, *denominator};
}

double direction_of(const std::string& text) {
  return text == "positive" ? 1 : text == "negative" ? -1 : 0;
}

/// What is said beside WHAT and means nothing there would be believed to be obeyed.
void require_meant(const OrderArguments& options) {
  static const std::map<std::string, std::string> meant{
      {"move", " to by add on-top velocity acceleration deceleration jerk direction blend "},
      {"jog", " VALUE acceleration deceleration jerk blend hold-to-run "},
      {"inch", " VALUE velocity acceleration deceleration jerk "},
      {"gear-in-pos", " VALUE master-sync slave-sync start-distance avoid-reversal "},
      {"halt", " deceleration jerk "},
      {"gear-in", " VALUE acceleration deceleration jerk "},
      {"override", " VALUE "},
      {"home", " method offset search-velocity index-velocity acceleration timeout distance "},
      {"set-position", " VALUE relative "}};
  const auto found = meant.find(options.what);
  const auto require = [&](const std::string& option, const std::string& text, bool given) {
    const bool known =
        found != meant.end() && found->second.find(" " + option + " ") != std::string::npos;
    if (given && !known)
      throw InputError(option == "VALUE" ? option : "--" + option, text,
                       options.what + " takes " +
                           (found == meant.end() ? "nothing more" : listed(found->second)));
  };
  require("VALUE", options.value, !options.value.empty());
  require("relative", "", options.relative);
  require("avoid-reversal", "", options.avoid_reversal);
  require("hold-to-run", "", options.hold_to_run);
  for (const auto& [option, text] : options.named) require(option, text, !text.empty());
}

/// --to, --by, --add, --on-top: exactly one of them.
wire::Order move_of(const OrderArguments& options, const Units& units) {
  constexpr std::pair<const char*, OrderKind> ways[] = {{"to", OrderKind::move_absolute},
                                                        {"by", OrderKind::move_relative},
                                                        {"add", OrderKind::move_additive},
                                                        {"on-top", OrderKind::move_superimposed}};
  std::optional<wire::Order> order;
  for (const auto& [option, kind] : ways) {
    if (options.named.at(option).empty()) continue;
    if (order)
      throw InputError(std::string("--") + option, options.named.at(option),
                       "must be the only one of --to, --by, --add, --on-top");
    order = wire::Order{.kind = kind, .value = {quantity_of(options, option, units)}};
  }
  if (!order) throw InputError("move", "", "must have one of --to, --by, --add, --on-top");
  const double rates[] = {
      quantity_of(options, "velocity", units, 1), quantity_of(options, "acceleration", units, 2),
      quantity_of(options, "deceleration", units, 2), quantity_of(options, "jerk", units, 3)};
  std::copy(std::begin(rates), std::end(rates), order->value.begin() + 1);
  const double buffer = buffer_mode_of(options);
  if (order->kind == OrderKind::move_absolute) {
    order->value[5] = direction_of(options.named.at("direction"));
    order->value[6] = buffer;
  } else if (order->kind == OrderKind::move_relative) {
    order->value[5] = buffer;
  } else {
    require_unbuffered(options, order->kind == OrderKind::move_additive ? "--add" : "--on-top");
  }
  return *order;
}

/// The method, 0: as the axis is configured.
double method_of(const std::string& text) {
  if (text.empty()) return 0;
  const auto method = number_in(text);
  if (!method || *method != std::floor(*method) || *method < 1 || *method > 37)
    throw InputError("--method", text, "must be 1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402)");
  return *method;
}

double timeout_of(const std::string& text) {
  if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double timeout = number_of("--timeout", text, "s");
  if (!(timeout > 0)) throw InputError("--timeout", text, "must be greater than 0");
  return timeout;
}

wire::Order home_of(const OrderArguments& options, const Units& units) {
  if (options.at >= 0)
    throw InputError("--at", std::to_string(options.at),
                     "cannot be combined with home, which waits until the axis is homed");
  const double distance = quantity_of(options, "distance", units);
  if (distance <= 0)
    throw InputError("--distance", options.named.at("distance"), "must be greater than 0");
  return {.kind = OrderKind::home,
          .value = {quantity_of(options, "offset", units), method_of(options.named.at("method")),
                    quantity_of(options, "search-velocity", units, 1),
                    quantity_of(options, "index-velocity", units, 1),
                    quantity_of(options, "acceleration", units, 2),
                    timeout_of(options.named.at("timeout")), distance}};
}

wire::Order order_of(const OrderArguments& options, const Units& units) {
  const std::string& what = options.what;
  const double a = quantity_of(options, "acceleration", units, 2);
  const double d = quantity_of(options, "deceleration", units, 2);
  const double j = quantity_of(options, "jerk", units, 3);
  if (what == "move") return move_of(options, units);
  if (what != "jog") require_unbuffered(options, what);
  if (what == "override")
    return {.kind = OrderKind::override_, .value = {factor_of(options.value)}};
  if (what == "jog") {
    return {.kind = OrderKind::move_velocity,
            .value = {quantity_of(options, "VALUE", units, 1), a, d, j, buffer_mode_of(options),
                      options.hold_to_run ? 1.0 : 0.0}};
  }
  if (what == "inch")
    return {.kind = OrderKind::move_relative,
            .value = {quantity_of(options, "VALUE", units),
                      quantity_of(options, "velocity", units, 1), a, d, j}};
  if (what == "halt") return {.kind = OrderKind::halt, .value = {d, j}};
  if (what == "home") return home_of(options, units);
  if (what == "set-position") {
    return {.kind = OrderKind::set_position,
            .value = {quantity_of(options, "VALUE", units), options.relative ? 1.0 : 0.0}};
  }
  if (what == "gear-in") {
    const auto [numerator, denominator] = ratio_of(options.value);
    return {.kind = OrderKind::gear_in, .value = {numerator, denominator, a, d, j}};
  }
  if (what == "gear-in-pos") {
    const auto [numerator, denominator] = ratio_of(options.value);
    return {.kind = OrderKind::gear_in_pos,
            .value = {numerator, denominator, required(options, "master-sync", units.x),
                      required(options, "slave-sync", units.position),
                      required(options, "start-distance", units.x),
                      options.avoid_reversal ? 1.0 : 0.0}};
  }
  const std::map<std::string, OrderKind> plain{
      {"enable", OrderKind::enable}, {"disable", OrderKind::disable},
      {"reset", OrderKind::reset},   {"hold", OrderKind::hold},
      {"resume", OrderKind::resume}, {"gear-out", OrderKind::gear_out},
      {"start", OrderKind::start},   {"cam-out", OrderKind::cam_out}};
  return {.kind = plain.at(what)};
}

/// Keeps the session of a hold-to-run jog, so long as it is held.
CallOutcome hold(const OrderArguments& options, Client& client) {
  constexpr auto between = std::chrono::milliseconds(50);
  fmt::print("{}: jogs until Ctrl-C{}\n", options.executor,
             options.seconds > 0 ? fmt::format(", or for {} s", options.seconds) : "");
  std::fflush(stdout);
  const Interrupt interrupt;
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(options.seconds);
  CallOutcome outcome;
  while (outcome.ok() && !interrupt.asked() &&
         (options.seconds == 0 || std::chrono::steady_clock::now() < end)) {
    std::this_thread::sleep_for(between);
    outcome = client.beat();
  }
  return outcome;
}

/// An operator's own orders need no session: they are obeyed whoever owns the axis.
CallOutcome give(const OrderArguments& options, const wire::Order& order, Link& link) {
  if (!wire::is_operators(order.kind)) {
    Client client(link.transport(), options.executor, {.key = link.key()});
    CallOutcome outcome = client.order(order);
    if (options.hold_to_run && outcome.ok()) outcome = hold(options, client);
    if (order.kind == OrderKind::home && outcome.ok())
      outcome = await_home(options.executor, client, link);
    static_cast<void>(client.release());
    return outcome;
  }
  const wire::Reply reply = operator_command(link.transport(), options.executor, order, link.key());
  if (reply.outcome == wire::Outcome::accepted) return {};
  if (reply.outcome == wire::Outcome::pending)
    return {StreamError::command_timeout,
            {},
            0,
            options.executor + " did not accept or reject the command in time"};
  return {StreamError::refused, reply.refusal, reply.cause,
          std::string(name(reply.refusal)) + (reply.reason.empty() ? "" : ": ") + reply.reason};
}

int report(const OrderArguments& options, const CallOutcome& outcome) {
  if (options.json) {
    const nlohmann::ordered_json document{{"ok", outcome.ok()},
                                          {"error", name(outcome.error)},
                                          {"cause", outcome.cause},
                                          {"reason", outcome.reason}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{}: {}\n", options.executor,
               options.what == "home" ? "homed" : options.what + " accepted");
  } else {
    fmt::print(stderr, "jounce: {}: {}\n", options.executor, outcome.reason);
  }
  if (outcome.ok()) return fine;
  return outcome.error == StreamError::refused ? finding : fault;
}

int run_order(const OrderArguments& options) {
  require_name_on_bus("NAME", options.executor);
  require_meant(options);
  Link link(options.link);
  wire::Order order = order_of(options, units_of(link.transport(), options, link.key()));
  order.at = options.at;
  if (const std::string rule = contradiction(order); !rule.empty())
    throw InputError(options.what, options.value, rule);
  return report(options, give(options, order, link));
}

}  // namespace

void add_order(CommandLine& line) {
  const auto options = std::make_shared<OrderArguments>();
  const Verb verb = line.verb("order", "Send one command to an axis",
                              "jounce order feeder move --to 120mm --velocity 200mm/s\n"
                              "jounce order feeder move --by 80mm --blend next\n"
                              "jounce order feeder jog -20mm/s --hold-to-run\n"
                              "jounce order feeder inch 0.5mm --velocity 5mm/s\n"
                              "jounce order feeder override 50%\n"
                              "jounce order feeder home --method 24 --search-velocity 40mm/s\n"
                              "Numbers without a unit have the unit of the axis.");
  verb.option("NAME", options->executor, "Name of the executor").required();
  verb.option("WHAT", options->what,
              "enable, disable, reset; hold, resume, override; move, inch, jog, halt; home, "
              "set-position; gear-in, gear-in-pos, gear-out, cam-out; start (the axis's own table)")
      .required()
      .check(one_of({"enable", "disable", "reset", "hold", "resume", "override", "move", "inch",
                     "jog", "halt", "home", "set-position", "gear-in", "gear-in-pos", "gear-out",
                     "cam-out", "start"}));
  verb.option("VALUE", options->value,
              "Factor of override (50%), distance of inch, velocity of jog (0: to rest), position "
              "of set-position, ratio of gear-in and gear-in-pos (3:2)");
  const auto add = [&](const std::string& option, const char* help) {
    return verb.option("--" + option, options->named[option], help);
  };
  add("to", "Move to this position");
  add("by", "Move by this distance from the commanded position");
  add("add", "Move by this distance from the end position of the present motion");
  add("on-top", "Move by this distance on top of the present motion");
  add("velocity",
      "Greatest velocity of the move; default: the limit of the axis. The same holds for the next "
      "options");
  add("acceleration", "Acceleration");
  add("deceleration", "Deceleration");
  add("jerk", "Jerk");
  add("method",
      "home: method of CiA 402; default: [homing] of the spec of the axis. The same holds for the "
      "next options");
  add("offset", "home: the position value of the home position");
  add("search-velocity", "home: velocity of the search for a switch");
  add("index-velocity", "home: velocity of the search for the edge of the switch and the index");
  add("timeout", "home: fault after this time");
  add("distance", "home: fault if one search is longer than this");
  add("direction", "Direction of a rotary axis with --to: shortest, positive, negative")
      .check(one_of({"shortest", "positive", "negative"}));
  add("blend",
      "move --to, --by and jog: pass the target of the present move without a stop, at the "
      "velocity of: low (the lower one), previous (that move), next (this move), high (the higher "
      "one)")
      .check(one_of({"low", "previous", "next", "high"}));
  add("master-sync", "gear-in-pos: master position from which both run in step");
  add("slave-sync", "gear-in-pos: position of the axis there");
  add("start-distance", "gear-in-pos: master distance before it, in which the axis engages");
  verb.flag("--avoid-reversal", options->avoid_reversal,
            "gear-in-pos: reject a motion against the direction of the gear");
  verb.flag("--buffered", options->buffered,
            "move --to, --by and jog: begin when the present motion has ended");
  verb.flag("--hold-to-run", options->hold_to_run,
            "jog only while this command runs: the axis stops when it ends, or sends no heartbeat "
            "for 0.2 s");
  verb.option("--seconds", options->seconds, "End a --hold-to-run jog after this number of seconds")
      .check(seconds());
  verb.option("--at", options->at,
              "Tick of the executor at which the command takes effect; default: at once")
      .check(whole(0, std::numeric_limits<std::int64_t>::max()));
  verb.flag("--relative", options->relative, "set-position: the value is an offset");
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_order(*options); });
}

}  // namespace jounce::cli

// SPDX-License-Identifier: Apache-2.0
#include "edit/src/jobs/stream_job.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/hash.hpp"
#include "jounce/design/input.hpp"
#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/sender/banks.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/operate.hpp"
#include "jounce/web/gate.hpp"

#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {
namespace {

constexpr auto status_patience = std::chrono::seconds(1);
constexpr const char* cancelled_stream = "cancelled: nothing was started";

/// A link makes the folder of its address: a folder that is not there has no executor.
void require_folder(const std::string& url) {
  constexpr std::string_view scheme = "unix://";
  std::error_code none;
  if (url.starts_with(scheme) && !std::filesystem::exists(url.substr(scheme.size()), none))
    throw InputError("url", url,
                     "names a folder that does not exist, so no executor uses it: use the --url of "
                     "`jounce run`");
}

/// Throws InputError for options of another kind of motion.
void require_fit(const StreamRequest& request, const Input& input, bool path) {
  const PlayOptions& play = request.play;
  const bool live_options = request.start_at || play.at_next_cut || play.keep_velocity;
  if (live_options && !play.live)
    throw InputError("live", "false",
                     "must be true for start_at, at_next_cut and keep_velocity: they need a live "
                     "master");
  if ((path || is_follow(input)) && (play.live || request.start_at))
    throw InputError("live", "true",
                     path ? "is for a cam: a path has no master"
                          : "is for a cam: a follow spec defines its own master, start and end");
  if (request.relative && !is_follow(input))
    throw InputError("relative", "true", "is for a follow spec");
}

/// Duration of the motion: of its master, if it has one.
std::pair<double, std::string> duration_of(const Input& input, const StreamPlan* plan) {
  const auto length = [](const auto& f) { return f.end() - f.start(); };
  if (plan != nullptr && plan->mode != wire::ArmMode::play && plan->tables.size() > 1) {
    const StreamPlan::Item& master = plan->tables[1];
    return {master.table.columns().x.back() - master.table.columns().x.front(), master.units.x};
  }
  return {std::visit(length, *input.curve), input.labels.units.x};
}

std::string state_of(const wire::Status& status) {
  return fmt::format("{} at {}", name(status.state), number(status.slave_position));
}

std::string begin_of(const StreamRequest& request, const Input& input, const std::string& unit) {
  const auto passes = [&](double position) {
    return fmt::format("when the master passes {} {}", number(position), unit);
  };
  if (const auto position = pass_position(input)) return passes(*position);
  if (request.start_at) return passes(*request.start_at);
  return request.play.at_next_cut ? "at the end of the present pass" : "at once";
}

void take_plan(StreamOffer& offer, StreamPlan plan, const StreamRequest& request) {
  plan.goal = StreamGoal::start;
  plan.await = true;
  if (request.start_at) {
    plan.when = StartAt::master_position;
    plan.position = *request.start_at;
  }
  require_valid(plan);
  StreamPlan::Item& first = plan.tables.front();
  if (!first.hash) first.hash = content_hash(first.table, first.units);
  offer.hash = hex(*first.hash);
  offer.knots = first.table.columns().x.size();
  offer.plan = std::move(plan);
}

void take_plan(StreamOffer& offer, BankPlan plan) {
  offer.knots = plan.first.size() + plan.second.size();
  offer.plan = std::move(plan);
}

Job::Outcome sent(const StreamOffer& offer, const StreamPlan& plan, Job& job) {
  KeyedLink link(offer.link);
  StreamOptions options;
  options.key = link.key();
  options.cancelled = [&] { return job.is_stopped(); };
  options.progress = [&](const StreamProgress& p) {
    job.report(p.chunks == 0 ? 0 : static_cast<double>(p.arrived) / static_cast<double>(p.chunks),
               name(p.stage));
  };
  const StreamOutcome outcome = stream_tables(link.transport(), plan, options);
  const bool ok = outcome.ok() && outcome.started;
  if (!outcome.ok()) return {.text = error_text(outcome, offer.executor)};
  return {.ok = ok, .text = ok ? stream_text(outcome, offer.executor, false) : cancelled_stream};
}

Job::Outcome sent(const StreamOffer& offer, const BankPlan& plan, Job& job) {
  KeyedLink link(offer.link);
  Client client(link.transport(), offer.executor, {.key = link.key()});
  const CallOutcome outcome = play_banks(
      client, plan,
      {.until = BankOptions::Until::started,
       .progress = [&](const wire::QueueAck& level) { job.report(0, name(level.progress)); },
       .cancelled = [&] { return job.is_stopped(); }});
  static_cast<void>(client.release());
  if (!outcome.ok()) return {.text = error_text(outcome, offer.executor)};
  if (job.is_stopped()) return {.text = cancelled_stream};
  return {.ok = true, .text = offer.executor + ": started"};
}

}  // namespace

StreamOffer stream_offer(const std::string& path, const std::string& text,
                         const StreamRequest& request) {
  const std::string& executor = request.executor;
  if (!wire::is_executor_name(executor)) throw InputError("to", executor, wire::executor_name_rule);
  const std::vector<Input> axes = inputs_of(parse_spec(text, path), path);
  if (request.axis >= axes.size())
    throw InputError("axis", std::to_string(request.axis),
                     axes.size() == 1 ? "must be 0: the spec has one axis"
                                      : fmt::format("must be 0 to {}", axes.size() - 1));
  const Input& input = axes[request.axis];
  require_fit(request, input, is_path(axes));
  StreamOffer offer{text, web::new_token(), executor, request.link, {}};
  if (is_follow(input))
    take_plan(offer, follow_bank_plan(input, request.relative));
  else
    take_plan(
        offer,
        is_path(axes) ? path_plan(executor, axes) : stream_plan(executor, input, request.play),
        request);
  require_folder(offer.link.url);
  std::tie(offer.duration, offer.time_unit) =
      duration_of(input, std::get_if<StreamPlan>(&offer.plan));
  offer.begin = begin_of(request, input, input.labels.units.x);
  offer.start = std::visit([](const auto& f) { return f.jet(f.start())[0]; }, *input.curve);
  offer.position_unit = input.labels.units.position;
  KeyedLink bus(offer.link);
  if (const auto status = present_status(bus.transport(), executor, status_patience, bus.key()))
    offer.axis = state_of(*status);
  return offer;
}

void add_to(Json& object, const StreamOffer& offer) {
  const auto known = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  object.update({{"confirmation", offer.confirmation},
                 {"to", offer.executor},
                 {"url", offer.link.url},
                 {"table", known(offer.hash)},
                 {"knots", offer.knots},
                 {"begin", offer.begin},
                 {"duration", offer.duration},
                 {"time_unit", offer.time_unit},
                 {"start", offer.start},
                 {"position_unit", offer.position_unit},
                 {"axis", known(offer.axis)}});
}

std::unique_ptr<Job> stream_job(StreamOffer offer) {
  const std::string given = offer.text;
  return std::make_unique<Job>(given, [of = std::move(offer)](Job& job) {
    return std::visit([&](const auto& plan) { return sent(of, plan, job); }, of.plan);
  });
}

}  // namespace jounce::edit_detail

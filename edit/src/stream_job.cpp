// SPDX-License-Identifier: Apache-2.0
#include "edit/src/stream_job.hpp"

#include <algorithm>
#include <exception>
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
#include "jounce/machine/outcome_text.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/operate.hpp"
#include "jounce/web/gate.hpp"

#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {
namespace {

constexpr auto status_patience = std::chrono::seconds(1);

/// A link makes the folder of its address: a folder that is not there has no executor.
void require_folder(const std::string& url) {
  constexpr std::string_view scheme = "unix://";
  std::error_code none;
  if (url.starts_with(scheme) && !std::filesystem::exists(url.substr(scheme.size()), none))
    throw InputError("url", url,
                     "names a folder that does not exist, so no executor uses it: use the --url of "
                     "`jounce run`");
}

StreamPlan plan_of(const std::string& executor, const std::vector<Input>& axes,
                   const Input& input) {
  StreamPlan plan = is_path(axes) ? path_plan(executor, axes) : stream_plan(executor, input, {});
  plan.goal = StreamGoal::start;
  plan.await = true;
  return plan;
}

/// Duration of the motion: of its master, if it has one.
std::pair<double, std::string> duration_of(const Input& input, const StreamPlan& plan) {
  const auto length = [](const auto& f) { return f.end() - f.start(); };
  if (plan.mode != wire::ArmMode::play && plan.tables.size() > 1) {
    const StreamPlan::Item& master = plan.tables[1];
    return {master.table.columns().x.back() - master.table.columns().x.front(), master.units.x};
  }
  return {std::visit(length, *input.curve), input.labels.units.x};
}

std::string state_of(const wire::Status& status) {
  return fmt::format("{} at {}", name(status.state), number(status.slave_position));
}

}  // namespace

StreamOffer stream_offer(const std::string& path, const std::string& text, std::size_t axis,
                         const std::string& executor, LinkOptions link) {
  if (!wire::is_executor_name(executor)) throw InputError("to", executor, wire::executor_name_rule);
  const std::vector<Input> axes = inputs_of(parse_spec(text, path), path);
  if (axis >= axes.size())
    throw InputError("axis", std::to_string(axis), fmt::format("must be 0 to {}", axes.size() - 1));
  const Input& input = axes[axis];
  if (is_follow(input))
    throw InputError("kind", "follow", "needs a live master: use `jounce stream --live`");
  StreamPlan plan = plan_of(executor, axes, input);
  require_valid(plan);
  require_folder(link.url);
  StreamPlan::Item& first = plan.tables.front();
  if (!first.hash) first.hash = content_hash(first.table, first.units);
  StreamOffer offer{text, web::new_token(), std::move(link), {}, hex(*first.hash)};
  std::tie(offer.duration, offer.time_unit) = duration_of(input, plan);
  offer.start = std::visit([](const auto& f) { return f.jet(f.start())[0]; }, *input.curve);
  offer.position_unit = input.labels.units.position;
  KeyedLink bus(offer.link);
  if (const auto status = present_status(bus.transport(), executor, status_patience, bus.key()))
    offer.axis = state_of(*status);
  offer.plan = std::move(plan);
  return offer;
}

std::string members_of(const StreamOffer& offer) {
  return fmt::format(
      R"("confirmation":{},"to":{},"url":{},"table":{},"knots":{},"duration":{},"time_unit":{},)"
      R"("start":{},"position_unit":{},"axis":{})",
      json_text(offer.confirmation), json_text(offer.plan.executor), json_text(offer.link.url),
      json_text(offer.hash), offer.plan.tables.front().table.columns().x.size(), offer.duration,
      json_text(offer.time_unit), offer.start, json_text(offer.position_unit),
      offer.axis.empty() ? "null" : json_text(offer.axis));
}

StreamJob::StreamJob(StreamOffer offer) : offer_(std::move(offer)) {
  thread_ = std::thread([this] { work(); });
}

StreamJob::~StreamJob() {
  cancel();
  thread_.join();
}

StreamJob::State StreamJob::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

StreamJob::State StreamJob::sent() {
  KeyedLink link(offer_.link);
  StreamOptions options;
  options.key = link.key();
  options.cancelled = [this] { return cancelled_.load(); };
  options.progress = [this](const StreamProgress& p) {
    const std::scoped_lock lock(mutex_);
    state_.step = name(p.stage);
    state_.done =
        p.chunks == 0 ? 0 : static_cast<double>(p.arrived) / static_cast<double>(p.chunks);
  };
  const StreamOutcome outcome = stream_tables(link.transport(), offer_.plan, options);
  const std::string& to = offer_.plan.executor;
  State result{.running = false, .done = 1, .ok = outcome.ok() && outcome.started};
  if (!outcome.ok())
    result.text = error_text(outcome, to);
  else
    result.text = result.ok ? stream_text(outcome, to, false) : "cancelled: nothing was started";
  return result;
}

void StreamJob::work() {
  State result{.running = false, .done = 1};
  try {
    result = sent();
  } catch (const std::exception& error) {
    result.text = error.what();
  }
  const std::scoped_lock lock(mutex_);
  state_ = std::move(result);
}

}  // namespace jounce::edit_detail

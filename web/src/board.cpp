// SPDX-License-Identifier: Apache-2.0
#include "web/src/board.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "jounce/base/hash.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/detail/causes.hpp"

namespace jounce::web {
namespace {

using nlohmann::ordered_json;

ordered_json cause_of(std::int32_t number) {
  const auto cause = static_cast<Cause>(number);
  if (cause == Cause::none) return nullptr;
  return {{"number", number}, {"name", name(cause)}, {"meaning", meaning(cause)}};
}

/// The entry of the catalog; null for none.
const CauseInfo* info_of(Cause cause) {
  for (const CauseInfo& info : all_causes())
    if (info.cause == cause && cause != Cause::none) return &info;
  return nullptr;
}

/// The first bytes of the hash of a table; "": none.
std::string table_hex(const std::array<std::uint8_t, 8>& table) {
  Sha256 whole{};
  std::copy(table.begin(), table.end(), whole.begin());
  const bool none = std::all_of(table.begin(), table.end(), [](auto byte) { return byte == 0; });
  return none ? "" : hex(whole).substr(0, 2 * table.size());
}

ordered_json facts(const wire::Status& s) {
  return {{"state", name(s.state)},
          {"next", name(s.next)},
          {"tick", s.tick},
          {"cycle_ms", static_cast<double>(s.cycle_ns) * 1e-6},
          {"unit", s.units.position},
          {"master_unit", s.units.x},
          {"table", table_hex(s.table)},
          {"master", s.master_position},
          {"position", s.slave_position},
          {"velocity", s.slave_velocity},
          {"actual", s.actual_position},
          {"error", s.following_error},
          {"torque", s.torque},
          {"override", s.override_},
          {"progress", name(s.progress)},
          {"held", s.held},
          {"homed", s.homed},
          {"unwritten", s.unwritten},
          {"fault", cause_of(s.last_error)},
          {"reason", cause_of(s.reason)},
          {"queue", s.queue_rows},
          {"capacity", s.queue_capacity},
          {"outputs", s.outputs},
          {"late", s.late_ticks},
          {"lateness", s.lateness},
          {"computing", s.computing},
          {"finished", s.finished},
          {"stopped", s.stopped}};
}

ordered_json facts(const wire::MasterStatus& m) {
  return {{"name", m.master},       {"unit", m.unit},         {"lost", m.lost},
          {"position", m.position}, {"velocity", m.velocity}, {"age_ms", 1e3 * m.age_s}};
}

ordered_json facts(const wire::GroupStatus& g) {
  return {{"axes", g.axes},     {"place", g.place},           {"units", g.units},
          {"framed", g.framed}, {"position", g.position},     {"length", g.length},
          {"feed", g.feed},     {"remaining", g.remaining_s}, {"estimated", g.estimated},
          {"line", g.line},     {"commands", g.commands},     {"look_ahead", g.look_ahead}};
}

}  // namespace

Board::Board(std::vector<std::string> axes) {
  axes_.resize(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) axes_[i].name = std::move(axes[i]);
}

Board::AxisView* Board::find(const std::string& axis) {
  const auto at = std::find_if(axes_.begin(), axes_.end(),
                               [&](const AxisView& view) { return view.name == axis; });
  return at == axes_.end() ? nullptr : &*at;
}

void Board::take(const std::string& axis, const wire::Status& status, Nanos now) {
  AxisView* const at = find(axis);
  if (at == nullptr) return;
  const bool known = at->heard >= Nanos{} && at->status.boot == status.boot;
  if (known && status.tick <= at->status.tick) return;
  at->status = status;
  at->heard = now;
  at->samples.push_back(
      {++count_, static_cast<double>(status.tick) * static_cast<double>(status.cycle_ns) * 1e-9,
       status.slave_position, status.slave_velocity, status.following_error});
  if (at->samples.size() > most_samples) at->samples.pop_front();
}

void Board::take(const std::string& axis, const wire::MasterStatus& master) {
  for (AxisView& view : axes_) {
    if (view.name != axis || view.status.boot != master.boot) continue;
    std::erase_if(view.masters, [&](const auto& m) { return m.second.boot != master.boot; });
    view.masters[master.master] = master;
    if (view.masters.size() > most_masters)
      view.masters.erase(std::min_element(
          view.masters.begin(), view.masters.end(),
          [](const auto& a, const auto& b) { return a.second.tick < b.second.tick; }));
  }
}

void Board::take(const std::string& axis, const wire::GroupStatus& group) {
  AxisView* const at = find(axis);
  if (at != nullptr && at->heard >= Nanos{} && at->status.boot == group.boot) at->group = group;
}

void Board::note(const AxisView& view, double time, const char* kind, Cause cause) {
  log_.push_back({++count_, view.name, time, kind,
                  cause == Cause::none ? jounce::name(view.last->state) : jounce::name(cause),
                  cause});
  if (log_.size() > most_entries) log_.pop_front();
}

void Board::take(const std::string& axis, const std::vector<TraceTick>& ticks,
                 std::int64_t period) {
  AxisView* const view = find(axis);
  if (view == nullptr) return;
  for (const TraceTick& tick : ticks) {
    const bool begins = !view->last || tick.tick <= view->last->tick;
    const TraceTick before = begins ? tick : *view->last;
    view->last = tick;
    const double time = static_cast<double>(tick.tick) * static_cast<double>(period) * 1e-9;
    if (begins || tick.state != before.state) note(*view, time, "state", Cause::none);
    if (tick.refused != Cause::none) note(*view, time, "rejected", tick.refused);
    if (tick.dropped != Cause::none) note(*view, time, "dropped", tick.dropped);
    if (tick.fault != Cause::none && (begins || tick.fault != before.fault))
      note(*view, time, "fault", tick.fault);
    else if (tick.reason != Cause::none && tick.reason != before.reason)
      note(*view, time, "ended", tick.reason);
  }
}

std::optional<Units> Board::units(const std::string& axis) const {
  for (const AxisView& view : axes_)
    if (view.name == axis && view.heard >= Nanos{}) return view.status.units;
  return std::nullopt;
}

wire::GroupStatus Board::group(const std::string& name) const {
  for (const AxisView& view : axes_)
    if (view.name == name && view.group) return *view.group;
  return {};
}

std::string Board::json_since(std::int64_t& seen, Nanos now) const {
  ordered_json axes = ordered_json::array();
  for (const AxisView& view : axes_) {
    const bool heard = view.heard >= Nanos{};
    ordered_json axis = heard ? facts(view.status) : ordered_json::object();
    axis["name"] = view.name;
    axis["heard"] = nullptr;
    if (heard) axis["heard"] = std::chrono::duration<double>(now - view.heard).count();
    ordered_json& masters = axis["masters"] = ordered_json::array();
    for (const auto& [name, master] : view.masters) masters.push_back(facts(master));
    axis["group"] = nullptr;
    if (view.group) axis["group"] = facts(*view.group);
    ordered_json& samples = axis["samples"] = ordered_json::array();
    for (const Sample& s : view.samples)
      if (s.number > seen) samples.push_back({s.time, s.position, s.velocity, s.error});
    axes.push_back(std::move(axis));
  }
  ordered_json log = ordered_json::array();
  for (const Entry& entry : log_) {
    if (entry.number <= seen) continue;
    const CauseInfo* const cause = info_of(entry.cause);
    log.push_back({{"axis", entry.axis},
                   {"time", entry.time},
                   {"kind", entry.kind},
                   {"name", entry.name},
                   {"text", cause == nullptr ? "" : cause->meaning},
                   {"remedy", cause == nullptr ? "" : cause->remedy}});
  }
  seen = count_;
  // Texts from the wire are UTF-8; other content of a board must not throw either.
  return ordered_json{{"axes", std::move(axes)}, {"log", std::move(log)}}.dump(
      -1, ' ', false, ordered_json::error_handler_t::replace);
}

bool Board::has(const std::string& axis) const {
  return std::any_of(axes_.begin(), axes_.end(),
                     [&](const AxisView& view) { return view.name == axis; });
}

}  // namespace jounce::web

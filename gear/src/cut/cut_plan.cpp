// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/cut/shear_line.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance within which two positions of the web are equal, m.
double near(double position) {
  return rounded_input * std::abs(position);
}

void require_possible(const std::string& key, double length, const CutTask& task, double speed) {
  if (task.makes(length)) return;
  const double next = task.at_least(length);
  throw InputError(
      key, length,
      "is not possible at the line speed " + six_digits(speed) +
          " within the limits of the slave: " +
          (std::isfinite(next)
               ? "the next longer possible piece has " + six_digits_up(next)
               : "the longest possible piece has " + six_digits_down(task.possible.back().to)));
}

std::vector<CutRange> possible_for(const CutJob& job, const Cutter& cutter) {
  if (const auto* shear = std::get_if<FlyingShear>(&job.spec.machine))
    gear_detail::require_reserve(*shear, cutter, job.line);
  return possible_lengths(cutter, job.line);
}

}  // namespace

CutTask::CutTask(const CutJob& job)
    : cutter(job.spec.machine, job.line), list(job.spec.list), possible(possible_for(job, cutter)) {
  require_valid(list, cutter);
  for (std::size_t i = 0; i < list.lengths.size(); ++i)
    require_possible("lengths[" + std::to_string(i + 1) + "]", list.lengths[i], *this,
                     job.line.speed);
  if (list.waste) require_possible("waste", *list.waste, *this, job.line.speed);
}

bool CutTask::makes(double length) const {
  return std::any_of(possible.begin(), possible.end(), [&](const CutRange& range) {
    return length >= range.from * (1 - rounded_input) && length <= range.to * (1 + rounded_input);
  });
}

double CutTask::at_least(double length) const {
  if (makes(length)) return length;
  for (const CutRange& range : possible)
    if (range.from > length) return range.from;
  return infinity;
}

CutPlan::CutPlan(std::shared_ptr<const CutTask> task, double web) noexcept
    : task_(std::move(task)), web_(web) {
  planned_ = web + std::max(task_->list.first.value_or(0), task_->cutter.approach());
}

/// The length of the next piece.
double CutPlan::draw(Place& place) const noexcept {
  if (place.waste > 0) return std::exchange(place.waste, 0);
  if (place.length > 0) return place.length;
  const double length = task_->list[place.next];
  place.next = (place.next + 1) % task_->list.size();
  return length;
}

// ---- motion ------------------------------------------------------------------------------------

Jet CutPlan::on(const Span& span, std::int64_t cuts, double web) const noexcept {
  const Cutter& cutter = task_->cutter;
  Jet y{cutter.home() - cutter.turn(), 0, 0, 0};  // at home before the first cut
  double offset = static_cast<double>(cuts) * cutter.turn();
  switch (span.phase) {
    case Phase::home:
      break;
    case Phase::approach:
      y = cutter.approach(web - span.to);
      break;
    case Phase::cut:
    case Phase::retreat:
      offset -= cutter.turn();
      y = cutter.retreat(web - span.from);
      break;
    case Phase::link:
      offset -= cutter.turn();
      y = cutter.link(span.to - span.from, web - span.from);
      break;
  }
  y[0] += offset;
  return y;
}

Jet CutPlan::at(double web) noexcept {
  web_ = web;
  while (pass(web)) continue;
  const bool back = now_.phase != Phase::home && now_.phase != Phase::approach && web < now_.from;
  if (!back) return on(now_, cuts_, web);
  lost_ = lost_ || (before_.phase == Phase::link && web < before_.from);
  return on(before_, cuts_ - 1, web);
}

/// Passes one end of a phase before `web`; false: none.
bool CutPlan::pass(double web) noexcept {
  const Cutter& cutter = task_->cutter;
  switch (now_.phase) {
    case Phase::home:
      if (!(web >= planned_ - cutter.approach())) return false;
      now_ = {Phase::approach, now_.from, planned_};
      return true;
    case Phase::approach:
    case Phase::link:
      if (!(web >= now_.to)) return false;
      make_cut();
      return true;
    case Phase::cut: {
      if (!(web >= now_.from + cutter.commit())) return false;
      const bool links = std::isfinite(planned_) && cutter.links(planned_ - now_.from);
      now_.phase = links ? Phase::link : Phase::retreat;
      now_.to = links ? planned_ : none;
      return true;
    }
    case Phase::retreat:
      if (!(web >= now_.from + cutter.retreat())) return false;
      now_.phase = Phase::home;
      return true;
  }
  return false;
}

void CutPlan::make_cut() noexcept {
  before_ = now_;
  now_ = {Phase::cut, before_.to, none};
  ++cuts_;
  planned_ = none;
  if (!finished_) plan_next();
}

/// Plans the cut after now_.from: that of the list, or the one on demand if it comes first.
void CutPlan::plan_next() noexcept {
  place_before_ = place_;
  planned_ = now_.from + draw(place_);
  if (!(demand_ <= planned_ + near(planned_))) return;
  const bool other = demand_ < planned_ - near(planned_);
  planned_ = std::exchange(demand_, none);
  if (other) place_ = place_before_;
}

void CutPlan::finish() noexcept {
  finished_ = true;
  demand_ = planned_ = none;
}

bool CutPlan::in_sync() const noexcept {
  const Cutter& cutter = task_->cutter;
  const double after = web_ - now_.from;
  const double before = now_.to - web_;
  switch (now_.phase) {
    case Phase::home:
      return false;
    case Phase::approach:
      return before <= cutter.sync_before() && cutter.sync_before() > 0;
    case Phase::cut:
    case Phase::retreat:
      return after >= -cutter.sync_before() && after < cutter.sync_after();
    case Phase::link:
      return after < cutter.sync_after() ||
             (before <= cutter.sync_before() && cutter.sync_before() > 0);
  }
  return false;
}

// ---- requests ----------------------------------------------------------------------------------

double CutPlan::next_cut() const noexcept {
  return std::isnan(now_.to) ? planned_ : now_.to;
}

double CutPlan::next_possible() const noexcept {
  const Cutter& cutter = task_->cutter;
  switch (now_.phase) {
    case Phase::home:
      return web_ + cutter.approach();
    case Phase::retreat:
      return now_.from + cutter.retreat() + cutter.approach();
    case Phase::cut:
      return earliest_after(now_.from);
    case Phase::approach:
    case Phase::link:
      break;
  }
  return earliest_after(now_.to);
}

double CutPlan::earliest_after(double cut) const noexcept {
  return cut + task_->possible.front().from;
}

CutAnswer CutPlan::piece_answer(double length) const noexcept {
  if (task_->makes(length)) return {};
  const double next = task_->at_least(length);
  return {CutAnswer::Status::length, length,
          std::isfinite(next) ? next : task_->possible.back().to};
}

/// The answer to a cut on demand at `web`, if the list continues at `place` after the cut `cut`. If
/// it is accepted, `limit` is the last planned cut up to `web`.
CutAnswer CutPlan::demand_answer(double web, double cut, Place place) const noexcept {
  for (int i = 0;; ++i) {
    const double next = finished_ ? infinity : cut + draw(place);
    if (!(next <= web)) break;
    if (i == most_planned) return {CutAnswer::Status::far, web, cut};
    cut = next;
  }
  if (std::abs(web - cut) <= near(web) || task_->makes(web - cut))
    return {CutAnswer::Status::ok, web, cut};
  return {CutAnswer::Status::position, web, cut + task_->at_least(web - cut)};
}

/// Changes the next pieces, if the cut on demand that waits remains possible.
CutAnswer CutPlan::change(double Place::*piece, double length) noexcept {
  const CutAnswer answer = piece_answer(length);
  if (!answer) return answer;
  Place changed = place_;
  changed.*piece = length;
  if (std::isfinite(demand_) && !demand_answer(demand_, next_cut(), changed))
    return {CutAnswer::Status::pending, length, demand_};
  place_.*piece = place_before_.*piece = length;
  return answer;
}

CutAnswer CutPlan::set_length(double length) noexcept {
  return change(&Place::length, length);
}

CutAnswer CutPlan::add_waste(double length) noexcept {
  return change(&Place::waste, length);
}

CutAnswer CutPlan::cut_now() noexcept {
  const double earliest = next_possible();
  const double planned = next_cut();
  if (planned > web_ && planned <= earliest) return {CutAnswer::Status::ok, planned, planned};
  return cut_at(earliest);
}

CutAnswer CutPlan::cut_at(double web) noexcept {
  const double earliest = next_possible();
  if (!(web >= earliest)) return {CutAnswer::Status::position, web, earliest};
  const bool fixed = now_.phase == Phase::approach || now_.phase == Phase::link;
  // The cut before the demand, and the place in the list after it.
  double cut = fixed ? now_.to : now_.from;
  const bool home = now_.phase == Phase::home || now_.phase == Phase::retreat;
  if (!fixed && web < planned_ - near(planned_)) {
    if (!home) {
      const double next = cut + task_->at_least(web - cut);
      if (!task_->makes(web - cut)) return {CutAnswer::Status::position, web, next};
    }
    planned_ = web;
    demand_ = none;
    place_ = place_before_;
    return {CutAnswer::Status::ok, web, web};
  }
  if (!fixed) cut = planned_;
  const CutAnswer answer = demand_answer(web, cut, place_);
  if (!answer) return answer;
  demand_ = std::abs(web - answer.limit) <= near(web) ? none : web;
  return answer;
}

}  // namespace jounce

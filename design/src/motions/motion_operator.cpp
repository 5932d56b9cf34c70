// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/sequences/retime.hpp"
#include "jounce/profiles/vibration/moving_average.hpp"
#include "jounce/spec/detail/in_document.hpp"

#include "design/src/motions/motion.hpp"

namespace jounce::design_detail {
namespace {

using profiles_detail::rounded_input;

constexpr double compensation_tolerance = 1e-9;  ///< share of the greatest correction
/// Further data that an operator may need.
struct Context {
  std::vector<Limits> limits;
  double unit = 1;  ///< s, unit of time
  std::vector<std::string> names = {};
  std::vector<Jet> error = {};  ///< greatest error of each motion that was fitted
};

using Curves = std::vector<Trajectory>;

/// Throws InputError for a motion that begins or ends in motion: a filter assumes rest before and
/// after.
void require_rest_at_ends(const Trajectory& motion) {
  const double peak = std::abs(extrema(motion, 1).peak().value);
  for (const bool end : {false, true}) {
    const double v =
        motion.jet(end ? motion.end() : motion.start(), end ? Side::left : Side::right)[1];
    if (std::abs(v) > rounded_input * peak)
      throw InputError("operator", "",
                       "needs a motion from rest to rest; this one has the velocity " + number(v) +
                           " at its " + (end ? "end" : "start"));
  }
}

template <class Filter>
void each(Curves& motions, Filter filter) {
  for (Trajectory& motion : motions) {
    require_rest_at_ends(motion);
    motion = filter(motion);
  }
}

void apply(const MovingAverageSpec& s, const Context&, Curves& motions) {
  each(motions, [&](const Trajectory& f) { return moving_average(f, s.window); });
}

void apply(ShaperSpec s, const Context& context, Curves& motions) {
  const double given = s.mode.frequency;
  s.mode.frequency *= context.unit;
  const std::vector<Impulse> impulses = shaper(s);
  each(motions, [&](const Trajectory& f) {
    try {
      return shaped(f, impulses);
    } catch (const InputError& error) {
      if (!error.key().starts_with("impulse[")) throw;
      throw InputError("frequency", given,
                       "is too low: the shaper would take more than 10000 times the length of "
                       "the motion");
    }
  });
}

void apply(NotchSpec s, const Context& context, Curves& motions) {
  s.frequency *= context.unit;
  each(motions, [&](const Trajectory& f) { return notched(f, s).motion; });
}

void apply(const RetimeSpec&, const Context& context, Curves& motions) {
  const double k = least_stretch(motions, context.limits);
  for (Trajectory& motion : motions) motion = scaled(motion, 1, k);
}

void apply(const OverrideSpec& s, const Context& context, Curves& motions) {
  motions = overridden(motions, context.limits, s).axes;
}

/// The first instant after the start at which the motion passes this position. A motion that ends at
/// a velocity keeps it.
double passage(const Trajectory& running, double position) {
  for (const double t : crossings(running, 0, position))
    if (t > running.start()) return t;
  const Jet end = running.jet(running.end(), Side::left);
  if (end[1] * (position - end[0]) > 0) return running.end() + (position - end[0]) / end[1];
  const Range range = extrema(running, 0);
  throw InputError("past", position,
                   "must be a position that the motion passes after its start, from " +
                       six_digits(range.min.value) + " to " + six_digits(range.max.value));
}

Trajectory changed(const Trajectory& running, const ChangeSpec& c) {
  const double time = c.past ? passage(running, *c.past) : c.time;
  switch (c.to) {
    case ChangeSpec::To::target:
      return with_target(running, time, c.value, c.dynamics);
    case ChangeSpec::To::velocity:
      return moving_at_ends(with_velocity(running, time, c.value, c.dynamics));
    case ChangeSpec::To::additive:
      return pmc600::move_additive(running, time, c.value, c.dynamics);
    default:
      return pmc600::move_superimposed(running, time, c.value, c.dynamics, c.abort);
  }
}

void apply(const ChangeSpec& c, const Context&, Curves& motions) {
  if (motions.size() > 1) throw InputError("operator", "", "works with a single axis only");
  motions.front() = changed(motions.front(), c);
}

/// The index of the axis with this name; `otherwise` if the name is empty.
std::size_t axis_named(const std::string& name, const char* key, const Context& context,
                       std::optional<std::size_t> otherwise) {
  if (name.empty() && otherwise) return *otherwise;
  const auto at = std::find(context.names.begin(), context.names.end(), name);
  if (name.empty() || at == context.names.end())
    throw InputError(key, name, "must be the name of an axis of this spec");
  return static_cast<std::size_t>(at - context.names.begin());
}

/// The compensation. The axes of its table are the references of the document.
Compensation made_of(const CompensateSpec& s) {
  try {
    return Compensation(s.table);
  } catch (const InputError& error) {
    std::string key = error.key();
    if (key.starts_with("axes")) key.replace(0, 4, "reference");
    throw spec_detail::renamed(error, key);
  }
}

void apply(const CompensateSpec& s, Context& context, Curves& motions) {
  const Compensation table = made_of(s);
  const std::optional<std::size_t> only =
      motions.size() == 1 ? std::optional<std::size_t>(0) : std::nullopt;
  const std::size_t axis = axis_named(s.axis, "axis", context, only);
  std::vector<Trajectory> references;
  for (const std::string& name : s.references)
    references.push_back(motions[axis_named(name, "reference.axis", context, axis)]);
  const double tolerance =
      s.tolerance.value_or(compensation_tolerance * (table.peak() > 0 ? table.peak() : 1));
  Fitted<OverTime> corrected = compensated(motions[axis], table, references, tolerance);
  motions[axis] = std::move(corrected.curve);
  for (std::size_t k = 0; k < corrected.error.size(); ++k)
    context.error[axis][k] += corrected.error[k];
}

/// The key in the document for a field of a generator: "t" and "target" are `time` and `to` of the
/// operator; limits and axes have the keys of the document.
std::string key_in_document(std::string key, std::size_t k, std::size_t axes) {
  const std::string then = "then[" + std::to_string(k + 1) + "]";
  if (key == "t") key = "time";
  if (key == "target") key = "to";
  if (key == "axis") return then + ".axis";
  if (key.starts_with("axis[") && axes > 1) return key;
  if (key.starts_with("axis[1].")) key.erase(0, 8);
  if (key.starts_with("axis")) return then;
  if (key.starts_with("limits") && axes == 1) return key;
  if (key.starts_with("limits") || key == "axes") return axes == 1 ? "limits" : then;
  return key.empty() ? then : then + "." + key;
}

}  // namespace

std::vector<Jet> apply(std::span<const Operator> then, std::span<const AxisPart> parts, double unit,
                       std::vector<Trajectory>& motions) {
  Context context{{}, unit, {}, {}};
  for (const AxisPart& part : parts) {
    context.limits.push_back(part.limits);
    context.names.push_back(part.name);
    context.error.emplace_back();
  }
  for (std::size_t k = 0; k < then.size(); ++k) {
    try {
      std::visit([&](const auto& spec) { apply(spec, context, motions); }, then[k]);
    } catch (const InputError& error) {
      throw spec_detail::renamed(error, key_in_document(error.key(), k, motions.size()));
    }
  }
  return context.error;
}

}  // namespace jounce::design_detail

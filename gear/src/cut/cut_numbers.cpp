// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_numbers.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/error.hpp"

// All optional numbers of a cutter are greater than 0, except the shares of a law, so 0 stands for a
// number that is not given.

namespace jounce {
namespace {

/// The number of a law, of a choice or of blades. A record may contain any number.
int whole(double number, int most) {
  if (number >= 0 && number <= most && number == std::trunc(number))
    return static_cast<int>(number);
  throw InputError("cutter", number, "must be a whole number from 0 to " + std::to_string(most));
}

int choices(Law /*law*/) {
  return static_cast<int>(all_laws().size());
}
int choices(KnifeMatching /*matching*/) {
  return 2;
}

constexpr int most_blades = 1000;

template <class F>
void each_number(LawForm& form, F f) {
  f(form.inflection);
  f(form.straight);
  const auto each = [&](auto& list) {
    bool given = list.has_value();
    f(given);
    if (given && !list) list.emplace();
    if (list)
      for (double& number : *list) f(number);
  };
  each(form.shares);
  each(form.harmonics);
}

template <class F>
void each_number(Limits& limits, F f) {
  f(limits.velocity);
  f(limits.acceleration);
  f(limits.jerk);
}

template <class F>
void each_number(RotaryKnifeSpec& knife, F f) {
  f(knife.diameter);
  f(knife.blades);
  f(knife.cut_length);
  f(knife.sync_angle);
  f(knife.sync_length);
  f(knife.turn);
  f(knife.matching);
  f(knife.speed_ratio);
  f(knife.thickness);
  f(knife.law);
  each_number(knife.form, f);
  f(knife.dwell);
  f(knife.tolerance);
}

template <class F>
void each_number(FlyingShear& shear, F f) {
  f(shear.cut_length);
  f(shear.line_speed);
  for (auto* number :
       {&shear.sync_time, &shear.sync_length, &shear.stroke, &shear.acceleration_length,
        &shear.deceleration_length, &shear.return_length})
    f(*number);
  each_number(shear.limits, f);
  f(shear.safety);
  f(shear.ramp);
  f(shear.return_law);
  each_number(shear.return_form, f);
  f(shear.ratio);
  f(shear.angle);
}

template <class F>
void each_number(CutJob& job, F f) {
  f(job.spec.list.first);
  f(job.spec.list.waste);
  f(job.line.speed);
  f(job.line.rates.acceleration);
  f(job.line.rates.jerk);
  each_number(job.line.slave, f);
  std::visit([&](auto& machine) { each_number(machine, f); }, job.spec.machine);
}

}  // namespace

std::vector<double> numbers_of(const CutJob& job) {
  std::vector<double> all{static_cast<double>(job.spec.machine.index())};
  CutJob copy = job;
  each_number(copy, [&](const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, std::optional<double>>)
      all.push_back(member.value_or(0));
    else
      all.push_back(static_cast<double>(member));
  });
  all.insert(all.end(), job.spec.list.lengths.begin(), job.spec.list.lengths.end());
  return all;
}

CutJob cut_job_of(std::span<const double> numbers) {
  std::size_t at = 0;
  const auto next = [&] {
    if (at >= numbers.size())
      throw InputError("cutter", static_cast<double>(numbers.size()), "has too few numbers");
    return numbers[at++];
  };
  CutJob job;
  if (const double kind = next(); kind == 1)
    job.spec.machine = FlyingShear{};
  else if (kind != 0)
    throw InputError("cutter", kind, "is not a kind of cutter: 0 is a knife, 1 a shear");
  each_number(job, [&](auto& member) {
    using Member = std::decay_t<decltype(member)>;
    const double number = next();
    if constexpr (std::is_same_v<Member, std::optional<double>>)
      member = number > 0 ? std::optional(number) : std::nullopt;
    else if constexpr (std::is_enum_v<Member>)
      member = static_cast<Member>(whole(number, choices(member) - 1));
    else if constexpr (std::is_same_v<Member, bool>)
      member = number != 0;
    else if constexpr (std::is_same_v<Member, std::size_t>)
      member = static_cast<std::size_t>(whole(number, most_blades));
    else
      member = number;
  });
  job.spec.list.lengths.assign(numbers.begin() + static_cast<std::ptrdiff_t>(at), numbers.end());
  return job;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "proof/src/figure/follower_figure.hpp"

#include <utility>

#include "jounce/design/detail/reference.hpp"
#include "jounce/plot/label.hpp"

namespace jounce {

FollowerResult followed(const Input& input, std::size_t samples) {
  if (!input.spec || !input.spec->follower)
    throw InputError("", "",
                     "has no [follower], which this picture needs: add it, or leave out --follower")
        .at(input.files.empty() ? input.name : input.files.front());
  const FollowerSpec& f = *input.spec->follower;
  const Reference reference = table_reference(input);
  try {
    return follow(view(reference), f.follower,
                  {.settle = f.settle, .samples = samples, .limits = f.limits});
  } catch (const InputError& error) {  // the follower names its own numbers
    throw input.spec->document.located(
        InputError("follower." + error.key(), error.value(), error.rule()));
  }
}

Figure follower_figure(const FollowerResult& run, const FollowerSpec& spec,
                       const std::string& unit) {
  Series cam{.label = "cam"};
  Series mass{.label = "follower"};
  Series force{.label = "contact force"};
  for (const FollowerSample& s : run.samples) {
    for (Series* series : {&cam, &mass, &force}) series->x.push_back(s.time);
    cam.y.push_back(s.cam), mass.y.push_back(s.mass), force.y.push_back(s.force);
  }
  cam.style = Style::under;
  Panel lift{.y_label = "lift [" + unit + "]", .series = {std::move(cam), std::move(mass)}};
  Panel contact{.y_label = "contact force [N]",
                .series = {std::move(force)},
                .lower = spec.limits.least_force.value_or(0),
                .upper = spec.limits.greatest_force};
  for (const Peak& peak : {run.least_force, run.greatest_force}) {
    const std::string text = short_number(peak.value, 3);
    contact.markers.push_back({.x = peak.where, .y = peak.value, .text = text, .hint = text});
  }
  Figure figure{.title = "The follower on its cam", .x_label = "time [s]"};
  figure.panels = {std::move(lift), std::move(contact)};
  for (const Flight& flight : run.flights)
    figure.shades.push_back({flight.from, flight.to, "in the air"});
  return figure;
}

Figure follower_figure(const Input& input) {
  constexpr std::size_t samples = 2001;
  const FollowerResult run = followed(input, samples);
  Figure figure = follower_figure(run, *input.spec->follower, input.labels.units.position);
  figure.title = input.name + ": " + figure.title;
  return figure;
}

}  // namespace jounce

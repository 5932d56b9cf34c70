// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

// The trigger inputs and the registration of an axis.

namespace jounce::record_wire {

namespace {

/// f(name, ours, theirs) for every number.
template <class Ours, class Theirs, class F>
void each_of_registration(Ours& s, Theirs& w, F f) {
  f("input", s.input, w.input);
  f("rising", s.rising, w.rising);
  f("period", s.period, w.period);
  f("mark", s.mark, w.mark);
  f("window", s.window, w.window);
  f("search", s.search, w.search);
  f("window_from", s.correction.window_from, w.window_from);
  f("window_length", s.correction.window_length, w.window_length);
  f("most", s.correction.most, w.most);
  f("add_to", s.add_to, w.add_to);
  f("ratio", s.ratio, w.ratio);
  f("gain", s.gain, w.gain);
  f("misses", s.misses, w.misses);
  f("on_loss", s.on_loss, w.on_loss);
}

template <class Ours, class Theirs, class F>
void each_of_triggers(Ours& t, Theirs& w, F f) {
  f("wired", t.wired, w.wired);
  f("on", t.on, w.on);
  f("count", t.count, w.count);
  for (std::size_t k = 0; k < Triggers::most_changes; ++k) {
    f("input", t.change[k].input, w.input[k]);
    f("rising", t.change[k].rising, w.rising[k]);
    f("age", t.change[k].age, w.age[k]);
    f("position", t.change[k].position, w.position[k]);
  }
}

}  // namespace

registration_t on_wire(const RecordedRegistration& r) {
  registration_t w{};
  w.axis = static_cast<std::int16_t>(r.axis);
  w.law = static_cast<std::int16_t>(r.spec.correction.law);
  each_of_registration(r.spec, w, Put{});
  return w;
}

RecordedRegistration ours(const registration_t& w) {
  RecordedRegistration r{.axis = static_cast<std::size_t>(w.axis)};
  if (w.law < 0 || static_cast<std::size_t>(w.law) >= all_laws().size())
    throw InputError("law", std::to_string(w.law), "is not the number of a law");
  r.spec.correction.law = static_cast<Law>(w.law);
  each_of_registration(r.spec, w, Get{});
  return r;
}

triggers_t on_wire(const RecordedTriggers& t) {
  triggers_t w{};
  w.axis = static_cast<std::int16_t>(t.axis);
  each_of_triggers(t.triggers, w, Put{});
  return w;
}

RecordedTriggers ours(const triggers_t& w) {
  RecordedTriggers t{.axis = static_cast<std::size_t>(w.axis)};
  if (w.count < 0 || w.count > static_cast<int>(Triggers::most_changes))
    throw InputError("count", std::to_string(w.count), "must be from 0 to 4");
  each_of_triggers(t.triggers, w, Get{});
  return t;
}

}  // namespace jounce::record_wire

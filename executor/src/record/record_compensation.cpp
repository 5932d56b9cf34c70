// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

// The compensation of an axis: its table, and the setpoints of its references.

namespace jounce {

std::vector<RecordedCompensation> parts_of(std::size_t axis, const AxisCompensation& whole) {
  constexpr std::size_t most = record_wire::values_an_event;
  std::vector<RecordedCompensation> parts;
  const std::vector<double>& values = whole.table.values;
  for (std::size_t first = 0; first < values.size(); first += most) {
    RecordedCompensation part{.axis = axis, .spec = whole, .first = first};
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = static_cast<std::ptrdiff_t>(std::min(most, values.size() - first));
    part.spec.table.values.assign(begin, begin + count);
    parts.push_back(std::move(part));
  }
  return parts;
}

bool apply(const RecordedCompensation& part, std::optional<AxisCompensation>& whole) {
  std::vector<double> values;
  if (part.first > 0 && whole) values = std::move(whole->table.values);
  if (part.first != values.size())
    throw InputError("compensation", std::to_string(part.first),
                     "must be " + std::to_string(values.size()) + ", the next value of its table");
  values.insert(values.end(), part.spec.table.values.begin(), part.spec.table.values.end());
  whole = part.spec;
  whole->table.values = std::move(values);
  std::size_t points = 1;
  for (const GridAxis& axis : whole->table.axes) points *= axis.count;
  return whole->table.values.size() >= points;
}

namespace record_wire {

compensation_t on_wire(const RecordedCompensation& c) {
  compensation_t w{};
  const CompensationSpec& table = c.spec.table;
  w.axis = static_cast<std::int16_t>(c.axis);
  w.own = c.spec.own ? static_cast<std::int8_t>(*c.spec.own) : std::int8_t{-1};
  w.rule = static_cast<std::int8_t>(table.rule);
  w.references = static_cast<std::int8_t>(table.axes.size());
  for (std::size_t j = 0; j < table.axes.size(); ++j) {
    w.base[j] = table.axes[j].base;
    w.interval[j] = table.axes[j].interval;
    w.points[j] = static_cast<std::int64_t>(table.axes[j].count);
  }
  w.most = table.most;
  w.first = static_cast<std::int64_t>(c.first);
  w.count = static_cast<std::int32_t>(table.values.size());
  std::copy(table.values.begin(), table.values.end(), w.value);
  return w;
}

RecordedCompensation ours(const compensation_t& w) {
  constexpr std::int64_t most_points = 1'000'000;
  if (w.references < 1 || w.references > 3)
    throw InputError("references", std::to_string(w.references), "must be 1 to 3");
  if (w.own < -1 || w.own >= w.references)
    throw InputError("own", std::to_string(w.own), "must be -1, or the index of a reference");
  if (w.rule != 0 && w.rule != 1)
    throw InputError("rule", std::to_string(w.rule), "must be 0 or 1");
  if (w.count < 1 || w.count > static_cast<int>(values_an_event))
    throw InputError("count", std::to_string(w.count), "must be from 1 to 200 values");
  RecordedCompensation c{.axis = static_cast<std::size_t>(w.axis),
                         .first = static_cast<std::size_t>(w.first)};
  if (w.own >= 0) c.spec.own = static_cast<std::size_t>(w.own);
  c.spec.table.rule = static_cast<GridRule>(w.rule);
  c.spec.table.most = w.most;
  std::int64_t points = 1;
  for (int j = 0; j < w.references; ++j) {
    if (w.points[j] < 2 || w.points[j] > most_points || points > most_points / w.points[j])
      throw InputError("points", std::to_string(w.points[j]),
                       "must be at least 2, and at most 1e6 in the whole grid");
    points *= w.points[j];
    c.spec.table.axes.push_back({w.base[j], w.interval[j], static_cast<std::size_t>(w.points[j])});
  }
  if (w.first < 0 || w.first + w.count > points)
    throw InputError("first", std::to_string(w.first), "must be within the grid");
  c.spec.table.values.assign(w.value, w.value + w.count);
  return c;
}

references_t on_wire(const RecordedReferences& r) {
  references_t w{};
  w.axis = static_cast<std::int16_t>(r.axis);
  each_of_references(r, w, Put{});
  return w;
}

RecordedReferences ours(const references_t& w) {
  RecordedReferences r{.axis = static_cast<std::size_t>(w.axis)};
  each_of_references(r, w, Get{});
  return r;
}

}  // namespace record_wire
}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/lazy_curve.hpp"

#include <mutex>
#include <optional>
#include <utility>

namespace jounce {

struct LazyCurve::State {
  std::optional<Table> table;  ///< empty if the curve is given
  std::once_flag once;
  std::optional<Any> curve;
};

LazyCurve::LazyCurve(Any curve) : state_(std::make_shared<State>()) {
  state_->curve = std::move(curve);
}

LazyCurve::LazyCurve(Table table) : state_(std::make_shared<State>()) {
  require_curve(table);
  state_->table = std::move(table);
}

const LazyCurve::Any& LazyCurve::operator*() const {
  State& state = *state_;
  if (state.table)
    std::call_once(state.once, [&] {
      const Table& table = *state.table;
      if (table.axis() == Domain::time)
        state.curve = table.curve<OverTime>();
      else
        state.curve = table.curve<OverMaster>();
    });
  return *state.curve;
}

}  // namespace jounce

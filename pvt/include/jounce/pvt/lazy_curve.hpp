// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A given curve, or that of a table, made at its first use: a curve takes 200 bytes for each knot,
/// its table 40.
///
///     const LazyCurve curve(table);
///     std::get<Trajectory>(*curve).at(0.5);      // now there is a curve
///
/// Copies share the curve. Threads may ask for it at the same time.
class LazyCurve {
 public:
  using Any = std::variant<Cam, Trajectory>;

  template <class Over>
  LazyCurve(Curve<Over> curve)  // NOLINT(google-explicit-constructor): a curve is one
      : LazyCurve(Any(std::move(curve))) {}
  /// Throws InputError like table.curve(), so that the first use of the curve does not throw.
  explicit LazyCurve(Table table);

  [[nodiscard]] const Any& operator*() const;

 private:
  explicit LazyCurve(Any curve);

  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace jounce

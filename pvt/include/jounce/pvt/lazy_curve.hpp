// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A curve, or a table that makes its curve at the first use. A curve needs 200 bytes for each
/// knot, a table 40.
///
///     const LazyCurve curve(table);
///     std::get<Trajectory>(*curve).at(0.5);      // makes the curve
///
/// Copies share the curve. Several threads may use it at the same time.
class LazyCurve {
 public:
  using Any = std::variant<Cam, Trajectory>;

  template <class Over>
  LazyCurve(Curve<Over> curve)  // NOLINT(google-explicit-constructor): a curve is a LazyCurve
      : LazyCurve(Any(std::move(curve))) {}
  /// Throws InputError like table.curve(), so that the first use does not throw.
  explicit LazyCurve(Table table);

  /// The curve.
  [[nodiscard]] const Any& operator*() const;

 private:
  explicit LazyCurve(Any curve);

  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace jounce

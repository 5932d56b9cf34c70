// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/ramped_limits.hpp"
#include "jounce/pvt/sample.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::design_detail {

/// No table resolves both the longest and the shortest segment of a curve.
class Unresolved : public InputError {
 public:
  Unresolved(std::size_t segment, const std::string& rule)
      : InputError("", "", rule), segment_(segment) {}

  /// Index of the longest segment.
  [[nodiscard]] std::size_t segment() const { return segment_; }

 private:
  std::size_t segment_;
};

/// The limits of a table: those of its derivatives, and those of a slave whose master accelerates.
struct TableLimits {
  Limits limits = {};
  RampedLimits ramped = {};
};

/// The limits of the table of a spec over a master: [limits] and, behind [master], [limits.slave].
TableLimits table_limits(const Spec& spec);

/// Returns the table of a curve, and its error. Without a tolerance, the error is at most a
/// billionth of the stroke. Where the table would exceed a limit that the curve keeps, it gets more
/// knots, unless the options prevent this. Throws InputError with the keys of [table].
template <class Over>
Sampled table_of(const Curve<Over>& curve, const TableOptions& options, const TableLimits& limits);

}  // namespace jounce::design_detail

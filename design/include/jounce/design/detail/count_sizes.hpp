// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/controllers/table_target.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/design/input.hpp"

namespace jounce {

/// A table of counts in units, and the sizes of its counts.
struct CountedInput {
  Input input;
  std::string sizes = {};  ///< sentence on the sizes of the counts; "" if no size was given
};

/// Returns the input with its counts in units. A column has counts if its unit is pulse, count or
/// inc; a column without a unit, if the format of the file has counts there. `sizes.x_step` and
/// `sizes.p_step` give the size of a count, such as "0.01 deg". A column has the unit in `units`,
/// or the unit of its size. A size that has no unit, or a unit of counts, changes nothing, nor does
/// the size of a column in another unit. A spec stays unchanged.
///
/// Clears the texts that it uses, unless `format`, the format of the output, also has counts in
/// this column: then the counts of the output have the same size.
///
/// Throws InputError ("x_step", "p_step") for a size that is not a positive number, or that does
/// not have the quantity of `units`.
CountedInput in_units_of_counts(Input input, TargetTexts& sizes, const Units& units,
                                const ExchangeFormat* format);

/// Completes a conversion to this form: its interpolation as rule_for(), its format, and the target
/// of the texts as target_of(). `rule`: the interpolation of the user.
void complete(Conversion& wanted, const TableForm& form, std::optional<Interpolation> rule,
              const TargetTexts& target, const CountedInput& given, const MemberName& name_of);

}  // namespace jounce

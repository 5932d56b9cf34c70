// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/io/table_file.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce::python {

/// A table with its units, and its error if it was made from a curve.
struct NamedTable {
  TableFile file;
  std::optional<SampleError> error = {};
};

}  // namespace jounce::python

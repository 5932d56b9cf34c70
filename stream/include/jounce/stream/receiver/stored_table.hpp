// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A complete table, which is shared with the motions that play it.
struct StoredTable {
  Sha256 hash{};     ///< content_hash() of the table
  Units units = {};  ///< its units
  std::shared_ptr<const Table> table = {};
};

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/gear/cutter.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// The pieces that a cutter cuts from a web, one after the other; m is the unit of the web.
struct CutList {
  std::vector<double> lengths = {};  ///< m: lengths of the pieces; the list repeats
  /// m: web from the start of the plan, with the cutter at home, to the first cut. This piece is
  /// waste. nullopt: the earliest possible cut.
  std::optional<double> first = {};
  /// m: a piece of waste after every pass of the list; nullopt: none.
  std::optional<double> waste = {};

  /// Number of pieces of one pass.
  [[nodiscard]] std::size_t size() const { return lengths.size() + (waste ? 1 : 0); }
  /// Length of piece i of the pass, m; i < size().
  [[nodiscard]] double operator[](std::size_t i) const {
    return i < lengths.size() ? lengths[i] : *waste;
  }
};

/// A cutter with its list.
struct CutListSpec {
  CutMachine machine = {};
  CutList list = {};
  CutLine line = {};  ///< line of the Cutter of cut_list(), if it changes its speed
};

/// Throws InputError, for the key "lengths", "first" or "waste", if the cutter cannot make a piece
/// at any speed.
void require_valid(const CutList& list, const Cutter& cutter);

/// Returns the cam of one pass of the list over the web, with its sync zones.
///
///     const SyncCam pass = cut_list({knife, {.lengths = {100, 250, 100}}});
///
/// Without `first`, the cam repeats: it begins at a cut (knife) or at home (shear), like the cam of
/// a single piece. With `first`, it runs once: from home, over the first cut and one pass of the
/// list, back to home. Throws InputError like the constructor of Cutter and require_valid().
SyncCam cut_list(const CutListSpec& spec);

}  // namespace jounce

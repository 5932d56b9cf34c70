// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>

#include "jounce/executor/made_movement.hpp"
#include "jounce/executor/worker.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// Builds the movements of arms: small ones at once, a large one in the worker's thread, at most
/// one at a time. An arm that arrives meanwhile waits; a later one replaces it.
///
///     MovementBuilder builder(worker, most_knots);
///     if (builder.busy()) builder.wait(arm);
///     else if (auto built = builder.build(arm, id, period, position)) send(*built);
///     if (const auto done = builder.take()) ...                  // often
class MovementBuilder {
 public:
  struct Built {
    ArmRequested arm;
    MadeMovement made;
  };
  /// The end of a build in the worker's thread.
  struct Done {
    std::optional<Built> built;        ///< nullopt: it was canceled
    std::optional<ArmRequested> next;  ///< the arm that waited for it
  };

  /// `most_knots`: tables of more knots are built in the worker's thread. `worker` must outlive it.
  MovementBuilder(Worker& worker, std::size_t most_knots)
      : worker_(worker), most_knots_(most_knots) {}

  [[nodiscard]] bool busy() const { return building_.has_value(); }
  /// For the arguments see movement_of(). nullopt: it is built in the worker's thread. Only if it
  /// is not busy.
  [[nodiscard]] std::optional<Built> build(const ArmRequested& arm, std::uint64_t id,
                                           std::int64_t period, double position);
  void wait(const ArmRequested& arm) { next_ = arm; }
  /// nullopt: no build has ended.
  [[nodiscard]] std::optional<Done> take();
  /// Cancels the present build and the waiting arm.
  void cancel();

 private:
  struct Building {
    ArmRequested arm;
    std::future<MadeMovement> made;
    bool canceled = false;
  };

  Worker& worker_;
  std::size_t most_knots_;
  std::optional<Building> building_;
  std::optional<ArmRequested> next_;
};

}  // namespace jounce

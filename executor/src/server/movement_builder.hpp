// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <utility>

#include "jounce/executor/detail/worker.hpp"
#include "jounce/stream/detail/receiver.hpp"

#include "executor/src/server/made_movement.hpp"

namespace jounce {

/// Makes the movements for arm requests: a small movement at once, a large one in the thread of a
/// worker. It makes one movement at a time. A request that arrives in the meantime waits; a later
/// request replaces the waiting one.
///
///     MovementBuilder builder(worker, most_knots);
///     if (builder.busy()) builder.wait(arm);
///     else if (auto built = builder.build(arm, id, period, position)) send(*built);
///     if (const auto done = builder.take()) ...                  // often
class MovementBuilder {
 public:
  /// A movement that is ready, with its request.
  struct Built {
    ArmRequested arm;
    MadeMovement made;
  };
  /// The end of a build in the thread of the worker.
  struct Done {
    std::optional<Built> built;        ///< the movement; nullopt: the build was canceled
    std::optional<ArmRequested> next;  ///< the request that waited for the end of the build;
                                       ///< nullopt: none
  };

  /// `most_knots`: tables with more knots are built in the thread of the worker. `worker` must
  /// outlive the builder. `group`: for a group, its axes.
  MovementBuilder(Worker& worker, std::size_t most_knots, std::optional<ExecutorGroup> group = {})
      : worker_(worker), most_knots_(most_knots), group_(std::move(group)) {}
  ~MovementBuilder() { cancel(); }
  MovementBuilder(const MovementBuilder&) = delete;
  MovementBuilder& operator=(const MovementBuilder&) = delete;

  /// True if a build is in progress.
  [[nodiscard]] bool busy() const { return building_.has_value(); }
  /// Builds the movement of a request; see movement_of(). Returns nullopt if the worker builds the
  /// movement. `single_step`: a group plays the commands of a program one by one. Requires a builder that is not busy.
  [[nodiscard]] std::optional<Built> build(const ArmRequested& arm, std::uint64_t id,
                                           std::int64_t period, double position,
                                           bool single_step = false);
  /// Keeps a request until the present build ends.
  void wait(const ArmRequested& arm) { next_ = arm; }
  /// Returns the result of a build that has ended; nullopt: none.
  [[nodiscard]] std::optional<Done> take();
  /// Cancels the present build, and drops the waiting request. The worker ends the build of a path
  /// at its next step.
  void cancel();

 private:
  struct Building {
    ArmRequested arm;
    std::future<MadeMovement> made;
    std::shared_ptr<std::atomic<bool>> canceled;
  };

  Worker& worker_;
  std::size_t most_knots_;
  std::optional<ExecutorGroup> group_;
  std::optional<Building> building_;
  std::optional<ArmRequested> next_;
};

}  // namespace jounce

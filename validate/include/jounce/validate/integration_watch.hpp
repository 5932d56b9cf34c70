// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace jounce {

/// Observes the integrations of the calling thread: witness(), drive_through(), follow(),
/// identify(). While an object exists, each step of an integration calls `each_step`. An exception
/// of the function ends the integration, and reaches the caller. At most one object exists in a
/// thread at a time.
///
///     const IntegrationWatch watch([&] { if (interrupted) throw Stopped(); });
///     const Proof proof = prove(input);
class IntegrationWatch {
 public:
  explicit IntegrationWatch(std::function<void()> each_step);
  ~IntegrationWatch();
  IntegrationWatch(const IntegrationWatch&) = delete;
  IntegrationWatch& operator=(const IntegrationWatch&) = delete;

 private:
  std::function<void()> each_step_;
};

}  // namespace jounce

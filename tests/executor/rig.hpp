// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "jounce/executor/detail/cycle.hpp"

#include "executor/cycle/virtual_pacer.hpp"

namespace jounce::test {

/// One axis and its cyclic thread; the test is the only other side.
struct Rig {
  explicit Rig(const AxisConfig& config) : machine({{.name = "feeder", .config = config}}) {}

  Tick next() {
    cycle.once();
    Tick tick;
    EXPECT_TRUE(axis.ticks.pop(tick));
    return tick;
  }
  Tick order(const Command& command) {
    EXPECT_TRUE(axis.commands.push(command));
    return next();
  }

  Machine machine;
  VirtualPacer pacer;
  MachineExchange exchange{1};
  AxisExchange& axis = *exchange.axes.front();
  Cycle cycle{machine, pacer, exchange};
};

}  // namespace jounce::test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "stream/src/transport/lossy_transport.hpp"

/// The faults of docs/stream-faults.md.
namespace jounce::test {

inline std::string text(const LossSpec& spec) {
  std::ostringstream out;
  out << "{.seed = " << spec.seed << ", .lost = " << spec.lost << ", .doubled = " << spec.doubled
      << ", .corrupted = " << spec.corrupted << ", .delayed = " << spec.delayed
      << ", .delay = " << spec.delay.count() << "ns, .partitions = {";
  for (const auto& [from, to, way] : spec.partitions)
    out << "{" << from.count() << "ns, " << to.count() << "ns, " << static_cast<int>(way) << "} ";
  return out.str() + "}}";
}

struct Fault {
  const char* label;
  LossSpec spec;
  bool completes = true;  ///< for certain
};

inline const std::vector<Fault>& faults() {
  using namespace std::chrono_literals;
  using Way = Partition::Way;
  static const std::vector<Fault> all{
      {"good", {}},
      {"lost_1", {.lost = 0.01}},
      {"lost_10", {.lost = 0.1}},
      {"lost_30", {.lost = 0.3}},
      {"doubled", {.doubled = 0.3}},
      {"reordered", {.delayed = 0.3, .delay = 5ms}},
      {"delayed", {.delayed = 1, .delay = 60ms}},
      {"corrupted", {.corrupted = 0.1}},
      {"all", {.lost = 0.1, .doubled = 0.1, .corrupted = 0.05, .delayed = 0.1}},
      {"cut_at_first", {.partitions = {{0ms, 700ms}}}},
      {"cut", {.partitions = {{5ms, 405ms}}}},
      {"cut_out", {.partitions = {{3ms, 503ms, Way::out}}}},
      {"cut_in", {.partitions = {{3ms, 503ms, Way::in}}}},
      {"cut_often",
       {.lost = 0.1,
        .partitions = {{2ms, 102ms}, {110ms, 210ms, Way::in}, {215ms, 900ms, Way::out}}}},
      {"cut_for_long", {.partitions = {{4ms, 3s}}}, false},
      {"cut_for_good", {.partitions = {{4ms, 1h}}}, false},
      {"dead", {.lost = 1}, false},
  };
  return all;
}

}  // namespace jounce::test

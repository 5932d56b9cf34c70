// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>

#include <nlohmann/json.hpp>

namespace jounce::test {

/// The numbers of tests/oracle/oracles.json, made by tests/oracle/make_oracles.py without any of
/// our code.
inline const nlohmann::json& oracle(const char* name) {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/oracles.json"));
  return all.at(name);
}

}  // namespace jounce::test

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/report/detail/diagnostic.hpp"

/// Parts that several CI formats share.
namespace jounce::report_detail {

/// Returns the statements that a CI system shows, the worst level first. `quiet`: omits warnings.
inline std::vector<const Diagnostic*> shown(const RunResult& run, bool quiet) {
  std::vector<const Diagnostic*> all;
  for (const Level level : {Level::error, Level::broken, Level::warning}) {
    if (quiet && level == Level::warning) continue;
    for (const FileResult& file : run.files)
      for (const Diagnostic& each : file.diagnostics)
        if (each.level == level) all.push_back(&each);
  }
  return all;
}

/// Makes stable identifiers of statements. Statements of one file that are equal are numbered in
/// the order of the calls.
class Fingerprints {
 public:
  std::string of(const Diagnostic& each) {
    const std::string name = each.place.file + '\n' + each.axis + '\n' + each.rule + '\n' +
                             each.key + '\n' + each.segment + '\n' + each.quantity;
    const std::size_t number = seen_[name]++;
    return hex(sha256(name + '\n' + std::to_string(number))).substr(0, 32);
  }

 private:
  std::map<std::string, std::size_t> seen_;
};

/// Returns the message with its advice: "A -> B".
inline std::string with_advice(const Diagnostic& each) {
  return each.advice.empty() ? each.message : each.message + " -> " + each.advice;
}

}  // namespace jounce::report_detail

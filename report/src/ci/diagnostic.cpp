// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/detail/diagnostic.hpp"

#include <algorithm>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/input_errors.hpp"

namespace jounce {

const char* severity(Level level) noexcept {
  switch (level) {
    case Level::good:
      return "ok";
    case Level::note:
      return "note";
    case Level::warning:
      return "warning";
    case Level::broken:
    case Level::error:
      break;
  }
  return "error";
}

std::size_t FileResult::count(Level level) const {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.begin(), diagnostics.end(),
                    [&](const Diagnostic& each) { return each.level == level; }));
}

Level FileResult::worst() const {
  Level level = Level::good;
  for (const Diagnostic& each : diagnostics) level = std::max(level, each.level);
  return level;
}

std::size_t RunResult::count(Level level) const {
  std::size_t all = 0;
  for (const FileResult& file : files) all += file.count(level);
  return all;
}

int RunResult::status(bool strict) const {
  if (count(Level::error) > 0) return 2;
  return count(Level::broken) > 0 || (strict && count(Level::warning) > 0) ? 1 : 0;
}

std::vector<Diagnostic> diagnostics_of(const InputError& error, const std::string& file) {
  std::vector<Diagnostic> all;
  for (const InputError& one : all_errors(error)) {
    Diagnostic d;
    d.rule = one.key().empty() ? "input/file" : "input/key";
    d.level = Level::error;
    d.place = {one.document().empty() ? file : one.document(), one.line(), one.column()};
    d.key = one.key();
    d.message = printable(InputError(one.key(), one.value(), one.rule()).what());
    all.push_back(std::move(d));
  }
  return all;
}

void sort(std::vector<Diagnostic>& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.level > b.level; });
}

}  // namespace jounce

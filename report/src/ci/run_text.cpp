// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "jounce/report/detail/ci_formats.hpp"

namespace jounce {
namespace {

std::string text_of(const FilePlace& place) {
  std::string text = place.file;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text;
}

std::string counted(std::size_t n, const char* one, const char* several) {
  return fmt::format("{} {}", n, n == 1 ? one : several);
}

/// The summary of one valid file that has no motion; "" for all other runs.
std::string without_motion(const RunResult& run) {
  if (run.files.size() != 1 || !run.files.front().diagnostics.empty()) return "";
  const std::string& kind = run.files.front().kind;
  for (const char* each : {"axis", "drive", "machine", "sweep"})
    if (kind == each)
      return "1 file: 1 good: " +
             std::string(kind == "machine" ? "`jounce run` accepts it" : "its keys are valid") +
             "; a spec of kind " + kind + " has no motion to examine";
  return "";
}

}  // namespace

std::string to_text(const RunResult& run, bool quiet) {
  std::string text;
  for (const FileResult& file : run.files)
    for (const Diagnostic& d : file.diagnostics) {
      if (d.level < (quiet ? Level::broken : Level::warning)) continue;
      text += fmt::format("{}: {}: {}{} [{}]\n", text_of(d.place), severity(d.level),
                          d.axis.empty() ? "" : d.axis + ": ", d.message, d.rule);
      if (!d.advice.empty()) text += fmt::format("  -> {}\n", d.advice);
    }
  return text;
}

namespace {

/// The files of the folders that the run did not examine, with the way to examine them; "": none.
std::string skipped_text(const RunResult& run) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* several,
                       const std::string& option) {
    if (count > 0)
      text += "; " + counted(count, one, several) + " not checked: give " +
              (count == 1 ? "this file" : "each file") + " by its name" + option;
  };
  add(run.skipped, "controller file", "controller files",
      run.verb == "check" ? ", with --against SPEC" : "");
  add(run.programs, "G-code program", "G-code programs", ", with --machine SPEC");
  return text;
}

}  // namespace

std::string summary_line(const RunResult& run) {
  std::size_t good = 0;
  std::size_t broken = 0;
  std::size_t wrong = 0;
  for (const FileResult& file : run.files) {
    const Level worst = file.worst();
    (worst == Level::error ? wrong : worst == Level::broken ? broken : good) += 1;
  }
  const std::string skipped = skipped_text(run);
  if (const std::string only = without_motion(run); !only.empty()) return only + skipped;
  std::string text = counted(run.files.size(), "file", "files") + fmt::format(": {} good", good);
  if (broken > 0)
    text += fmt::format(", {} with {}", broken,
                        counted(run.count(Level::broken), "broken rule", "broken rules"));
  if (wrong > 0)
    text +=
        fmt::format(", {} wrong ({})", wrong, counted(run.count(Level::error), "error", "errors"));
  if (const std::size_t n = run.count(Level::warning); n > 0)
    text += "; " + counted(n, "warning", "warnings");
  return text + skipped;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include <fmt/format.h>

#include "jounce/report/detail/ci_formats.hpp"

#include "report/src/ci/shared.hpp"

namespace jounce {
namespace {

/// The text with the characters escaped that end a command, or a property of it.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    const bool special = c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','));
    out += special ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return out;
}

}  // namespace

std::string to_github(const RunResult& run, bool quiet) {
  std::string text;
  for (const Diagnostic* d : report_detail::shown(run, quiet)) {
    text += fmt::format("::{} file={}", severity(d->level), escaped(d->place.file, true));
    if (d->place.line > 0) text += fmt::format(",line={}", d->place.line);
    if (d->place.line > 0 && d->place.column > 0) text += fmt::format(",col={}", d->place.column);
    const std::string axis = d->axis.empty() ? "" : d->axis + ": ";
    text += fmt::format(",title={}::{}\n", escaped(d->rule, true),
                        escaped(axis + report_detail::with_advice(*d), false));
  }
  return text;
}

}  // namespace jounce

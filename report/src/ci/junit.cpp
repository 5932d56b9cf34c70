// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "jounce/report/detail/ci_formats.hpp"

#include "report/src/ci/shared.hpp"

namespace jounce {
namespace {

/// Text for XML 1.0, which has no control characters but tabs and line ends.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

/// A case fails if the exit status counts its statement.
bool fails(const Diagnostic& d, bool strict) {
  return d.level == Level::broken || (strict && d.level == Level::warning);
}

/// "segment 3 return: limit/geo_velocity", with a number if the file has another of that name.
std::string name_of(const Diagnostic& d, std::map<std::string, int>& seen) {
  std::string name = d.axis.empty() ? "" : d.axis + ": ";
  if (!d.segment.empty()) name += "segment " + d.segment + ": ";
  name += d.rule;
  if (d.rule.starts_with("input/") && !d.key.empty()) name += ' ' + d.key;
  const int number = ++seen[name];
  return number == 1 ? name : fmt::format("{} ({})", name, number);
}

std::string case_of(const Diagnostic& d, const std::string& name, bool strict) {
  const std::string head =
      fmt::format("  <testcase classname=\"{}\" name=\"{}\"", escaped(d.place.file), escaped(name));
  const char* element = d.level == Level::error ? "error" : fails(d, strict) ? "failure" : "";
  if (*element == '\0') return head + "/>\n";
  const std::string place =
      d.place.line > 0 ? fmt::format("{}:{}:{}", d.place.file, d.place.line, d.place.column)
                       : d.place.file;
  return fmt::format("{}>\n   <{} type=\"{}\" message=\"{}\">{}</{}>\n  </testcase>\n", head,
                     element, escaped(d.rule), escaped(d.message),
                     escaped(place + ": " + report_detail::with_advice(d)), element);
}

}  // namespace

std::string to_junit(const RunResult& run, bool strict) {
  std::string suites;
  std::size_t tests = 0;
  std::size_t failures = 0;
  for (const FileResult& file : run.files) {
    std::map<std::string, int> seen;
    std::string cases;
    std::size_t failed = 0;
    for (const Diagnostic& each : file.diagnostics) {
      cases += case_of(each, name_of(each, seen), strict);
      failed += fails(each, strict) ? 1 : 0;
    }
    // A suite without a case would be left out of the reports.
    if (cases.empty())
      cases = fmt::format("  <testcase classname=\"{}\" name=\"{}\"/>\n", escaped(file.file),
                          escaped(run.verb));
    const std::size_t count = std::max<std::size_t>(file.diagnostics.size(), 1);
    suites += fmt::format(
        " <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\">\n{} "
        "</testsuite>\n",
        escaped(file.file), count, failed, file.count(Level::error), cases);
    tests += count;
    failures += failed;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"jounce {}\" tests=\"{}\" "
      "failures=\"{}\" errors=\"{}\">\n{}</testsuites>\n",
      escaped(run.verb), tests, failures, run.count(Level::error), suites);
}

}  // namespace jounce

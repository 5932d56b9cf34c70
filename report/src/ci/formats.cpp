// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/detail/ci_formats.hpp"

namespace jounce {

const std::vector<std::string>& run_formats() {
  static const std::vector<std::string> all{"text", "json", "github", "gitlab", "sarif", "junit"};
  return all;
}

std::string to_format(const RunResult& run, const std::string& format, const RunLook& look) {
  if (format == "json") return to_json(run, look.strict);
  if (format == "github") return to_github(run, look.quiet);
  if (format == "gitlab") return to_gitlab(run, look.quiet);
  if (format == "sarif") return to_sarif(run, look.quiet);
  if (format == "junit") return to_junit(run, look.strict);
  return to_text(run, look.quiet);
}

}  // namespace jounce

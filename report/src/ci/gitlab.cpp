// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <nlohmann/json.hpp>

#include "jounce/report/detail/ci_formats.hpp"

#include "report/src/ci/shared.hpp"

namespace jounce {
namespace {

/// A word of GitLab: info, minor, major, critical or blocker.
const char* gitlab_severity(Level level) {
  if (level == Level::error) return "critical";
  return level == Level::broken ? "major" : "minor";
}

}  // namespace

std::string to_gitlab(const RunResult& run, bool quiet) {
  using Json = nlohmann::ordered_json;
  report_detail::Fingerprints fingerprints;
  Json list = Json::array();
  for (const Diagnostic* d : report_detail::shown(run, quiet))
    list.push_back(
        {{"description", report_detail::with_advice(*d)},
         {"check_name", d->rule},
         {"fingerprint", fingerprints.of(*d)},
         {"severity", gitlab_severity(d->level)},
         {"location",
          {{"path", d->place.file}, {"lines", {{"begin", std::max(d->place.line, 1)}}}}}});
  return list.dump(1) + "\n";
}

}  // namespace jounce

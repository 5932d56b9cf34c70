// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/build_info.hpp"

#include <nlohmann/json.hpp>

#include "jounce/base/detail/listed.hpp"

namespace jounce {
namespace {

std::string line(const std::string& name, const std::string& value) {
  if (value.empty()) return "";
  return name + ":" + std::string(11 - name.size(), ' ') + value + "\n";
}

std::string commit_text(const BuildInfo& build) {
  if (build.commit.empty()) return "";
  return build.commit + ", " + build.date + (build.changed ? ", with changes" : "");
}

std::string pairs_text(const std::vector<std::pair<std::string, std::string>>& all,
                       const std::string& join) {
  return listed(all, [&](const auto& pair) { return pair.first + join + pair.second; });
}

}  // namespace

std::string build_text(const BuildInfo& build) {
  return "jounce " + build.version + "\n" + line("commit", commit_text(build)) +
         line("compiler", build.compiler) + line("build", build.build_type) +
         line("libraries", pairs_text(build.libraries, " ")) +
         line("options", pairs_text(build.options, "="));
}

std::string build_json(const BuildInfo& build) {
  nlohmann::ordered_json json{{"version", build.version}};
  if (!build.commit.empty()) {
    json["commit"] = build.commit;
    json["commit_date"] = build.date;
    json["changed"] = build.changed;
  }
  json["compiler"] = build.compiler;
  json["build_type"] = build.build_type;
  for (const auto& [name, version] : build.libraries) json["libraries"][name] = version;
  for (const auto& [name, value] : build.options) json["options"][name] = value;
  return json.dump(2) + "\n";
}

}  // namespace jounce

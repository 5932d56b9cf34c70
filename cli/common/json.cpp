// SPDX-License-Identifier: Apache-2.0
#include "cli/common/json.hpp"

#include <fmt/format.h>

namespace jounce::cli {

void print_json(std::FILE* out, const Json& document) {
  fmt::print(out, "{}\n", document.dump(1));
}

nlohmann::ordered_json document_of(AxisDocuments axes) {
  if (axes.size() == 1) return std::move(axes.front().second);
  auto all = nlohmann::ordered_json::object();
  for (auto& [name, document] : axes) {
    if (document.contains("ok")) all["ok"] = all.value("ok", true) && document["ok"].get<bool>();
    all["axes"][name] = std::move(document);
  }
  return all;
}

}  // namespace jounce::cli

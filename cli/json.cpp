#include "json.hpp"

#include <fmt/format.h>

namespace jounce::cli {

void print_json(std::vector<std::pair<std::string, nlohmann::ordered_json>>& axes) {
  if (axes.size() == 1) {
    fmt::print("{}\n", axes.front().second.dump(1));
    return;
  }
  auto all = nlohmann::ordered_json::object();
  for (auto& [name, document] : axes) {
    if (document.contains("ok")) all["ok"] = all.value("ok", true) && document["ok"].get<bool>();
    all["axes"][name] = std::move(document);
  }
  fmt::print("{}\n", all.dump(1));
}

}  // namespace jounce::cli

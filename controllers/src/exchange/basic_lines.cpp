// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/basic_lines.hpp"

#include <algorithm>
#include <cctype>

#include "jounce/base/detail/csv.hpp"

namespace jounce::controllers_detail {
namespace {

std::string upper(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

}  // namespace

std::vector<Line> basic_lines(std::string_view text) {
  std::vector<Line> all;
  for (const Line& line : lines_of(text)) {
    std::string_view code = trimmed(line.text.substr(0, line.text.find('\'')));
    if (upper(code.substr(0, 3)) == "REM") continue;
    while (!code.empty()) {
      const auto end = code.find_first_of(";:");
      if (const auto command = trimmed(code.substr(0, end)); !command.empty())
        all.push_back({line.number, command});
      code.remove_prefix(end == code.npos ? code.size() : end + 1);
    }
  }
  return all;
}

std::optional<std::vector<double>> arguments_of(const Line& line, std::string_view name,
                                                const Place& place) {
  if (upper(line.text.substr(0, name.size())) != name) return std::nullopt;
  std::string_view rest = trimmed(line.text.substr(name.size()));
  if (rest.starts_with('(')) {
    if (!rest.ends_with(')'))
      place.fail(line.number, std::string(name), line.text,
                 "needs a closing parenthesis: is the file complete?");
    rest = rest.substr(1, rest.size() - 2);
  }
  std::vector<double> numbers;
  for (const std::string_view cell : csv_cells(rest))
    numbers.push_back(
        trimmed(cell).empty() ? 0 : place.number(line.number, std::string(name), trimmed(cell)));
  return numbers;
}

bool has_command(const std::string& text, std::string_view word) {
  const auto lines = basic_lines(text);
  return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
    return upper(line.text.substr(0, word.size())) == word;
  });
}

}  // namespace jounce::controllers_detail

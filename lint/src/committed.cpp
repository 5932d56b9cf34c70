// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/committed.hpp"

#include <charconv>
#include <filesystem>

#include "jounce/profiles/error.hpp"

#include "lint/src/git.hpp"

namespace jounce {

std::string committed_text(const std::string& path) {
  const std::filesystem::path full = std::filesystem::absolute(path);
  const std::string object = "HEAD:./" + full.filename().string();
  const auto ask = [&](const char* what) {
    auto answer = lint_detail::git({"-C", full.parent_path().string(), "cat-file", what, object});
    if (answer.status != 0)
      throw InputError("", "", "is not in the newest commit of a git repository").at(path);
    return answer.out;
  };
  const std::string size_text = ask("-s");
  std::size_t size = 0;
  std::from_chars(size_text.data(), size_text.data() + size_text.size(), size);
  std::string text = ask("blob");
  if (text.size() < size)
    text.append(size - text.size(), '\n');  // git() removes the last line ends
  return text;
}

}  // namespace jounce

// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/about/man_page.hpp"
#include "jounce/base/file.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {
void add_man(CommandLine& line) {
  const auto folder = std::make_shared<std::string>();
  const Verb verb = line.verb("man", "Write the manual pages of the program and of each verb",
                              "jounce man /usr/local/share/man/man1");
  verb.option("FOLDER", *folder, "Folder to write into").required();
  verb.hidden().work([&line, folder] {
    for (const auto& [name, page] : man_pages(line.info(), build_info()))
      write_file(*folder + "/" + name, page);
    return fine;
  });
}

}  // namespace jounce::cli

// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/about/man_page.hpp"
#include "jounce/base/file.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

void write_pages(const ProgramInfo& program, const std::string& folder) {
  const auto write = [&](const std::string& name, const std::string& page) {
    write_file(folder + "/" + name + ".1", page);
  };
  write(program.name, man_page(program, build_info()));
  for (const VerbInfo& verb : program.verbs)
    write(program.name + "-" + verb.name, man_page(program, verb, build_info()));
}

}  // namespace

void add_man(CommandLine& line) {
  const auto folder = std::make_shared<std::string>();
  const Verb verb = line.verb("man", "Write the manual pages of the program and of each verb",
                              "jounce man /usr/local/share/man/man1");
  verb.option("FOLDER", *folder, "Folder to write into").required();
  verb.hidden().work([&line, folder] {
    write_pages(line.info(), *folder);
    return fine;
  });
}

}  // namespace jounce::cli

#include <iostream>
#include <memory>
#include <vector>

#include "jounce/io/file.hpp"

#include "templates.hpp"
#include "verb.hpp"

namespace jounce::cli {

void add_new(CLI::App& app, Work& work) {
  struct Options {
    std::string kind;
    std::string output = "-";
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb =
      add_verb(app, "new", "Write a commented starting spec", "jounce new cam -o feeder.toml");
  std::vector<std::string> kinds;
  for (const auto& [kind, text] : templates()) kinds.push_back(kind);
  verb->add_option("KIND", options->kind,
                   "cam; move, queue, axes or pvt over time; or axis, an executor's")
      ->required()
      ->check(CLI::IsMember(kinds));
  verb->add_option("-o,--output", options->output, "File to write; - is standard output");
  verb->callback([options, &work] {
    work = [options] {
      write_file(options->output, templates().at(options->kind));
      return fine;
    };
  });
}

}  // namespace jounce::cli

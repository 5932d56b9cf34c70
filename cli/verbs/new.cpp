// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/security/key.hpp"

#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/templates.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {

namespace {

/// Writes a new key. A key is not printed, and never replaces a file.
int make_key(const std::string& output) {
  if (output == "-")
    throw InputError("--output", output,
                     "must be a file, because a key is a secret: give a file name");
  under_option("--output", [&] { write_new_key(output); });
  return fine;
}

}  // namespace

void add_new(CommandLine& line) {
  struct Options {
    std::string kind;
    std::string output = "-";
    bool force = false;
  };
  const auto options = std::make_shared<Options>();
  const Verb verb = line.verb("new", "Write an example spec with comments, as a start for your own",
                              "jounce new cam -o feeder.toml");
  std::vector<std::string> kinds;
  for (const auto& [kind, text] : templates()) kinds.push_back(kind);
  kinds.emplace_back("key");
  verb.option(
          "KIND", options->kind,
          "cam, gear, follow, knife, shear or indexer (over a master); move, queue, axes, "
          "path, pvt or pt (over time); axis (an executor); machine (several axes); drive (a servo "
          "drive); key (a secret that executor and streamer share)")
      .required()
      .check(one_of(kinds));
  verb.option("-o,--output", options->output, "File to write; - is standard output")
      .check(
          [options, key = output_file(), toml = output_file({".toml"})](const std::string& file) {
            return options->kind == "key" ? key(file) : toml(file);
          });
  verb.flag("--force", options->force, "Replace an existing file");
  verb.work([options]() -> int {
    if (options->kind == "key") return make_key(options->output);
    if (!options->force && options->output != "-" && std::filesystem::exists(options->output))
      throw InputError("--output", options->output, "exists already: replace it with --force");
    write_file(options->output, templates().at(options->kind));
    return fine;
  });
}

}  // namespace jounce::cli

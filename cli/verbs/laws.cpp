// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/nearest.hpp"
#include "jounce/cam/laws/law_names.hpp"
#include "jounce/design/law_guide.hpp"
#include "jounce/plot/curve_figure.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/json.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct LawsArguments {
  std::string law;
  std::string output;
  bool markdown = false;
  bool json = false;
};

Law law_of(const std::string& word) {
  const auto law = law_named(word);
  if (law) return *law;
  if (const LawAlias* alias = law_alias(word)) throw InputError("LAW", word, rule_of(*alias));
  std::vector<std::string> names;
  for (const LawInfo& one : all_laws()) names.emplace_back(one.name);
  const std::string near = nearest(word, names);
  throw InputError(
      "LAW", word,
      "is not a law: " + (near.empty() ? "`jounce laws` lists all" : "did you mean " + near + "?"));
}

void draw(const LawsArguments& options) {
  if (options.law.empty())
    throw InputError("--output", options.output, "needs a LAW: name the law to draw");
  const Law law = law_of(options.law);
  const auto rising = rising_laws();
  if (std::find(rising.begin(), rising.end(), law) == rising.end())
    throw InputError("LAW", options.law,
                     "has no shape to draw, because its points define it: choose another law");
  CurveLook look;
  look.title = info(law).title;
  look.label = info(law).name;
  write_picture(options.output, curve_figure(Cam(normalised(law, shown_form(law))), look));
}

int run_laws(const LawsArguments& options) {
  if (options.markdown) {
    fmt::print("{}", laws_markdown());
  } else if (!options.output.empty()) {
    draw(options);
  } else if (options.json) {
    Json all = Json::array();
    for (const LawInfo& law : all_laws())
      if (options.law.empty() || law_of(options.law) == law.law)
        all.push_back(Json::parse(law_json(law.law)));
    fmt::print("{}\n", all.dump(1));
  } else {
    fmt::print("{}", options.law.empty() ? law_table() : law_text(law_of(options.law)));
  }
  return fine;
}

}  // namespace

void add_laws(CommandLine& line) {
  const auto options = std::make_shared<LawsArguments>();
  const Verb verb = line.verb("laws", "List the motion laws of cams, or describe one",
                              "jounce laws modified_sine -o modified_sine.svg");
  verb.option("LAW", options->law, "Name of a law, as in a spec");
  verb.option("-o,--output", options->output, "Picture of the law to write, .svg or .png");
  verb.flag("--markdown", options->markdown, "The whole guide (docs/laws.md)");
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_laws(*options); });
}

}  // namespace jounce::cli

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "drive_text.hpp"
#include "follower_text.hpp"
#include "json.hpp"
#include "proof.hpp"
#include "robustness.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string file;
  std::string axis;
  std::string log;
  bool json = false;
};

nlohmann::ordered_json played_json(const Played& played) {
  using Json = nlohmann::ordered_json;
  const auto part = [](const Deviation& from) {
    return Json{{"error", from.error}, {"where", from.where}, {"limit", from.limit}};
  };
  Json json{{"ticks", played.ticks}, {"table", part(played.table)}};
  if (played.curve) json["curve"] = part(*played.curve);
  return json;
}

nlohmann::ordered_json json_of(const Proof& proof, const Input& input) {
  using Json = nlohmann::ordered_json;
  Json document = Json::parse(to_json(proof.report, input.labels));
  const auto witness_json = [](const Witness& w) {
    return Json{{"position", w.position.relative},
                {"velocity", w.velocity.relative},
                {"acceleration", w.acceleration.relative},
                {"steps", w.integration.steps}};
  };
  document["witness"] = {{"curve", witness_json(proof.curve)},
                         {"table", witness_json(proof.table)}};
  if (proof.drive) document["drive"] = drive_json(*proof.drive, *input.drive);
  if (proof.tolerances) document["tolerances"] = robustness_json(*proof.tolerances);
  if (proof.follower) document["follower"] = follower_json(*proof.follower);
  if (proof.played) document["executor"] = played_json(*proof.played);
  return document;
}

void print_text(const Proof& proof, const Input& input) {
  fmt::print("{}: {}\n{}", input.name, proof.report.ok() ? "proven" : "NOT proven",
             proof_text(proof, input));
  if (!proof.drive)
    fmt::print("  {:<12} not asked: a spec with a [drive] is also driven through a servo model\n",
               "drive");
  if (!proof.report.ok()) fmt::print("\n{}", full_text(proof.report, input.labels));
}

int run(const Options& options) {
  const std::vector<Input> inputs = load_axes(options.file, options.axis);
  if (inputs.size() > 1 && !options.log.empty())
    throw InputError("--log", options.log, "is of one axis: say which with --axis");
  bool ok = true;
  AxisDocuments documents;
  for (const Input& input : inputs) {
    const Proof proof = prove(input, options.log);
    ok = ok && proof.report.ok();
    if (options.json)
      documents.emplace_back(input.axis, json_of(proof, input));
    else
      print_text(proof, input);
  }
  if (options.json) fmt::print("{}\n", document_of(std::move(documents)).dump(1));
  return ok ? fine : finding;
}

}  // namespace

void add_validate(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  const Verb verb = line.verb(
      "validate", "Prove it by integration, against a servo model, and against what was played",
      "jounce validate cam.toml --log run.csv");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.axis(options->axis);
  verb.option(
      "--log", options->log,
      "Tick log of an executor: compare every tick with the table, to rounding, and with the exact "
      "curve, within the tolerance of the table");
  verb.flag("--json", options->json, "Everything for machines, numbers in full");
  verb.work([options] { return run(*options); });
}

}  // namespace jounce::cli

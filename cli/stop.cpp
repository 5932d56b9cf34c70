#include <memory>

#include <fmt/format.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/driver.hpp"

#include "link.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string executor;
  LinkOptions link;
  bool abort = false;
};

int run(const Options& options) {
  if (!wire::is_executor_name(options.executor))
    throw InputError("NAME", options.executor, "must be 1 to 23 of A-Z a-z 0-9 _ -");
  Link link(options.link);
  const auto mode = options.abort ? wire::StopMode::abort : wire::StopMode::stop;
  if (operator_stop(link.transport(), options.executor, mode)) {
    fmt::print("{} confirms the {}\n", options.executor, options.abort ? "abort" : "stop");
    return fine;
  }
  fmt::print(stderr, "jounce: {} does not confirm: is it running, on the same --url?\n",
             options.executor);
  return fault;
}

}  // namespace

void add_stop(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "stop", "Bring an executor's axis to rest, whoever owns it",
                            "jounce stop feeder");
  verb->add_option("NAME", options->executor, "Name of the executor")->required();
  verb->add_flag("--abort", options->abort,
                 "Freeze the set-point at once; the axis is then in ErrorStop");
  add_link_options(*verb, options->link);
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli

#include "link.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "jounce/stream/lcm_transport.hpp"
#include "jounce/stream/lossy_transport.hpp"

namespace jounce::cli {

std::string said_of(StreamError error, const std::string& reason) {
  std::string said = std::string(name(error)) + ": " + reason;
  if (error == StreamError::no_answer) said += std::string("; ") + unheard_hint;
  return said;
}

Nanos nanos(double seconds) {
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>(std::min(seconds, 1e9)));
}

CLI::Validator seconds_option() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= 1e-3 && value <= 1e12;
        return good ? std::string() : "`" + text + "` is not a number of seconds, 0.001 or more";
      },
      "", "seconds");
}

CLI::Validator within(double low, double high) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return good ? std::string() : fmt::format("`{}` is not from {} to {}", text, low, high);
      },
      fmt::format("from {} to {}", low, high), "within");
}

void add_link_options(CLI::App& verb, LinkOptions& options) {
  verb.add_option("--url", options.url,
                  "LCM URL; without a ttl it stays on this machine, with ?ttl=1 it reaches others")
      ->capture_default_str();
  verb.add_option("--key", options.key,
                  "File with the key that commands are signed with; see jounce new key");
  verb.add_option("--inject-loss", options.inject_loss, "Share of packets to lose, each way")
      ->group("");
  verb.add_option("--seed", options.seed, "Of --inject-loss")->group("");
}

Link::Link(const LinkOptions& options) : lcm_(std::make_unique<LcmTransport>(options.url)) {
  if (!options.key.empty()) key_ = read_key(options.key);
  if (options.inject_loss > 0)
    lossy_ = std::make_unique<LossyTransport>(
        *lcm_, LossSpec{.seed = options.seed, .lost = options.inject_loss}, steady_now);
}

}  // namespace jounce::cli

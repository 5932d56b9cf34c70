// SPDX-License-Identifier: Apache-2.0
#include "web/src/page.hpp"

#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"
#include "jounce/web/gate.hpp"

#include "fuzz/packets.hpp"
#include "web/src/board.hpp"
#include "web/src/page_command.hpp"

namespace jounce::fuzz {
namespace {

void post(const std::string& body) {
  try {
    const web::PageCommand read = web::read_command(body);
    require(!read.what.empty(), "a decoded command has a word");
  } catch (const InputError&) {
    // an answer
  }
}

}  // namespace

/// Input of a live page from outside: commands from a browser, packets from the bus.
void page(Input input) {
  post(text_of(input));
  static_cast<void>(web::objection({.host = text_of(input)}, 8080));
  require(web::page("a", text_of(input)).find("<script>") == std::string::npos,
          "a text is no markup");
  web::Board board({"feeder"});
  Source source(input);
  std::int64_t seen = 0;
  for (int i = 0; i < 50 && !source.empty(); ++i) {
    const auto decoded = wire::decode(packet(source));
    const auto* const message = std::get_if<wire::Message>(&decoded);
    if (message == nullptr) continue;
    if (const auto* status = std::get_if<wire::Status>(&message->body))
      board.take(message->executor, *status, Nanos(i));
    if (const auto* master = std::get_if<wire::MasterStatus>(&message->body))
      board.take(message->executor, *master);
    require(nlohmann::json::parse(board.json_since(seen, Nanos(i)), nullptr, false).is_object(),
            "an event is JSON");
  }
}

}  // namespace jounce::fuzz

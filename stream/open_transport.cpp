#include "jounce/stream/open_transport.hpp"

#include <string_view>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/lcm_transport.hpp"
#include "jounce/stream/unix_transport.hpp"

namespace jounce {

std::unique_ptr<Transport> open_transport(const std::string& url) {
  constexpr std::string_view folder = "unix://";
  if (url.starts_with(folder))
    return std::make_unique<UnixTransport>(url.substr(folder.size()));
  if (url.starts_with("udpm://") || url.starts_with("memq://"))
    return std::make_unique<LcmTransport>(url);
  throw InputError("url", url, "must begin with udpm://, unix:// or memq://");
}

}  // namespace jounce

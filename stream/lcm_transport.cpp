#include "jounce/stream/lcm_transport.hpp"

#include <cassert>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <utility>

#include <lcm/lcm-cpp.hpp>
#include <poll.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string explicit_url(const std::string& url) {
  if (url.rfind("memq://", 0) == 0) return url;
  if (url.rfind("udpm://", 0) != 0)
    throw InputError("lcm url", url, "must begin with udpm:// or memq://");
  if (url.find("ttl=") != std::string::npos) return url;
  return url + (url.find('?') == std::string::npos ? "?ttl=0" : "&ttl=0");
}

/// A channel's name as the regular expression that LCM takes it for, * standing for a part of it.
std::string escaped(const std::string& channel) {
  std::string regex;
  for (const char c : channel) {
    if (c == '*') {
      regex += "[^.]*";
      continue;
    }
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) regex += '\\';
    regex += c;
  }
  return regex;
}

}  // namespace

struct LcmTransport::Impl {
  explicit Impl(const std::string& url) : lcm(url) {
    // Asking for the descriptor has LCM set up its receiver now rather than at the first subscribe.
    if (lcm.good()) fd = lcm.getFileno();
    if (fd < 0) {
      throw TransportError("cannot use " + url +
                           ": is it a multicast group, and is there a route to it (for this "
                           "machine alone: ip route add 224.0.0.0/4 dev lo)? --url "
                           "unix://FOLDER needs no network");
    }
  }

  /// LCM must not be left by an exception: it is kept, and thrown once handle() has returned.
  static void on_message(const lcm::ReceiveBuffer* buffer, const std::string& channel, Impl* self) {
    try {
      const auto* const data = static_cast<const std::byte*>(buffer->data);
      self->waiting.push_back({channel, {data, data + buffer->data_size}});
    } catch (...) {
      self->failure = std::current_exception();
    }
  }

  /// Whether something has come.
  [[nodiscard]] bool wait(Nanos timeout) const {
    pollfd descriptor{fd, POLLIN, 0};
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(timeout);
    const timespec limit{static_cast<time_t>(seconds.count()),
                         static_cast<long>((timeout - seconds).count())};
    const int ready = ppoll(&descriptor, 1, &limit, nullptr);
    if (ready < 0 && errno != EINTR)
      throw TransportError(std::string("LCM's descriptor: ") + std::strerror(errno));
    if (ready > 0 && (descriptor.revents & POLLIN) == 0)
      throw TransportError("LCM has closed its descriptor");
    return ready > 0;
  }

  lcm::LCM lcm;
  int fd = -1;
  std::map<std::string, lcm::Subscription*> subscriptions;  // owned by lcm
  std::deque<Packet> waiting;
  std::exception_ptr failure;
};

LcmTransport::LcmTransport(const std::string& url)
    : impl_(std::make_unique<Impl>(explicit_url(url))) {}

LcmTransport::~LcmTransport() = default;

void LcmTransport::subscribe(const std::string& channel, int capacity) {
  assert(channel.size() <= 63 && capacity >= 1);
  lcm::Subscription*& subscription = impl_->subscriptions[channel];
  if (subscription == nullptr)
    subscription = impl_->lcm.subscribeFunction(escaped(channel), &Impl::on_message, impl_.get());
  if (subscription == nullptr) throw TransportError("cannot subscribe to " + channel);
  subscription->setQueueCapacity(capacity);
}

void LcmTransport::send(const std::string& channel, std::span<const std::byte> bytes) {
  assert(channel.size() <= 63);
  // Its result says nothing about delivery; what does not arrive is lost, and sent again.
  impl_->lcm.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
}

std::optional<Packet> LcmTransport::receive(Nanos timeout) {
  if (impl_->waiting.empty() && impl_->wait(timeout)) {
    if (impl_->lcm.handle() != 0) throw TransportError("LCM cannot receive");
    if (impl_->failure) std::rethrow_exception(std::exchange(impl_->failure, nullptr));
  }
  if (impl_->waiting.empty()) return std::nullopt;
  Packet packet = std::move(impl_->waiting.front());
  impl_->waiting.pop_front();
  return packet;
}

}  // namespace jounce

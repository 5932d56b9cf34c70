// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/receiver.hpp"

#include <utility>

#include "stream/src/receiver/receiver_impl.hpp"

namespace jounce {

Receiver::Receiver(ReceiverOptions options, std::int64_t boot)
    : impl_(std::make_unique<Impl>(std::move(options), boot)) {}

Receiver::~Receiver() = default;
Receiver::Receiver(Receiver&& other) noexcept = default;
Receiver& Receiver::operator=(Receiver&& other) noexcept = default;

void Receiver::receive(const wire::Message& message, Nanos now) {
  impl_->receive(message, now);
}

std::vector<wire::Message> Receiver::poll(Nanos now) {
  return impl_->poll(now);
}

std::vector<wire::Message> Receiver::answers() {
  return impl_->answers();
}

std::optional<StreamEvent> Receiver::take_event() {
  return impl_->take_event();
}

void Receiver::accept(std::int64_t session, std::int32_t command, std::string note) {
  impl_->accept(session, command, std::move(note));
}

void Receiver::refuse(std::int64_t session, std::int32_t command, std::string reason,
                      std::int32_t cause) {
  impl_->refuse(session, command, std::move(reason), cause);
}

void Receiver::level(std::uint32_t queue, const QueueLevel& level) {
  impl_->level(queue, level);
}

void Receiver::refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason) {
  impl_->refuse_queue(queue, refusal, std::move(reason));
}

void Receiver::refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason) {
  impl_->refuse_row(queue, row, std::move(reason));
}

void Receiver::stopped_with(std::int64_t session) {
  impl_->stopped_with(session);
}

std::int64_t Receiver::session() const {
  return impl_->session();
}

bool Receiver::armed() const {
  return impl_->armed();
}

const TableStore& Receiver::store() const {
  return impl_->store();
}

const std::string& Receiver::executor() const {
  return impl_->executor();
}

std::int64_t Receiver::boot() const {
  return impl_->boot();
}

std::int64_t Receiver::challenge() const {
  return impl_->challenge();
}

std::int64_t Receiver::operators_challenge() const {
  return impl_->operators_challenge();
}

wire::Message Receiver::status(const wire::Status& status) const {
  return impl_->status(status);
}

}  // namespace jounce

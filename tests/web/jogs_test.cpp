// SPDX-License-Identifier: Apache-2.0
#include "jounce/web/jogs.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/message/wire.hpp"

namespace jounce::web {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// An axis that accepts all commands, as seen by several links. A test holds its answers back, or breaks its links.
class Feeder {
 public:
  /// No answer goes out before open().
  void close() {
    change([this] { answers_ = false; });
  }
  void close_after_jog() {
    change([this] { closes_ = true; });
  }
  void open() {
    change([this] { answers_ = true; });
  }
  void fail(bool yes) {
    change([this, yes] { fails_ = yes; });
  }

  int jogs() {
    const std::scoped_lock lock(mutex_);
    return jogs_;
  }
  int heartbeats() {
    const std::scoped_lock lock(mutex_);
    return heartbeats_;
  }
  bool moves() {
    const std::scoped_lock lock(mutex_);
    return mover_ != 0;
  }

  /// False: not within 20 s.
  bool wait_for(const std::function<bool(const Feeder&)>& what) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 20s, [&] { return what(*this); });
  }
  bool wait_for_heartbeats(int count) {
    return wait_for([count](const Feeder& f) { return f.heartbeats_ >= count; });
  }
  bool wait_for_jogs(int count) {
    return wait_for([count](const Feeder& f) { return f.jogs_ >= count; });
  }
  bool wait_for_rest() {
    return wait_for([](const Feeder& f) { return f.mover_ == 0; });
  }
  bool wait_for_failures(int count) {
    return wait_for([count](const Feeder& f) { return f.failures_ >= count; });
  }

  /// Throws where the links are broken.
  std::int32_t take(const wire::Message& message) {
    const std::scoped_lock lock(mutex_);
    changed_.notify_all();
    if (fails_) {
      ++failures_;
      throw TransportError("the link is broken");
    }
    if (const auto* order = std::get_if<wire::Command>(&message.body)) {
      if (order->command != std::exchange(last_jog_, order->command) || mover_ != message.session)
        ++jogs_;
      mover_ = message.session;
      if (std::exchange(closes_, false)) answers_ = false;
      return order->command;
    }
    const auto& beat = std::get<wire::Heartbeat>(message.body);
    ++heartbeats_;
    if (beat.release && mover_ == message.session) mover_ = 0;
    return beat.command;
  }
  bool answers(Nanos timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [this] { return answers_; });
  }

 private:
  void change(const std::function<void()>& how) {
    const std::scoped_lock lock(mutex_);
    how();
    changed_.notify_all();
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  bool answers_ = true;
  bool closes_ = false;
  bool fails_ = false;
  int jogs_ = 0;
  int heartbeats_ = 0;
  int failures_ = 0;
  std::int32_t last_jog_ = 0;
  std::int64_t mover_ = 0;  // the session that moves it
};

class Link : public Transport {
 public:
  explicit Link(Feeder& feeder) : feeder_(feeder) {}
  void subscribe(const std::string& /*channel*/, int /*capacity*/) override {}
  void send(const std::string& /*channel*/, std::span<const std::byte> bytes) override {
    const auto message = std::get<wire::Message>(wire::decode(bytes, {}));
    const std::int32_t command = feeder_.take(message);
    answer_ = {"feeder", message.session,
               wire::Reply{.boot = 1, .command = command, .outcome = wire::Outcome::accepted}};
  }
  std::optional<Packet> receive(Nanos timeout) override {
    if (!answer_ || !feeder_.answers(timeout)) return std::nullopt;
    const wire::Message answer = *std::exchange(answer_, std::nullopt);
    return Packet{wire::channel("feeder", wire::Lane::reply), wire::encode(answer)};
  }

 private:
  Feeder& feeder_;
  std::optional<wire::Message> answer_;
};

struct Buttons {
  Feeder feeder;
  Jogs jogs{[this] { return std::make_unique<Link>(feeder); }, std::nullopt};
};

/// A button that is pressed: its request, which waits for the axis.
struct Press {
  Press(Buttons& buttons, std::int64_t number)
      : thread([this, &buttons, number] { outcome = buttons.jogs.jog("feeder", 20, number); }) {}
  CallOutcome answer() {
    thread.join();
    return outcome;
  }
  CallOutcome outcome;
  std::thread thread;
};

/// False: not in 2000 turns.
bool comes_true(const std::function<bool()>& what) {
  for (int turn = 0; turn < 2000; ++turn) {
    if (what()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

TEST(Jogs, AButtonMovesTheAxisUntilItIsReleased) {
  Buttons page;
  ASSERT_TRUE(page.jogs.jog("feeder", 20, 1).ok());
  EXPECT_TRUE(page.feeder.moves());
  EXPECT_TRUE(page.jogs.jog("feeder", 20, 1).ok()) << "the same again: it goes on";
  EXPECT_EQ(page.feeder.jogs(), 1);
  page.jogs.release("feeder", 1);
  EXPECT_TRUE(page.feeder.wait_for_rest());
  EXPECT_THAT(page.jogs.jog("feeder", 20, 1).reason, HasSubstr("has ended"));
  EXPECT_EQ(page.feeder.jogs(), 1);
}

TEST(Jogs, AButtonThatIsReleasedWhileItsSessionOpensMovesNothing) {
  Buttons page;
  page.feeder.close();
  Press press(page, 1);
  EXPECT_TRUE(page.feeder.wait_for_heartbeats(1));
  page.jogs.release("feeder", 1);
  page.feeder.open();
  EXPECT_THAT(press.answer().reason, HasSubstr("has ended"));
  EXPECT_EQ(page.feeder.jogs(), 0);
}

TEST(Jogs, AButtonThatIsReleasedBeforeItsFirstRequestMovesNothing) {
  Buttons page;
  page.jogs.release("feeder", 1);
  EXPECT_THAT(page.jogs.jog("feeder", 20, 1).reason, HasSubstr("has ended"));
  EXPECT_EQ(page.feeder.jogs(), 0);
}

TEST(Jogs, AButtonThatIsReleasedBeforeTheAxisAnswersStopsTheAxis) {
  Buttons page;
  page.feeder.close_after_jog();
  Press press(page, 1);
  EXPECT_TRUE(page.feeder.wait_for_jogs(1));
  page.jogs.release("feeder", 1);
  EXPECT_TRUE(page.feeder.moves());
  page.feeder.open();
  static_cast<void>(press.answer());
  EXPECT_TRUE(page.feeder.wait_for_rest());
}

TEST(Jogs, ANewerButtonTakesThePlaceOfOneWhoseSessionOpens) {
  Buttons page;
  page.feeder.close();
  Press older(page, 1);
  EXPECT_TRUE(page.feeder.wait_for_heartbeats(1));
  Press newer(page, 2);
  EXPECT_TRUE(page.feeder.wait_for_heartbeats(2));
  // The older one repeats its heartbeat meanwhile. Its number is refused as soon as the newer one has begun.
  EXPECT_TRUE(comes_true([&] { return !page.jogs.jog("feeder", 20, 1).ok(); }));
  page.feeder.open();
  EXPECT_THAT(older.answer().reason, HasSubstr("has ended"));
  EXPECT_TRUE(newer.answer().ok());
  EXPECT_EQ(page.feeder.jogs(), 1);
}

TEST(Jogs, OfTheEndedNumbersTheOldestIsForgottenAndNoOther) {
  Buttons page;
  constexpr std::int64_t kept = 1024;
  for (std::int64_t number = 1; number <= kept; ++number) page.jogs.release("feeder", number);
  page.jogs.release("feeder", kept);  // again: it takes no place
  EXPECT_THAT(page.jogs.jog("feeder", 20, 1).reason, HasSubstr("has ended"));
  page.jogs.release("feeder", kept + 1);
  EXPECT_THAT(page.jogs.jog("feeder", 20, 2).reason, HasSubstr("has ended"));
  EXPECT_THAT(page.jogs.jog("feeder", 20, kept + 1).reason, HasSubstr("has ended"));
  EXPECT_EQ(page.feeder.jogs(), 0);
  EXPECT_TRUE(page.jogs.jog("feeder", 20, 1).ok());
  EXPECT_EQ(page.feeder.jogs(), 1);
}

// An exception that leaves a thread ends the process. The axis gets no more heartbeats: the executor stops it.
TEST(Jogs, ABrokenLinkEndsTheJogAndNotThePage) {
  Buttons page;
  ASSERT_TRUE(page.jogs.jog("feeder", 20, 1).ok());
  page.feeder.fail(true);
  ASSERT_TRUE(page.feeder.wait_for_failures(1));
  ASSERT_TRUE(comes_true([&] { return !page.jogs.jog("feeder", 20, 1).ok(); }));
  page.feeder.fail(false);
  const int heard = page.feeder.heartbeats();
  EXPECT_THAT(page.jogs.jog("feeder", 20, 1).reason, HasSubstr("has ended"));
  std::this_thread::sleep_for(4 * Jogs::beat);
  EXPECT_EQ(page.feeder.heartbeats(), heard) << "a heartbeat of a jog that has ended";
  EXPECT_EQ(page.feeder.jogs(), 1);
  EXPECT_TRUE(page.jogs.jog("feeder", 20, 2).ok()) << "pressed again";
}

TEST(Jogs, ALinkThatBreaksWhileTheSessionOpensIsReportedAndMovesNothing) {
  Buttons page;
  page.feeder.fail(true);
  EXPECT_THROW(static_cast<void>(page.jogs.jog("feeder", 20, 1)), TransportError);
  page.feeder.fail(false);
  EXPECT_THAT(page.jogs.jog("feeder", 20, 1).reason, HasSubstr("has ended"));
  EXPECT_EQ(page.feeder.jogs(), 0);
}

}  // namespace
}  // namespace jounce::web

// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/challenges.hpp"

#include <set>

#include <gtest/gtest.h>

namespace jounce::challenges_test {
namespace {

TEST(Challenges, AreNeverDrawnTwice) {
  std::set<std::int64_t> all;
  for (const std::int64_t boot : {1, 2, 77}) {
    Challenges challenges(boot);
    all.insert({challenges.session(), challenges.operators()});
    for (int i = 0; i < 1000; ++i) {
      challenges.renew_session();
      challenges.renew_operators();
      all.insert({challenges.session(), challenges.operators()});
    }
  }
  EXPECT_EQ(all.size(), 3U * 2002U);
  EXPECT_GT(*all.begin(), 0) << "0 is the challenge of a sender that has received none";
}

TEST(Challenges, ARenewalLeavesTheOtherOne) {
  Challenges challenges(5);
  const std::int64_t session = challenges.session(), operators = challenges.operators();
  challenges.renew_operators();
  EXPECT_EQ(challenges.session(), session);
  EXPECT_NE(challenges.operators(), operators);
  challenges.renew_session();
  EXPECT_NE(challenges.session(), session);
}

TEST(Challenges, DependOnTheBootAlone) {
  EXPECT_EQ(Challenges(5).session(), Challenges(5).session());
  EXPECT_NE(Challenges(5).session(), Challenges(6).session());
}

}  // namespace
}  // namespace jounce::challenges_test

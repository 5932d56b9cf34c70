// SPDX-License-Identifier: Apache-2.0
// Limits that lie far apart from each other: random problems that the solver failed, each with the number
// that was wrong.
#include <gtest/gtest.h>

#include "profiles/proof/judge.hpp"

namespace jounce::proof {
namespace {

/// The checked move is as short as that of the witness, or rounding of the data decides.
void expect_right(const MotionState& from, const MotionState& to, const Bounds& bounds) {
  Tally tally;
  const Case c{from, to, bounds, {}};
  if (const Solved s = solve(c, tally))
    compare(
        s.verdict.duration, [&](Real share) { return minimum(reachable(c, s.verdict, share)); }, c,
        tally);
  for (const std::string& example : tally.examples) ADD_FAILURE() << example;
}

/// Every edge of durations() is one of the witness and can be asked for.
void expect_right_edges(const MotionState& from, const MotionState& to, const Bounds& bounds) {
  const Case c{from, to, bounds, {}};
  const Durations d = durations(from, to, bounds);
  const std::vector<Span> spans = reachable(from, to, bounds);
  ASSERT_EQ(d.count + 1, spans.size()) << reproducer(c);
  for (std::size_t i = 0; i < d.count; ++i) {
    EXPECT_NEAR(d.blocked[i].from, static_cast<double>(spans[i].to), 1e-14 * d.blocked[i].from);
    for (const double T : {d.blocked[i].from, d.blocked[i].to}) {
      const MoveResult move = move_to(from, to, bounds, T);
      ASSERT_TRUE(move) << explain(move.status) << ", " << T << ": " << reproducer(c);
      EXPECT_EQ(check(move.profile, {from, to, bounds, T}).fault, "");
    }
  }
}

TEST(FarApart, ARiseThatRoundingMadeNegativeKeepsTheDuration) {
  // Ended off by 4.4e-11 and 1e-12 of the scale: the fall made up for it and took longer.
  expect_right({-0x1.9fdeab6f75043p-9, 0x1.69b7f5b8bcccep+3, 0x1.388bf32875cbbp-9},
               {0x1.2e531d086d2b8p-10, 0x1.69b7f734c6a54p+3, 0x1.8531624f9e9aap-10},
               {-0x1.903b02adaa7dcp-6, 0x1.69b7f761fd28bp+3, -0x1.e543848197e0bp-5,
                0x1.eb72928f78343p-6, -0x1.72ab68eb1820fp+1, 0x1.d22629cb591eep-5});
  expect_right({0x1.db72bcf6134d8p-1, -0x1.1ce15cc379485p-1, 0x1.f3b4bf242a2adp-3},
               {0x1.2d3c6811ef17ep-2, 0x0p+0, 0x1.f3a680466a9cbp-3},
               {-0x1.934303fb51c2fp+2, 0x1.31c1f37e3693ap+1, -0x1.9653e3558b256p+3,
                0x1.6da87ea09a54ep+3, -0x1.8fc9455c43be7p-17, 0x1.56a9868bc4172p+3});
}

TEST(FarApart, AHoldIsKnownFromTheChangeOfVelocity) {
  // Lasted 4 % longer: the direct change was missed by a hold that was the difference of high velocities.
  expect_right({-0x1.3aa4af08e4e52p+2, -0x1.7094f0c3ec352p+1, 0x1.5872c9b2d2664p+3},
               {-0x1.9deea15e2f0bp+1, 0x1.0d6202300671dp+3, 0x1.1ae48bcc8b612p+4},
               {-0x1.e8cb680e47965p+3, 0x1.9064fa82bc54fp+3, -0x1.1dba153f56af5p+4,
                0x1.1ae48bcc8b612p+4, -0x1.0cec88d46601p-3, 0x1.e34e18db6a5bfp+3});
}

TEST(FarApart, AStartADigitBeyondItsLimitReturns) {
  // Ended off by 3.7e-12: the digit acted through the whole of a hold.
  expect_right({0x1.401fdc95a9bd7p+11, 0x1.795fa6b2b4c2p+3, -0x1.69a3644567bp-6},
               {-0x1.ec087de0e8ce7p-5, -0x1.f02436a50a9b5p-3, -0x1.9b31a1258cc7dp-8},
               {-0x1.f02436a50a9b5p-3, 0x1.70c710a27bdd8p+4, -0x1.69a3644567aadp-6,
                0x1.5ccf79623807bp+1, -0x1.1b548dd054b3fp+3, 0x1.d71e65e5f1572p+5});
}

TEST(FarApart, ABranchBeginsWhereItsFirstMemberIs) {
  // Ended off by 8.5e-11 and 2.4e-8: the branch began 5e-10 s and 3e-6 s after its first member.
  expect_right({-0x1.7073a8859c996p+0, 0x1.5d09f8dd92761p+0, 0x1.fa4c81cbbb453p-3},
               {0x1.ed0cfe66d7413p-1, 0x1.5d8b51e34aa8dp+0, 0x0p+0},
               {-0x1.4bac40edf3a2cp+3, 0x1.250f2ed284a94p+3, -0x1.842be56bc8dd3p+3,
                0x1.9f3628a77807ap-1, -0x1.e7364c94fe5b6p+3, 0x1.70489918588f6p-16});
  expect_right({-0x1.0e33ae334ab29p+3, 0x1.10de9c3cf6f54p-2, -0x1.56879bdec477p-10},
               {0x1.12f04ef5bb84ep+2, 0x1.dbcb79f8512d1p-3, 0x0p+0},
               {-0x1.b7a84ec2d03bbp+3, 0x1.fc7dab80c7bccp+2, -0x1.489a1ce9fa629p+3,
                0x1.db138eef425e6p+3, -0x1.c9acb84273651p+0, 0x1.a35b72b25decfp-16});
}

TEST(FarApart, TheFallOfADirectChangeIsKnownBetterThanItsAccelerations) {
  // Ended off in velocity by 2e-12: both accelerations agree in five digits.
  expect_right({0x1.5660f075493ffp+1, -0x1.cbb7238456a29p-7, 0x1.1e2eec9ee5ad6p-2},
               {0x1.5655668fc5bcp+1, 0x0p+0, 0x1.1e2e2aeff6051p-2},
               {-0x1.f12070c67b6b7p+3, 0x1.ff66aa3d2ed11p+3, -0x1.9145147122ccp-1,
                0x1.2c6552ce9043ap+3, -0x1.e2496406a932fp-15, 0x1.03f6dfd7e44d1p+3});
}

TEST(FarApart, ARiseAndAFallToACruiseAgree) {
  // Ended off by 2.5e-12: 5e-14 of the acceleration was left in 1602 s of cruise.
  expect_right({-0x1.247728caccacp+6, 0x1.74dfc2b97767ep-5, 0x1.454024f7a113ap-8},
               {-0x1.82936a2be7651p-4, 0x0p+0, 0x1.980008cb49b9p-7},
               {-0x1.43b78c761d64ep-5, 0x1.74efcc946024cp-5, -0x1.f72ffff1b0103p-7,
                0x1.980008cb49b9p-7, -0x1.0ddeb92bfc6dfp+6, 0x1.746586d82f1c7p-2});
}

TEST(FarApart, TheEdgesOfBlockedIntervals) {
  // Were off by 2e-13 to 5e-12 of their value, and move_to() refused them: the hold of the limit of one end
  // was the difference of two velocities.
  expect_right_edges({0x1.7fbf88ff282cfp-4, 0x1.3904fe3e1007ep+1, 0x1.44d32cc962437p-6},
                     {0x1.b81e3751ac613p-3, 0x1.39054305ef546p+1, 0x1.c9a79b91a2fb2p-6},
                     {-0x1.ddb46c285263ep-3, 0x1.390588d7d8b53p+1, -0x1.8abd27847cfe6p+5,
                      0x1.c9a79b91a2fb2p-6, -0x1.2be100feb0192p+2, 0x1.0cecbd5b08061p+5});
  expect_right_edges({0x1.b5df19c1838fp-5, 0x1.d29eeed492c1dp+1, 0x1.4e2ebe6b2803ep-7},
                     {0x1.a48be003243fbp-4, 0x1.d29eefc02a76dp+1, 0x1.4912a8e1187a2p-7},
                     {-0x1.f28bab22bd724p-5, 0x1.d29ef4e72767bp+1, -0x1.75f48426515e7p-7,
                      0x1.62aadd801e234p-5, -0x1.1ae2d0512b134p+4, 0x1.d47c2c61d79a3p+3});
  expect_right_edges({-0x1.79d7adf8f2353p+2, 0x1.5c234432ef533p+3, 0x1.0bdbbc3ddde6ep-7},
                     {-0x1.69518604b6f9ep+2, 0x1.5c23451021701p+3, 0x1.5202e3ad28666p-7},
                     {-0x1.73c2beb5c701cp-6, 0x1.5c2350bc12b5cp+3, -0x1.1991dab2c66fcp-6,
                      0x1.5202e3ad28666p-7, -0x1.5de3e715e9bd7p+2, 0x1.d9a0259625ae1p+5});
  expect_right_edges({-0x1.3ba0375950dffp-7, 0x1.0cf146f3a294dp-1, 0x1.0666e9fddcc4ep-7},
                     {0x1.46b39830fea3dp-5, 0x1.0cf16e66ebc6fp-1, 0x1.70e6ab4854166p-7},
                     {-0x1.fa895f73cf656p-4, 0x1.0cf1f3f5142dcp-1, -0x1.3b66479e35edcp+6,
                      0x1.70e6ab4854166p-7, -0x1.52790af03765bp+2, 0x1.bb0d4d0f58293p+4});
}

TEST(FarApart, AHoldFromTheFirstInstantOn) {
  // The edge was off by 2e-12 of its value: the start is at its limit of acceleration, and the last digits of
  // the peak velocity were no hold at the begin of a stretch and one behind it.
  expect_right_edges({0x1.3aba01b41f4e8p-5, -0x1.1a2bf4f0bcdd6p+6, 0x1.8c29c0712fae8p-6},
                     {-0x1.1cd3fa1f89ed5p+2, -0x1.1a2bf4f0bcdd6p+6, -0x1.e9a6c07c120f8p-7},
                     {-0x1.1a2bf4f0bcdd6p+6, 0x1.5a02785f8a891p+1, -0x1.e9a6c07c120f8p-7,
                      0x1.8c29c0712fae8p-6, -0x1.4d0544e4786bep+2, 0x1.978b43fb6bbc4p+3});
}

TEST(FarApart, ADipOfAFewMillionthsOfTheVelocity) {
  // Ended off by 2e-12 and 3e-12 of the scale: the cruise was looked for to 1e-9 of the velocity itself,
  // and beside the longest motion rounding of the peak velocity left less than no time to cruise.
  const auto expect_exact = [](const MotionState& from, const MotionState& to, const Bounds& b,
                               double T) {
    const MoveResult move = move_to(from, to, b, T);
    ASSERT_TRUE(move) << explain(move.status);
    EXPECT_EQ(check(move.profile, {from, to, b, T}).fault, "");
  };
  expect_exact({-0x1.f35a2db831724p-5, 0x1.559c16a0f1a45p+5, 0x0p+0},
               {-0x1.47f5c6ee17d6dp-13, 0x1.559c16a0f1a45p+5, 0x0p+0},
               {-0x1.57f1866658aa4p-2, 0x1.559c16a0f1a45p+5, -0x1.5f556d392a4dfp-6,
                0x1.ce06b6d8f4a71p-2, -0x1.3a505b21d8433p-6, 0x1.9e4b87c8364d3p-2},
               0x1.75404ae70a3e2p-10);
  expect_exact({0x1.6f7007485f128p+2, -0x1.1a9ce454e8719p+0, 0x0p+0},
               {0x1.1284bfbf1b6d9p-2, -0x1.68387e2cfca16p+0, -0x1.9b0cb55f3a74bp+0},
               {-0x1.49f37e45c7277p+3, 0x1.472ec374fd16bp+3, -0x1.ac3424e67e471p+2,
                0x1.300a17e9202bbp+3, -0x1.c605863ca896p+3, 0x1.219d851ef646dp-20},
               0x1.3b966ed1f09ccp+2);
}

TEST(FarApart, ALongFallBesideALowLimit) {
  // Lasted 1.9e-12 s less than is possible, in a blocked interval of its own: the terms of the equation were
  // a hundred times as large as the distance.
  const MotionState from{-0x1.3ea790451d551p+2, 0x1.3759e77bac4fcp+5, 0x1.02b23c4a1a45cp-6};
  const MotionState to{-0x1.1c5da91adf411p-1, -0x1.ed30d67c5542ap+2, 0x1.b09fc9f2edf92p-6};
  const Bounds b{-0x1.577436599feeap+3, 0x1.9e9835d1e4723p+5, -0x1.7961b8ecc6d4dp+5,
                 0x1.be2bc5feec734p-6,  -0x1.77fad2a9dcf8p+5, 0x1.64f58772e3419p+0};
  const double exact = static_cast<double>(minimum(reachable(from, to, b)));
  EXPECT_NEAR(durations(from, to, b).minimum, exact, 1e-12);
}

TEST(FarApart, AShortChangeBesideLongRamps) {
  // The minimum was 1.4e-8 too long, ended off by 2.4e-12, and missed an interval of 1.5e-16 s: rises of
  // microseconds were differences of ramps to zero that take seconds.
  expect_right_edges({0x1.9a0c8073c5af9p-7, 0x0p+0, 0x1.886c96f615adp+1},
                     {0x1.9a0f2b065e84ap-7, 0x1.6df91af816da7p-10, 0x1.8874c85e4f52p+1},
                     {-0x1.d2e30231ec9ffp+3, 0x1.7c998d9f281c1p+2, -0x1.4dfe55dce8b7dp+3,
                      0x1.28a20f553367bp+2, -0x1.bda530b041323p+3, 0x1.196af6b23748fp-1});
  expect_right({0x1.3b3f91a363ec4p-12, -0x1.2dd1260271b2dp+6, 0x1.c894261a94023p-6},
               {0x1.571f012e9fa38p-14, -0x1.2dd125fd052cbp+6, 0x1.c893e0e34ba19p-6},
               {-0x1.856323951f4c1p+6, 0x1.c3fd31f42d5eap-1, -0x1.a5f0a8a444d4ap+0,
                0x1.0f381f68bbe77p-5, -0x1.11560fce906f6p-4, 0x1.490fc9ccbf66cp+5});
  const MotionState from{0x1.13efbb452b4ecp-11, -0x1.593bb611e30f8p+4, -0x1.b2485485f2ccfp-8};
  const MotionState to{-0x1.8f4847f2cb531p-5, -0x1.593bc5edfbaep+4, -0x1.b1f78ba9c856ep-8};
  const Bounds b = within(0x1.59ecd32a08f77p+4, 0x1.3a117e0209e24p-6, 0x1.14b04bb8dfd43p-9);
  EXPECT_TRUE(durations(from, to, b).allows(0.0022832939138240443));
  EXPECT_TRUE(move_to(from, to, b, 0.0022832939138240443));
}

}  // namespace
}  // namespace jounce::proof

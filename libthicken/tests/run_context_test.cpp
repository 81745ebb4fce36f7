// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/run_context.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "thicken/error.h"

namespace thicken {
namespace {

TEST(RunContext, StartsWaitingWithNothingDone) {
  const RunContext context;
  EXPECT_EQ(context.stage(), Stage::kWaiting);
  EXPECT_EQ(context.progress(), 0);
  EXPECT_FALSE(context.cancelled());
  EXPECT_EQ(context.memoryLimit(), 0u);
}

TEST(RunContext, CopiesAreHandlesToOneRun) {
  RunContext caller;
  RunContext library = caller;
  library.enter(Stage::kSweeping, 0.25, 0.5);
  EXPECT_EQ(caller.stage(), Stage::kSweeping);
  EXPECT_DOUBLE_EQ(caller.progress(), 0.25);
  caller.cancel();
  EXPECT_TRUE(library.cancelled());
}

TEST(RunContext, AdvanceMovesWithinTheShareOfTheStage) {
  RunContext context;
  context.enter(Stage::kChecking, 0.2, 0.4);
  context.advance(0.5);
  EXPECT_DOUBLE_EQ(context.progress(), 0.3);
  context.advance(7);
  EXPECT_DOUBLE_EQ(context.progress(), 0.4);
}

TEST(RunContext, ProgressNeverGoesDown) {
  RunContext context;
  double last = 0;
  const auto expectNotLower = [&] {
    EXPECT_GE(context.progress(), last);
    EXPECT_LE(context.progress(), 1);
    last = context.progress();
  };
  context.enter(Stage::kSweeping, 0.5, 0.6);
  expectNotLower();
  context.advance(1);
  expectNotLower();
  context.advance(0.1);
  expectNotLower();
  context.enter(Stage::kAuditing, 0.1, 0.2);
  expectNotLower();
  context.advance(std::numeric_limits<double>::quiet_NaN());
  expectNotLower();
  context.enter(Stage::kDone, 2, 3);
  expectNotLower();
  EXPECT_EQ(last, 1);
}

TEST(RunContext, ProgressNeverGoesDownForAPollingThread) {
  RunContext context;
  std::atomic<bool> done{false};
  std::atomic<int> drops{0};
  std::thread poller([&] {
    double last = 0;
    while (!done) {
      const double now = context.progress();
      if (now < last) ++drops;
      last = now;
    }
  });
  std::vector<std::thread> workers;
  context.enter(Stage::kSweeping, 0, 1);
  for (int k = 0; k < 3; ++k)
    workers.emplace_back([context]() mutable {
      for (int i = 0; i <= 20000; ++i) context.advance(i / 20000.0);
    });
  for (std::thread& worker : workers) worker.join();
  done = true;
  poller.join();
  EXPECT_EQ(drops, 0);
  EXPECT_EQ(context.progress(), 1);
}

TEST(RunContext, ThrowsOnceCancelled) {
  RunContext context;
  EXPECT_NO_THROW(context.throwIfCancelled());
  context.cancel();
  context.cancel();
  try {
    context.throwIfCancelled();
    FAIL() << "a cancelled run went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

TEST(RunContext, ThrowsOnceTheTimeIsOverAndEstimatesWhatIsEnough) {
  RunContext context;
  context.setTimeLimit(1e-9);
  context.enter(Stage::kSweeping, 0.25, 1);
  EXPECT_FALSE(context.cancelled()) << "nobody has asked the run to stop";
  try {
    context.throwIfCancelled();
    FAIL() << "the time limit was not kept";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTimeLimit);
    EXPECT_DOUBLE_EQ(error.enoughSeconds(), 8e-9) << "twice what a quarter took, times four";
    EXPECT_NE(std::string(error.what()).find("25 %"), std::string::npos) << error.what();
  }
  context.cancel();
  EXPECT_THROW(context.throwIfCancelled(), Error);
}

TEST(RunContext, LongAndNoTimeLimitsDoNotEndARun) {
  RunContext context;
  for (const double seconds : {1e300, 3600.0, 0.0}) {
    context.setTimeLimit(seconds);
    EXPECT_NO_THROW(context.throwIfCancelled()) << seconds;
  }
}

TEST(RunContext, ReserveRefusesMoreThanTheLimitAndNamesBoth) {
  RunContext context;
  constexpr std::size_t kMebibyte = 1 << 20;
  EXPECT_NO_THROW(context.reserve(std::numeric_limits<std::size_t>::max(), "")) << "no limit was set";
  context.setMemoryLimit(100 * kMebibyte);
  EXPECT_NO_THROW(context.reserve(100 * kMebibyte, ""));
  try {
    context.reserve(20000000 * kMebibyte + 1, "use larger cells");
    FAIL() << "the limit was not kept";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kMemoryLimit);
    EXPECT_EQ(error.enoughMemory(), 20000000 * kMebibyte + 1);
    EXPECT_NE(sentence.find("100 MiB"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("20000001 MiB"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("use larger cells"), std::string::npos) << sentence;
  }
}

TEST(Stage, EveryStageHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Stage::kDone); ++i)
    EXPECT_TRUE(names.insert(name(static_cast<Stage>(i))).second) << i;
}

}  // namespace
}  // namespace thicken

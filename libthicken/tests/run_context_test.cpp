// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/run_context.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "parallel/parallel_for.h"
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
  const RunContext library = caller;
  library.enter(Stage::kSweeping, 0.25, 0.5, 10);
  EXPECT_EQ(caller.stage(), Stage::kSweeping);
  EXPECT_DOUBLE_EQ(caller.progress(), 0.25);
  library.count(3);
  EXPECT_EQ(caller.counted(), 3u);
  caller.cancel();
  EXPECT_TRUE(library.cancelled());
}

TEST(RunContext, WorkMovesWithinTheShareOfTheStage) {
  const RunContext context;
  context.enter(Stage::kChecking, 0.2, 0.6, 100);
  context.count(50);
  EXPECT_DOUBLE_EQ(context.progress(), 0.2 + 0.4 * 0.75 / 2) << "linear as far as the work was expected";
  context.count(50);
  EXPECT_DOUBLE_EQ(context.progress(), 0.2 + 0.4 * 0.75);
  double last = context.progress();
  for (int i = 0; i < 30; ++i) {
    context.count(100);  // thirty times as much
    EXPECT_GT(context.progress(), last);
    EXPECT_LT(context.progress(), 0.6);
    last = context.progress();
  }
}

TEST(RunContext, AStageWithoutAShareIsAPartOfTheLast) {
  const RunContext context;
  context.enter(Stage::kSweeping, 0, 0.5, 100);
  context.count(100);
  const double before = context.progress();
  context.enter(Stage::kJoining);
  EXPECT_EQ(context.stage(), Stage::kJoining);
  EXPECT_EQ(context.progress(), before);
  context.count(1);
  EXPECT_GT(context.progress(), before);
}

TEST(RunContext, AStageThatComesAgainMovesInWhatRemains) {
  const RunContext context;
  context.enter(Stage::kMeasuring, 0.8, 1, 10);
  context.count(10);
  const double before = context.progress();
  context.enter(Stage::kSweeping, 0.2, 0.6, 10);
  EXPECT_EQ(context.progress(), before);
  context.count(1);
  EXPECT_GT(context.progress(), before);
  context.count(1000);
  EXPECT_LT(context.progress(), before + (1 - before) / 2);
}

TEST(RunContext, TheRunIsAPartOfTheCallers) {
  RunContext context;
  context.enter(Stage::kReading, 0, 0.1, 0);
  context.setPart(0.1, 0.9);
  EXPECT_DOUBLE_EQ(context.progress(), 0.1);
  context.enter(Stage::kSweeping, 0.5, 1, 10);
  EXPECT_DOUBLE_EQ(context.progress(), 0.5);
  context.enter(Stage::kDone, 1, 1, 0);
  EXPECT_DOUBLE_EQ(context.progress(), 0.9);
  context.setPart(0.9, 1);
  context.enter(Stage::kWriting, 0.5, 1, 0);
  EXPECT_DOUBLE_EQ(context.progress(), 0.95);
}

TEST(RunContext, ProgressNeverGoesDown) {
  RunContext context;
  double last = 0;
  const auto expectNotLower = [&] {
    EXPECT_GE(context.progress(), last);
    EXPECT_LE(context.progress(), 1);
    last = context.progress();
  };
  context.count(10);  // before any stage
  expectNotLower();
  context.enter(Stage::kSweeping, 0.5, 0.6, 10);
  expectNotLower();
  context.count(1000);
  expectNotLower();
  context.enter(Stage::kAuditing, 0.1, 0.2, std::numeric_limits<double>::quiet_NaN());
  expectNotLower();
  context.count();
  expectNotLower();
  context.enter(Stage::kAuditing, std::numeric_limits<double>::quiet_NaN(), 0.3, -1);
  expectNotLower();
  context.setPart(0.2, 0.1);
  expectNotLower();
  context.setPart(0, 1);
  context.enter(Stage::kDone, 2, 3, 0);
  expectNotLower();
  EXPECT_EQ(last, 1);
}

TEST(RunContext, ProgressNeverGoesDownForAPollingThread) {
  constexpr int kWorkers = 3, kUnits = 20000;
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
  context.enter(Stage::kSweeping, 0, 1, kWorkers * kUnits);
  for (int k = 0; k < kWorkers; ++k)
    workers.emplace_back([context] {
      for (int i = 0; i < kUnits; ++i) context.count();
    });
  for (std::thread& worker : workers) worker.join();
  done = true;
  poller.join();
  EXPECT_EQ(drops, 0);
  EXPECT_EQ(context.counted(), std::size_t{kWorkers * kUnits});
  EXPECT_DOUBLE_EQ(context.progress(), 0.75);
}

TEST(ParallelFor, CountsItsBlocks) {
  const RunContext context;
  parallel::parallelFor(1000, 2, context, 64, [](std::size_t) {});
  EXPECT_EQ(context.counted(), 16u);
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
  context.enter(Stage::kSweeping, 0.25, 1, 1);
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

#include "gl/basics/failsafe.h"

#include "base/log.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace gluray::gl {
namespace {

class FailsafeTest : public testing::Test {
 protected:
  FailsafeTest() { log::configure(log::Level::off, {}); }
  ~FailsafeTest() override { log::configure(log::Level::warning, {}); }

  /// Clears of depth until tracing goes on.
  int clearsUntilTracing() {
    int clears = 0;
    for (; failsafe_.aside() && clears < 5000; ++clears) failsafe_.depthCleared();
    return clears;
  }

  int held_ = 0;  // times that pending draws were given to the real OpenGL
  Failsafe failsafe_{[this] { ++held_; }};
};

TEST_F(FailsafeTest, ADrawThatCannotBeTracedCostsNothingElse) {
  const Reason reason =
      failsafe_.attempt([]() -> Reason { throw scene::Untraceable("a matrix without inverse"); });
  EXPECT_EQ(reason, Reason::untraceable);
  failsafe_.protect([] { throw scene::Untraceable("another"); });
  failsafe_.fail(scene::Loss::draws, "a third");
  EXPECT_FALSE(failsafe_.aside());
  EXPECT_EQ(held_, 0);
}

TEST_F(FailsafeTest, ShortagesPauseTracingTwiceAsLongEachTime) {
  EXPECT_EQ(failsafe_.attempt([]() -> Reason { throw std::bad_alloc(); }), Reason::shortage);
  EXPECT_TRUE(failsafe_.aside());
  EXPECT_FALSE(failsafe_.gone());
  EXPECT_EQ(held_, 1);
  for (const int pause : {1, 2, 4, 8, 16}) {
    EXPECT_EQ(clearsUntilTracing(), pause);
    failsafe_.fail(scene::Loss::frames, "no memory");
  }
  for (int i = 0; i < 20; ++i) clearsUntilTracing(), failsafe_.fail(scene::Loss::frames, "no memory");
  EXPECT_EQ(clearsUntilTracing(), 1024) << "pauses grow no further";
}

TEST_F(FailsafeTest, FurtherShortagesInAPauseDoNotProlongIt) {
  for (int i = 0; i < 5; ++i) failsafe_.fail(scene::Loss::frames, "no memory");
  EXPECT_EQ(clearsUntilTracing(), 1);
}

TEST_F(FailsafeTest, PausesBeginAnewAfterAsLongWithoutAFailure) {
  for (int i = 0; i < 3; ++i) failsafe_.fail(scene::Loss::frames, "no memory"), clearsUntilTracing();
  for (int i = 0; i < 8; ++i) failsafe_.depthCleared();
  failsafe_.fail(scene::Loss::frames, "no memory");
  EXPECT_EQ(clearsUntilTracing(), 1);
}

TEST_F(FailsafeTest, OtherFailuresEndTracing) {
  EXPECT_EQ(failsafe_.attempt([]() -> Reason { throw std::logic_error("a bug"); }), Reason::failure);
  EXPECT_TRUE(failsafe_.gone());
  for (int i = 0; i < 5000; ++i) failsafe_.depthCleared();
  EXPECT_TRUE(failsafe_.aside());
  EXPECT_EQ(failsafe_.reason(), Reason::failure);
}

TEST_F(FailsafeTest, InsistsOnceMoreAfterAShortage) {
  int tries = 0;
  failsafe_.insist([&] {
    if (++tries == 1) throw std::bad_alloc();
  });
  EXPECT_EQ(tries, 2);
  EXPECT_EQ(failsafe_.reason(), Reason::shortage);
}

}  // namespace
}  // namespace gluray::gl

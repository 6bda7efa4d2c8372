#include "cluster/testing/program_ranks.h"

#include <chrono>
#include <functional>
#include <thread>

namespace gluray::cluster {
namespace {

using State = RankFigures::State;

class PeerFigures : public testing::Test {
 protected:
  /// Rank 0's figures, as soon as they fulfil the condition, or after some seconds.
  std::vector<RankFigures> when(const std::function<bool(const std::vector<RankFigures>&)>& condition) {
    std::vector<RankFigures> figures;
    for (int i = 0; i < 200; ++i) {
      figures = ranks_.program(0).tracer.figures(1000);
      if (condition(figures)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return figures;
  }
  std::vector<RankFigures> afterImages(uint64_t images) {
    return when([&](const auto& figures) {
      return figures.size() == 3 &&
             std::ranges::all_of(figures, [&](const RankFigures& f) { return f.images == images; });
    });
  }

  test::RuntimeFolder folder_;
  test::WorkerJob job_{folder_.directory(), 3};
  test::ProgramRanks ranks_{folder_.directory(), 3};
};

TEST_F(PeerFigures, RankZeroGetsThoseOfAllRanks) {
  EXPECT_EQ(ranks_.program(0).tracer.reach(), RemoteTracer::Reach::untried);
  EXPECT_TRUE(ranks_.program(0).tracer.figures(100).empty()) << "it is not connected";
  ranks_.images(test::plates());
  ranks_.images(test::plates());
  EXPECT_TRUE(ranks_.allByWorkers());
  EXPECT_EQ(ranks_.program(0).tracer.reach(), RemoteTracer::Reach::connected);
  const std::vector<RankFigures> figures = afterImages(2);
  ASSERT_EQ(figures.size(), 3u);
  for (int rank = 0; rank < 3; ++rank) {
    const RankFigures& f = figures[static_cast<size_t>(rank)];
    EXPECT_EQ(f.rank, rank);
    EXPECT_EQ(f.state, State::connected);
    EXPECT_EQ(f.images, 2u);
    EXPECT_FALSE(f.host.empty());
    EXPECT_GT(f.eyeSeconds, 0);
    EXPECT_GT(f.lightSeconds, 0);
    EXPECT_GT(f.traceSeconds, 0);
    EXPECT_LE(f.eyeSeconds + f.lightSeconds + f.depthsSeconds + f.answersSeconds, f.traceSeconds * 1.05)
        << "of rank " << rank << ": parts are not more than the whole";
    EXPECT_GT(f.bytesSent, 0u);
    EXPECT_GT(f.bytesReceived, 0u);
    EXPECT_GT(f.memoryBytes, 1000000u);
  }
  const std::vector<RankFigures> own = ranks_.program(1).tracer.figures(1000);
  ASSERT_EQ(own.size(), 1u);
  EXPECT_EQ(own[0].rank, 1);
}

TEST_F(PeerFigures, LostAndEndedRanksKeepTheirRows) {
  ranks_.images(test::plates());
  afterImages(1);
  ranks_.program(1).tracer.sayEnd(1000);
  ranks_.end(1);
  ranks_.end(2);
  const std::vector<RankFigures> figures = when(
      [](const auto& f) { return f.size() == 3 && f[1].state == State::ended && f[2].state == State::lost; });
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].state, State::connected);
  EXPECT_EQ(figures[1].state, State::ended);
  EXPECT_EQ(figures[2].state, State::lost);
  EXPECT_EQ(figures[2].images, 1u) << "what it spent is kept";
}

TEST_F(PeerFigures, QuestionsDoNotDisturbImages) {
  const Image first = ranks_.images(test::plates())[0];
  for (int i = 0; i < 3; ++i) {
    ranks_.program(0).tracer.figures(1000);
    test::expectSame(ranks_.images(test::plates())[0], first);
  }
  EXPECT_TRUE(ranks_.allByWorkers());
}

}  // namespace
}  // namespace gluray::cluster

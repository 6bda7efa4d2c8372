#include "base/clock.h"
#include "cluster/messages/version.h"
#include "cluster/program/job_question.h"
#include "cluster/testing/job_fixture.h"
#include "control/local_socket.h"
#include "frame/testing/lit_scene.h"

#include <sys/socket.h>
#include <sys/stat.h>

#include <atomic>
#include <string>
#include <thread>

namespace gluray::cluster {
namespace {

class JobInquiryTest : public testing::Test {
 protected:
  std::optional<JobFacts> ask() { return askJob(directory_, "job", why_); }

  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
  std::string why_;
};

TEST_F(JobInquiryTest, FactsOfAllRanks) {
  test::WorkerJob job(directory_, 3);
  for (int question = 0; question < 2; ++question) {
    const auto facts = ask();
    ASSERT_TRUE(facts) << why_;
    ASSERT_EQ(facts->ranks.size(), 3u);
    for (int rank = 0; rank < 3; ++rank) {
      const RankFacts& found = facts->ranks[static_cast<size_t>(rank)];
      EXPECT_TRUE(found.answered);
      EXPECT_EQ(found.rank, rank);
      EXPECT_EQ(found.rankHere, rank);
      EXPECT_EQ(found.ranksHere, 3);
      EXPECT_EQ(found.threads, 1 + rank);
      EXPECT_EQ(found.mpi, "threads");
      EXPECT_EQ(found.version, version());
    }
  }
}

TEST_F(JobInquiryTest, ARankThatDoesNotAnswerIsNamed) {
  test::WorkerJob job(directory_, 3);
  job.rank(1).isDeaf = true;
  const double start = nowSeconds();
  auto facts = ask();
  ASSERT_TRUE(facts) << why_;
  EXPECT_GE(nowSeconds() - start, 1.9);
  EXPECT_LT(nowSeconds() - start, 4);
  EXPECT_TRUE(facts->ranks[0].answered);
  EXPECT_FALSE(facts->ranks[1].answered);
  EXPECT_EQ(facts->ranks[1].rank, 1);
  EXPECT_TRUE(facts->ranks[2].answered);
  job.rank(1).isDeaf = false;
  facts = ask();
  ASSERT_TRUE(facts) << why_;
  EXPECT_TRUE(facts->ranks[1].answered);
}

TEST_F(JobInquiryTest, WhoeverAsksAndGoesHoldsNobodyUp) {
  test::WorkerJob job(directory_, 2);
  job.rank(1).isDeaf = true;
  for (int i = 0; i < 5; ++i) {
    auto line = lineToWorker(directory_, "job", 0, why_);
    ASSERT_TRUE(line) << why_;
    for (const uint16_t type : {Hello::kType, JobQuestion::kType, JobQuestion::kType}) {
      const Hello hello{version(), "stranger", 1};
      const auto body = type == Hello::kType ? encoded(hello) : encoded(JobQuestion{});
      ASSERT_TRUE(line->send(type, body, -1, 1000));
    }
  }
  job.rank(1).isDeaf = false;
  const auto facts = ask();
  ASSERT_TRUE(facts) << why_;
  EXPECT_TRUE(facts->ranks[1].answered);
}

TEST_F(JobInquiryTest, ImagesGoOnMeanwhile) {
  test::WorkerJob job(directory_, 3);
  const scene::Snapshot snapshot = frame::test::litScene(frame::test::Hides::some, 100);
  const Image expected = test::expectedImage(snapshot);
  std::atomic<bool> over{false};
  std::thread asker([&] {
    while (!over) EXPECT_TRUE(ask()) << why_;
  });
  test::Program program(directory_);
  for (int i = 0; i < 20; ++i) test::expectSame(program.image(snapshot), expected);
  over = true;
  asker.join();
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(JobInquiryTest, RanksOfOtherVersionsAreTold) {
  auto threads = std::make_shared<test::ThreadJob>(2);
  test::ThreadRanks head(threads, 0), other(threads, 1);
  JobInquiry inquiry(head, 1);
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends), 0);
  ConnectedProgram program{Line(Descriptor(ends[0]))};
  Line asker{Descriptor(ends[1])};
  inquiry.ask(program, 0);
  inquiry.receive(1, FactsGiven{1, "9.9 (1)", {std::byte{1}}});
  EXPECT_FALSE(asker.receive());
  inquiry.receive(1, FactsGiven{7, "9.9 (1)", {}});  // of no question
  inquiry.tick(2.1);
  const auto message = asker.receive();
  ASSERT_TRUE(message);
  const auto facts = decoded<JobFacts>(message->body);
  EXPECT_FALSE(facts.ranks.at(0).answered);
  EXPECT_TRUE(facts.ranks.at(1).answered);
  EXPECT_EQ(facts.ranks.at(1).version, "9.9 (1)");
  EXPECT_EQ(facts.ranks.at(1).host, "");
}

TEST_F(JobInquiryTest, WithoutAJobALineSaysWhy) {
  EXPECT_FALSE(ask());
  EXPECT_EQ(why_, "no gluray-worker --job job runs on this machine");
  EXPECT_FALSE(askJob(directory_, "a/b", why_));
  EXPECT_NE(why_.find("names no job"), std::string::npos) << why_;
  std::filesystem::create_directories(directory_);
  ASSERT_EQ(chmod(directory_.c_str(), 0755), 0);
  EXPECT_FALSE(ask());
  EXPECT_NE(why_.find("run chmod 700"), std::string::npos) << why_;
}

}  // namespace
}  // namespace gluray::cluster

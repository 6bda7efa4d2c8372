#include "accel/testing/test_scene.h"
#include "base/clock.h"
#include "cluster/messages/version.h"
#include "cluster/testing/job_fixture.h"
#include "control/local_socket.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <random>
#include <string>

namespace gluray::cluster {
namespace {

using test::expectedImage;
using test::expectSame;
using test::plainScene;
using test::Program;
using test::WorkerJob;

class WorkerFaults : public testing::Test {
 protected:
  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
};

TEST_F(WorkerFaults, WithoutAWorkerTheProgramTraces) {
  Program program(directory_);
  const scene::Snapshot s = plainScene();
  expectSame(program.image(s), expectedImage(s));
  expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(program.tracedHere, 2);
  EXPECT_EQ(std::ranges::count(program.said, '\n'), 1) << program.said;
}

TEST_F(WorkerFaults, AJobThatEndsAndComesBack) {
  Program program(directory_);
  const scene::Snapshot s = plainScene();
  {
    WorkerJob job(directory_, 2);
    expectSame(program.image(s), expectedImage(s));
  }
  expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(program.tracedHere, 1);
  WorkerJob job(directory_, 3);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(program.tracedHere, 1) << program.said;
}

TEST_F(WorkerFaults, ARankThatIsStoppedIsLeftOutUntilItGoesOn) {
  WorkerJob job(directory_, 3);
  Program program(directory_);
  const scene::Snapshot s = plainScene();
  expectSame(program.image(s), expectedImage(s));
  job.rank(2).isDeaf = true;
  const double start = nowSeconds();
  expectSame(program.image(s), expectedImage(s));
  EXPECT_LT(nowSeconds() - start, 2.5);
  const double next = nowSeconds();
  expectSame(program.image(s), expectedImage(s));
  EXPECT_LT(nowSeconds() - next, 0.9) << "it is not waited for again";
  EXPECT_NE(job.said().find("rank 2 does not answer"), std::string::npos) << job.said();
  job.rank(2).isDeaf = false;
  for (int i = 0; i < 3; ++i) expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

/// Whether the rank traces: whoever does is missed when it stops.
bool takesPart(WorkerJob& job, Program& program, int rank, const scene::Snapshot& s) {
  const std::string missed = "rank " + std::to_string(rank) + " does not answer";
  const size_t before = job.said().rfind(missed);
  job.rank(rank).isDeaf = true;
  program.image(s);
  job.rank(rank).isDeaf = false;
  return job.said().rfind(missed) != before;
}

TEST_F(WorkerFaults, ARankThatGetsGeometryLateTakesPartAfterwards) {
  WorkerJob job(directory_, 3);
  Program program(directory_);
  scene::Snapshot s = plainScene();
  program.image(s);
  job.rank(2).isSlow = true;
  s.instances[0].mesh = gluray::test::makeMesh(gluray::test::squareData(-0.5f));
  expectSame(program.image(s), expectedImage(s));
  expectSame(program.image(s), expectedImage(s));
  job.rank(2).isSlow = false;
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  expectSame(program.image(s), expectedImage(s));
  EXPECT_TRUE(takesPart(job, program, 2, s)) << job.said();
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(WorkerFaults, NothingPilesUpForARankThatIsStopped) {
  WorkerJob job(directory_, 3);
  Program program(directory_);
  const scene::Snapshot s = plainScene();
  program.image(s);
  job.rank(2).isDeaf = true;
  for (int i = 0; i < 2; ++i) program.image(s);  // the second may come before the end of the first is told
  const size_t waiting = job.waiting(2);
  for (int i = 0; i < 20; ++i) expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(job.waiting(2), waiting);
}

/// A connection that says whatever it likes.
Line strangerTo(const std::string& directory) {
  std::string why;
  bool nobody = false;
  Line line(control::connectedSocket(directory + "/" + workerPlace("job", 0) + ".sock", why, nobody));
  EXPECT_EQ(why, "");
  return line;
}

/// What a program says when it asks for an image.
std::vector<Message> conversation(const scene::Snapshot& snapshot, bool isRank) {
  std::vector<Message> all;
  const auto add = [&]<class M>(const M& message) {
    all.push_back({M::kType, encoded(message), Descriptor()});
  };
  SnapshotEncoder encoder;
  const EncodedSnapshot sent = encoder.encode(snapshot);
  add(isRank ? Hello{version(), "stranger", 1, "mpi", 1, 3} : Hello{version(), "stranger", 1});
  for (const ArraySource& source : sent.arrays) {
    add(ArrayComes{source.name, source.bytes()});
    all.back().attached = sealedMemory(source.bytes(), [&](std::byte* to) { source.copyTo(to); });
  }
  TraceRequest request;
  request.id = 1, request.width = snapshot.region.width, request.height = snapshot.region.height;
  request.meetsPeers = isRank;
  request.snapshot = sent.message;
  add(request);
  add(JobQuestion{});
  add(Cancel{1});
  add(ArraysGo{{sent.arrays[0].name}});
  return all;
}

TEST_F(WorkerFaults, WhateverAProgramSaysOthersGetTheirImages) {
  WorkerJob job(directory_, 2);
  const scene::Snapshot s = plainScene(40);
  const Image expected = expectedImage(s);
  std::mt19937 random(7);
  Program program(directory_);
  for (int round = 0; round < 300; ++round) {
    Line line = strangerTo(directory_);
    std::vector<Message> said = conversation(s, round % 3 == 0);
    const size_t wrong = random() % said.size();
    for (size_t i = 0; i < said.size(); ++i) {
      Message& message = said[i];
      if (i == wrong) {
        if (random() % 4 == 0) message.type = static_cast<uint16_t>(random() % 12);
        for (int change = 0; change < 3 && !message.body.empty(); ++change)
          message.body[random() % message.body.size()] ^= static_cast<std::byte>(1 << random() % 8);
        if (random() % 4 == 0) message.body.resize(random() % (message.body.size() + 1));
        if (random() % 8 == 0) message.attached = Descriptor();
      }
      if (!line.send(message.type, message.body, message.attached.get(), 1000)) break;
    }
    if (round % 10 == 0) expectSame(program.image(s), expected);
  }
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

void sendArray(Line& line, const Hash128& name, const Descriptor& memory, size_t bytes) {
  ASSERT_TRUE(line.send(ArrayComes::kType, encoded(ArrayComes{name, bytes}), memory.get(), 1000));
}

void sayHello(Line& line) {
  ASSERT_TRUE(line.send(Hello::kType, encoded(Hello{version(), "stranger", 1}), -1, 1000));
}

TEST_F(WorkerFaults, GigabytesOfOneProgramDoNotHoldUpAnother) {
  constexpr size_t kBytes = size_t{64} << 20;
  WorkerJob job(directory_, 2);
  const scene::Snapshot s = plainScene(40);
  Program program(directory_);
  expectSame(program.image(s), expectedImage(s));
  const Descriptor memory = sealedMemory(kBytes, [](std::byte* at) { std::memset(at, 1, kBytes); });
  const std::vector<std::byte> content(kBytes, std::byte{1});
  const Hash128 name = hashBytes(content.data(), kBytes);
  Line line = strangerTo(directory_);
  sayHello(line);
  for (int i = 0; i < 80; ++i) {  // each time it is as new
    sendArray(line, name, memory, kBytes);
    ASSERT_TRUE(line.send(ArraysGo::kType, encoded(ArraysGo{{name}}), -1, 1000));
  }
  for (float i = 0; i < 5; ++i) {
    scene::Snapshot next = s;
    next.instances[0].mesh = gluray::test::makeMesh(gluray::test::squareData(-0.1f * i));
    expectSame(program.image(next), expectedImage(next));
  }
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(WorkerFaults, AnArrayThatIsNotWhatItsNameSays) {
  constexpr size_t kBytes = 64;
  WorkerJob job(directory_, 2);
  const auto memoryOf = [](int value) {
    return sealedMemory(kBytes, [value](std::byte* at) { std::memset(at, value, kBytes); });
  };
  const std::vector<std::byte> content(kBytes, std::byte{1});
  const Hash128 name = hashBytes(content.data(), kBytes);
  Line liar = strangerTo(directory_);
  sayHello(liar);
  sendArray(liar, name, memoryOf(2), kBytes);
  while (liar.receive(5000)) continue;
  EXPECT_TRUE(liar.isBroken());
  EXPECT_NE(job.said().find("is not what its name says"), std::string::npos) << job.said();

  Line honest = strangerTo(directory_);
  sayHello(honest);
  sendArray(honest, name, memoryOf(1), kBytes);
  ASSERT_TRUE(honest.send(JobQuestion::kType, {}, -1, 1000));
  EXPECT_TRUE(honest.receive(5000)) << "a welcome";
  EXPECT_TRUE(honest.receive(5000)) << "facts";
  EXPECT_FALSE(honest.isBroken()) << job.said();
}

TEST_F(WorkerFaults, WhoeverSaysHelloTwiceIsDisconnected) {
  WorkerJob job(directory_, 1);
  Line line = strangerTo(directory_);
  for (int i = 0; i < 2; ++i)
    line.send(Hello::kType, encoded(Hello{version(), "stranger", 1, "mpi", 1, 3}), -1, 1000);
  while (line.receive(5000)) continue;
  EXPECT_TRUE(line.isBroken());
  EXPECT_NE(job.said().find("it says hello twice"), std::string::npos) << job.said();
}

TEST_F(WorkerFaults, NamesOfJobsAreChecked) {
  EXPECT_EQ(whyNoJobName("job"), "");
  for (const std::string& name : std::vector<std::string>{"", "a/b", "../x", "a b", std::string(41, 'a')})
    EXPECT_NE(whyNoJobName(name), "") << name;
}

}  // namespace
}  // namespace gluray::cluster

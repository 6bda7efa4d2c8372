// Changes of MPI jobs: in the same frame of all ranks, or of none.
#include "control/hub/job_change.h"

#include "control/testing/core_fixture.h"

namespace gluray::control::test {
namespace {

HeldAt at(int64_t frame, bool drawing, double began = 0, double period = 0) {
  return {frame, drawing,
          HubTime{std::chrono::duration_cast<HubTime::duration>(std::chrono::duration<double>(began))},
          period};
}

TEST(FramesToApply, AreTheSameFrameOfAllRanks) {
  using Frames = std::map<int, int64_t>;
  EXPECT_EQ(framesToApply({{0, at(10, false)}, {1, at(10, false)}}), (Frames{{0, 11}, {1, 11}}));
  EXPECT_EQ(framesToApply({{0, at(10, false)}, {1, at(10, true)}}), (Frames{{0, 12}, {1, 12}}));
  EXPECT_EQ(framesToApply({{0, at(10, true)}, {1, at(14, true)}}), (Frames{{0, 12}, {1, 16}}))
      << "counts that differ by a constant";
  // Rank 1 has begun its next frame, rank 0 has not.
  EXPECT_EQ(framesToApply({{0, at(10, true, 5.0, 0.1)}, {1, at(11, true, 5.1, 0.1)}}),
            (Frames{{0, 13}, {1, 13}}));
  EXPECT_EQ(framesToApply({{0, at(10, true, 5.0, 0.1)}, {1, at(15, true, 5.1, 0.1)}}),
            (Frames{{0, 13}, {1, 17}}));
  EXPECT_EQ(framesToApply({{0, at(10, true, 5.0, 0.1)}, {1, at(10, true, 5.01, 0.1)}}),
            (Frames{{0, 12}, {1, 12}}));
  EXPECT_EQ(framesToApply({{0, at(10, false, 5, 0.1)}, {1, at(10, false, 9, 0.1)}}),
            (Frames{{0, 11}, {1, 11}}))
      << "ranks at rest have all drawn the same frame";
}

struct HubCoreJobs : HubCoreTest {
  void SetUp() override {
    for (int rank = 0; rank < 3; ++rank) ranks.push_back(&program("job 1", rank, 3));
    peer = &client();
  }
  void ask(const std::string& type, int id = 1) {
    json request{{"type", type}, {"id", id}, {"program", 1}};
    if (type == "set") request["values"] = {{"ao", true}};
    give(*peer, request);
  }
  /// Makes all ranks hold the change, the first one at the given frame.
  std::vector<json> hold(const std::string& type, int frame, bool drawing) {
    std::vector<json> holds;
    for (FakePeer* rank : ranks) {
      holds.push_back(rank->one(type));
      EXPECT_EQ(holds.back().value("hold", false), true);
      answer(*rank, holds.back(), {{"frame", frame++}, {"drawing", drawing}});
    }
    return holds;
  }
  std::vector<FakePeer*> ranks;
  FakePeer* peer = nullptr;
};

TEST_F(HubCoreJobs, AJobIsOneEntry) {
  give(*peer, {{"type", "list"}, {"id", 1}});
  const json programs = answered(*peer)["programs"];
  ASSERT_EQ(programs.size(), 1u);
  EXPECT_EQ(programs[0]["ranks"], 3);
  EXPECT_EQ(programs[0]["connected"], 3);
  EXPECT_EQ(programs[0]["pid"], 101);
  EXPECT_EQ(hub_.programs(), 3u);
  program("job 1", 1, 3);  // this rank is already connected
  program("job 1", 3, 4);  // from another job with the same name
  give(*peer, {{"type", "list"}, {"id", 1}});
  EXPECT_EQ(answered(*peer)["programs"].size(), 3u);
}

TEST_F(HubCoreJobs, ChangesAreHeldAppliedAndDrawn) {
  for (const char* type : {"set", "undo", "redo"}) {
    ask(type);
    const std::vector<json> holds = hold(type, 10, true);
    for (size_t i = 0; i < 3; ++i) {
      const json apply = ranks[i]->one("apply");
      EXPECT_EQ(apply["of"], holds[i]["id"]);
      EXPECT_EQ(apply["frame"], 12 + i) << "in the rank's own count";
      EXPECT_TRUE(ranks[0]->takeMessages("draw").empty()) << "not before all ranks have it";
      answer(*ranks[i], apply, {{"frame", 12 + i}});
    }
    for (size_t i = 0; i < 3; ++i) {
      const json draw = ranks[i]->one("draw");
      EXPECT_EQ(draw["of"], holds[i]["id"]);
      answer(*ranks[i], draw, {{"frame", 12 + i}, {"values", {{"ao", true}}}});
    }
    EXPECT_EQ(result(*peer), (json{{"program", 1}, {"frame", 12}, {"values", {{"ao", true}}}}));
  }
}

TEST_F(HubCoreJobs, ARefusalDropsItEverywhere) {
  ask("set");
  answer(*ranks[0], ranks[0]->one("set"), {{"frame", 1}, {"drawing", false}});
  answer(*ranks[2], ranks[2]->one("set"), {{"why", "ao=true: no"}});
  EXPECT_EQ(result(*peer)["why"], "rank 2: ao=true: no");
  const json late = ranks[1]->one("set");
  for (FakePeer* rank : ranks) rank->one("drop");
  answer(*ranks[1], late, {{"frame", 1}, {"drawing", false}});
  EXPECT_TRUE(ranks[1]->got.empty());
}

TEST_F(HubCoreJobs, SilenceAndNonsenseAreRefusals) {
  for (const json& nonsense : {json::object(), json{{"frame", 1}}, json{{"frame", -1}, {"drawing", true}},
                               json{{"frame", 1.5}, {"drawing", true}}, json{{"frame", 1}, {"drawing", 1}}}) {
    ask("set");
    answer(*ranks[0], ranks[0]->one("set"), nonsense);
    EXPECT_NE(result(*peer).value("why", ""), "") << nonsense;
    for (FakePeer* rank : ranks) rank->got.clear();
  }
  ask("set");
  answer(*ranks[0], ranks[0]->one("set"), {{"frame", 1}, {"drawing", false}});
  wait(milliseconds(1000));
  EXPECT_EQ(result(*peer)["why"], "rank 1: it did not answer within 1 s");
  for (FakePeer* rank : ranks) rank->one("drop");
}

TEST_F(HubCoreJobs, LateRanksAreNamed) {
  ask("set");
  hold("set", 10, true);
  answer(*ranks[2], ranks[2]->one("apply"), {{"frame", 15}, {"late", true}});
  answer(*ranks[1], ranks[1]->one("apply"), {{"frame", 15}, {"late", true}});
  answer(*ranks[0], ranks[0]->one("apply"), {{"frame", 12}, {"late", false}});
  for (FakePeer* rank : ranks) answer(*rank, rank->one("draw"), {{"frame", 12}, {"values", json::object()}});
  EXPECT_EQ(result(*peer)["late"], json::array({1, 2}));
}

TEST_F(HubCoreJobs, ARankThatGoesFailsTheChange) {
  ask("set");
  end(*ranks[1]);
  EXPECT_EQ(result(*peer)["why"], "rank 1: it has ended");
  ranks[0]->one("drop");
  ask("set", 2);
  EXPECT_EQ(result(*peer, 2)["why"], "only 2 of the job's 3 ranks are connected");
  ranks[1] = &program("job 1", 1, 3);
  for (FakePeer* rank : ranks) rank->got.clear();
  ask("set", 3);
  hold("set", 10, true);
  for (FakePeer* rank : ranks) answer(*rank, rank->one("apply"), {{"frame", 12}});
  end(*ranks[2]);
  answer(*ranks[0], ranks[0]->one("draw"), {{"frame", 12}, {"values", json::object()}});
  answer(*ranks[1], ranks[1]->one("draw"), {{"frame", 12}, {"values", json::object()}});
  EXPECT_NE(result(*peer, 3)["why"].get<std::string>().find("rank 2: it has ended"), std::string::npos);
}

TEST_F(HubCoreJobs, ManyChangesWaitWithoutRecursion) {
  std::vector<FakePeer*> clients;
  for (int i = 0; i < 100; ++i) clients.push_back(&client());
  for (FakePeer* each : clients)
    for (int id = 0; id < 256; ++id) give(*each, {{"type", "undo"}, {"id", id}, {"program", 1}});
  end(*ranks[2]);
  for (FakePeer* each : clients) EXPECT_EQ(each->takeMessages("answer").size(), 256u);
}

TEST_F(HubCoreJobs, RankZeroSpeaksForTheJob) {
  give(*peer, {{"type", "get"}, {"id", 1}, {"program", 1}});
  answer(*ranks[0], ranks[0]->one("get"), {{"values", json::object()}});
  EXPECT_TRUE(result(*peer).contains("values"));
  EXPECT_TRUE(ranks[1]->got.empty());
  give(*peer, {{"type", "observe"}, {"id", 1}, {"program", 1}, {"what", {"state"}}});
  answered(*peer);
  ranks[0]->one("observe");
  give(*ranks[1], {{"type", "event"}, {"what", "state"}, {"state", json::object()}});
  EXPECT_TRUE(peer->got.empty()) << "other ranks are not heard";
  end(*ranks[0]);
  give(*peer, {{"type", "get"}, {"id", 2}, {"program", 1}});
  EXPECT_EQ(result(*peer, 2)["why"], "rank 0 of the job is not connected");
  EXPECT_TRUE(ranks[1]->got.empty());
  FakePeer& again = connect();
  give(again, {{"type", "hello"},
               {"version", 1},
               {"role", "program"},
               {"pid", 7},
               {"host", "b"},
               {"name", "c"},
               {"rank", 0},
               {"ranks", 3},
               {"job", "job 1"}});
  again.one("observe");
}

}  // namespace
}  // namespace gluray::control::test

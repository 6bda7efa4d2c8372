// Ranks whose programs draw, trace and compose at times of our own: which parts each of their images shows.
#include "cluster/gather/part_gatherer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

using Parts = std::vector<int>;  // ranks whose parts an image shows
using Share = PartGatherer::Share;

constexpr double kStep = 0.005;  // seconds

/// One rank and its program, whose tracing takes some time.
class SimulatedRank {
 public:
  SimulatedRank(int rank, int ranks, PartGatherer::Send send)
      : rank_(rank), gatherer_({}, rank, ranks, std::move(send), [this](const std::string& line) {
          said += line + "\n";
        }) {}

  void draw(TraceRequest request, double now, double duration) {
    request_ = std::move(request);
    duration_ = duration;
    answer.reset();
    share_ = Share::awaited;
    gatherer_.begin(*request_, now);
  }
  void take(std::span<const std::byte> bytes, double now) {
    uint16_t type = 0;
    std::memcpy(&type, bytes.data(), sizeof type);
    const std::span<const std::byte> body = bytes.subspan(sizeof type);
    const auto as = [&]<class M>(M) {
      if (type == M::kType) gatherer_.receive(decoded<M>(body), now);
    };
    as(PartHere{}), as(PartOver{}), as(PartComes{}), as(PartGiven{}), as(PartDone{}), as(PartImage{});
    as(PartGone{}), as(PartAtWork{});
  }
  void look(double now) {
    gatherer_.tick(now);
    if (!request_) return;
    if (share_ == Share::whole && gatherer_.isLost()) share_ = Share::awaited;
    if (share_ == Share::awaited) {
      share_ = gatherer_.findShare(*request_, now);
      ends_ = now + duration_;
    }
    if (share_ == Share::awaited || (share_ != Share::shown && now < ends_)) return;
    show(now);
    request_.reset();
  }
  bool isIdle() const { return !request_; }

  std::optional<Parts> answer;  // of the last image
  std::string said;

 private:
  void show(double now) {
    answer = {rank_};
    if (share_ == Share::shown) {
      answer->clear();
      for (const std::byte one : gatherer_.image()->pixels) answer->push_back(static_cast<int>(one));
      return gatherer_.end(false, now);
    }
    if (share_ == Share::own) return gatherer_.end(false, now);
    for (const PartGiven& part : gatherer_.parts()) {
      EXPECT_EQ(part.number, request_->number) << "a part of another scene";
      answer->push_back(part.address.from);
    }
    gatherer_.end(true, now);
    PartImage image;
    image.shape = {1, 1, 1, Image::kColorDepth};
    for (const int rank : *answer) image.pixels.push_back(static_cast<std::byte>(rank));
    gatherer_.show(request_->number, image);
  }

  const int rank_;
  PartGatherer gatherer_;
  std::optional<TraceRequest> request_;
  Share share_ = Share::own;
  double duration_ = 0, ends_ = 0;
};

/// The ranks of a program that composes each scene before it goes on to the next one.
class SimulatedProgram {
 public:
  explicit SimulatedProgram(int ranks) {
    for (int rank = 0; rank < ranks; ++rank)
      ranks_.push_back(std::make_unique<SimulatedRank>(rank, ranks, [this, rank](int to, auto message) {
        lines_.push_back({rank, to, now_ + delay * (1 + (3 * rank + 5 * to) % 4), std::move(message)});
      }));
  }
  struct Drawing {
    int rank = 0;
    double after = 0;  // seconds from the scene's begin
    double duration = 0.02;
    bool blends = false;
  };
  /// The scene's images, of the ranks that draw it, in that order. Empty: some have none after a minute.
  std::vector<Parts> scene(const std::vector<Drawing>& drawings, uint64_t view = 1) {
    ++number_;
    const double began = now_;
    std::vector<int> begun(drawings.size());
    for (; now_ < began + 60; step()) {
      bool all = true;
      for (size_t i = 0; i < drawings.size(); ++i) {
        const Drawing& drawing = drawings[i];
        if (now_ < began + drawing.after) all = false;
        if (now_ < began + drawing.after || begun[i]++ > 0) continue;
        TraceRequest request;
        request.number = number_, request.view = view;
        request.part.viewport = {0, 0, 9, 9};
        request.part.blends = drawing.blends;
        rank(drawing.rank).draw(std::move(request), now_, drawing.duration);
      }
      if (all && std::ranges::all_of(ranks_, [](const auto& r) { return r->isIdle(); })) break;
    }
    std::vector<Parts> images;
    for (const Drawing& drawing : drawings)
      if (const auto& answer = rank(drawing.rank).answer; answer && rank(drawing.rank).isIdle())
        images.push_back(*answer);
    return images.size() == drawings.size() ? images : std::vector<Parts>();
  }
  std::vector<Parts> sceneOf(const std::vector<int>& drawing, uint64_t view = 1) {
    std::vector<Drawing> drawings;
    for (const int rank : drawing) drawings.push_back({rank});
    return scene(drawings, view);
  }
  SimulatedRank& rank(int rank) { return *ranks_[static_cast<size_t>(rank)]; }
  double now() const { return now_; }
  double delay = 0.002;  // of messages, and up to four times as much

 private:
  struct Sent {
    int from, to;
    double arrives;
    std::vector<std::byte> message;
  };
  void step() {
    now_ += kStep;
    const std::deque<Sent> sent = std::exchange(lines_, {});
    for (const Sent& one : sent)
      if (one.arrives <= now_)
        rank(one.to).take(one.message, now_);
      else
        lines_.push_back(one);
    for (const auto& one : ranks_) one->look(now_);
  }

  std::vector<std::unique_ptr<SimulatedRank>> ranks_;
  std::deque<Sent> lines_;
  double now_ = 0;
  uint64_t number_ = 0;
};

std::vector<Parts> all(const Parts& parts) { return std::vector<Parts>(parts.size(), parts); }

TEST(PartGatherer, AllRanksShowAllParts) {
  SimulatedProgram program(3);
  for (int scene = 0; scene < 5; ++scene) EXPECT_EQ(program.sceneOf({0, 1, 2}), all({0, 1, 2}));
  EXPECT_LT(program.now(), 1);
}

TEST(PartGatherer, RanksThatMissScenesShiftNoOtherScenes) {
  SimulatedProgram program(3);
  const std::vector<Parts> drawing = {{0, 1, 2}, {0, 2},    {1, 2}, {0, 1, 2}, {0, 1},
                                      {2},       {0, 1, 2}, {1},    {0, 2}};
  for (int round = 0; round < 3; ++round)
    for (const Parts& parts : drawing) EXPECT_EQ(program.sceneOf(parts), all(parts)) << round;
}

/// Waits of views in which nothing changes.
TEST(PartGatherer, RanksThatMissViewsAreAwaitedOnce) {
  SimulatedProgram program(4);
  const std::vector<Parts> views = {{0, 1}, {2, 3}, {0, 1, 2, 3}, {3}};
  double began = 0;
  for (int frame = 0; frame < 6; ++frame) {
    if (frame == 1) began = program.now();
    for (size_t view = 0; view < views.size(); ++view)
      EXPECT_EQ(program.sceneOf(views[view], view + 1), all(views[view]));
  }
  EXPECT_LT(program.now() - began, 5 * 3 * 0.5) << "three views wait, for a quarter of a second";
}

TEST(PartGatherer, PartsThatComeWhileTheImageIsTracedBelongToIt) {
  SimulatedProgram program(3);
  for (int late = 0; late < 3; ++late) {
    const int other = (late + 1) % 3;
    EXPECT_EQ(program.scene({{other, 0, 3}}), all({other})) << "the others are known to draw nothing";
    const std::vector<Parts> two = program.scene({{other, 0, 2}, {late, 1.5, 2}});
    const Parts both = {std::min(other, late), std::max(other, late)};
    EXPECT_EQ(two, all(both)) << late;
  }
}

/// The lowest rank comes last, when the others have given their parts to each other.
TEST(PartGatherer, LowerRanksThatComeLateGather) {
  SimulatedProgram program(4);
  EXPECT_EQ(program.sceneOf({2, 3}), all({2, 3}));
  EXPECT_EQ(program.scene({{3, 0, 3}, {2, 0.1, 3}, {1, 2, 3}, {0, 3, 3}}),
            (std::vector<Parts>{{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}}));
}

TEST(PartGatherer, PartsThatComeAfterTheImageStandAlone) {
  SimulatedProgram program(3);
  EXPECT_EQ(program.sceneOf({1}), all({1}));
  EXPECT_EQ(program.scene({{1, 0}, {0, 2}, {2, 4}}), (std::vector<Parts>{{1}, {0}, {2}}));
  EXPECT_EQ(program.sceneOf({0, 1, 2}), all({0, 1, 2}));
}

TEST(PartGatherer, WhereOneRankBlendsNoneGathers) {
  SimulatedProgram program(3);
  EXPECT_EQ(program.sceneOf({0, 1, 2}), all({0, 1, 2}));
  for (const double late : {0.0, 0.1, 0.5})
    EXPECT_EQ(program.scene({{0, 0, 2}, {1, 0, 2}, {2, late, 2, true}}), (std::vector<Parts>{{0}, {1}, {2}}));
  EXPECT_NE(program.rank(1).said.find("rank 2 of the program blends surfaces"), std::string::npos);
}

/// Whatever the times: each image shows its rank's part, and none waits for ever. All parts where ranks
/// draw at about the same time.
TEST(PartGatherer, AnyTimesLeadToImages) {
  std::mt19937 random(7);
  const auto upTo = [&](double most) { return std::uniform_real_distribution<double>(0, most)(random); };
  for (int run = 0; run < 200; ++run) {
    const int ranks = 2 + run % 5;
    SimulatedProgram program(ranks);
    program.delay = upTo(0.015);
    const double skew = run % 2 ? 0.1 : 3;
    for (int scene = 0; scene < 20; ++scene) {
      std::vector<SimulatedProgram::Drawing> drawings;
      for (int rank = 0; rank < ranks; ++rank)
        if (upTo(1) < 0.7) drawings.push_back({rank, upTo(skew), upTo(0.5)});
      if (drawings.empty()) continue;
      const std::vector<Parts> images = program.scene(drawings, 1 + random() % 2);
      ASSERT_EQ(images.size(), drawings.size()) << "run " << run << ", scene " << scene;
      for (size_t i = 0; i < drawings.size(); ++i) {
        const int rank = drawings[i].rank;
        ASSERT_NE(std::ranges::find(images[i], rank), images[i].end()) << run << " " << scene;
        if (skew < 1) { ASSERT_EQ(images[i].size(), drawings.size()) << run << " " << scene; }
      }
    }
  }
}

}  // namespace
}  // namespace gluray::cluster

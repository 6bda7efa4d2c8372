// Shots and thumbnails, with a fake program and a fake clock.
#include "control/link/image_requests.h"

#include "base/clock.h"
#include "control/messages/base64.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

struct WindowProgram final : ControlledProgram {
  json identity() override { return {}; }
  Figures figures() override { return {}; }
  json state() override { return {}; }
  Called call(const std::string&, const json&, json&, std::string&) override { return Called::done; }
  void wake() noexcept override { ++woken; }
  void wantImage(Wanted w) noexcept override { wanted = w; }
  std::unique_ptr<KeptImage> takeImage() noexcept override { return std::move(kept); }

  /// Shows a frame in the program's window.
  void show(uint64_t frame, int width = 4, int height = 2, bool later = false) {
    if (wanted == Wanted::none || (later && wanted == Wanted::next)) return;
    kept = std::make_unique<KeptImage>();
    kept->width = width, kept->height = height, kept->frame = frame;
    kept->pixels.assign(static_cast<size_t>(width) * static_cast<size_t>(height), 0xff030201u);
    kept->next = std::exchange(wanted, Wanted::none) == Wanted::next;
  }

  Wanted wanted = Wanted::none;
  std::unique_ptr<KeptImage> kept;
  int woken = 0;
};

struct ImagesTest : testing::Test {
  void pass(double seconds) { images.passed(slow, now += seconds), waker.passed(now); }
  /// Begins and shows a frame.
  void frame(int width = 4, int height = 2) {
    source.beginFrame();
    program.show(source.frame(), width, height);
    source.endFrame();
    now = std::max(now, nowSeconds() + ahead);
    images.passed(slow, now), waker.passed(now);
  }
  void shoot(const json& arguments = json::object()) {
    images.startCall("shot", ++id, arguments, now);
    images.passed(slow, now), waker.passed(now);
  }
  json piece(const json& shot, const json& row) {
    images.startCall("pixels", ++id, {{"shot", shot}, {"row", row}}, now);
    return answers.back();
  }
  size_t thumbnails() const { return events.size(); }

  WindowProgram program;
  SettingsSource source;
  std::vector<json> answers, events;
  double ahead = 0, now = nowSeconds();
  bool slow = false;
  int id = 0;
  Waker waker{program, source};
  ImageRequests images{program, source, waker,
                       [this](const json&, json result) { answers.push_back(std::move(result)); },
                       [this](json event) { events.push_back(std::move(event)); }};
};

TEST_F(ImagesTest, NothingIsWantedUnasked) {
  frame(), pass(1), frame();
  EXPECT_EQ(program.wanted, Wanted::none);
  EXPECT_EQ(program.woken, 0);
  EXPECT_GT(images.nextDue(now), now + 1e9);
}

TEST_F(ImagesTest, AShotIsTheNextFrame) {
  frame();
  shoot(), shoot();
  EXPECT_EQ(program.wanted, Wanted::next);
  EXPECT_EQ(program.woken, 0) << "it draws";
  program.show(0, 4, 2, /*later=*/true);
  pass(0.01);
  EXPECT_TRUE(answers.empty()) << "a frame that was ended before";
  frame();
  ASSERT_EQ(answers.size(), 2u) << "one image answers all";
  EXPECT_EQ(answers[0]["value"], json({{"shot", 1}, {"width", 4}, {"height", 2}, {"frame", 2}}));
  EXPECT_EQ(answers[1], answers[0]);
  EXPECT_EQ(program.wanted, Wanted::none);
  EXPECT_EQ(piece(1, 0)["value"]["pixels"],
            toBase64(std::string("\1\2\3\1\2\3\1\2\3\1\2\3\1\2\3\1\2\3\1\2\3\1\2\3")));
}

TEST_F(ImagesTest, ProgramsThatDrawNothingAreAskedTo) {
  frame(), pass(1);
  shoot();
  EXPECT_EQ(program.woken, 1);
  for (int i = 0; i < 7900; ++i) pass(0.001);
  EXPECT_GT(program.woken, 4);
  EXPECT_LT(program.woken, 10) << "less and less often";
  EXPECT_TRUE(answers.empty());
  pass(0.2);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_NE(answers[0].value("why", ""), "");
  EXPECT_EQ(program.wanted, Wanted::none);
}

TEST_F(ImagesTest, PiecesCoverTheShot) {
  shoot();
  frame(1000, 900);
  std::string bytes;
  for (int row = 0; row < 900;) {
    const json value = piece(1, row)["value"];
    EXPECT_LT(value.dump().size(), size_t{1} << 20);
    bytes += *fromBase64(value["pixels"].get<std::string>());
    EXPECT_EQ(value["row"], row);
    row += value["rows"].get<int>();
  }
  EXPECT_EQ(bytes.size(), 3u * 1000 * 900);
  for (const json& row : {json(900), json(-1), json("0"), json(), json(1e300)})
    EXPECT_NE(piece(1, row).value("why", ""), "") << row;
  EXPECT_NE(piece(2, 0).value("why", ""), "");
  EXPECT_NE(piece("1", 0).value("why", ""), "");
}

TEST_F(ImagesTest, ShotsAreForgotten) {
  for (int i = 0; i < 5; ++i) shoot(), frame();
  EXPECT_NE(piece(1, 0).value("why", ""), "") << "four are kept";
  EXPECT_EQ(piece(2, 0).count("value"), 1u);
  pass(9), piece(2, 0), pass(2);
  EXPECT_EQ(piece(2, 0).count("value"), 1u);
  EXPECT_NE(piece(5, 0).value("why", ""), "");
  pass(11);
  EXPECT_NE(piece(2, 0).value("why", ""), "");
  EXPECT_GT(images.nextDue(now), now + 1e9);
}

TEST_F(ImagesTest, ShotsAreChecked) {
  shoot({{"width", 3}});
  EXPECT_NE(answers.back().value("why", ""), "");
  for (size_t i = 0; i <= ImageRequests::kMaxWaiting; ++i) shoot();
  EXPECT_NE(answers.back().value("why", ""), "");
  EXPECT_EQ(answers.size(), 2u);
}

TEST_F(ImagesTest, ThumbnailsComeAtTheirPace) {
  frame();
  images.observe({true, 16, 0.5}, now);
  for (int i = 0; i < 300; ++i) ahead += 0.01, frame(64, 32);
  EXPECT_GE(thumbnails(), 6u);
  EXPECT_LE(thumbnails(), 7u);
  EXPECT_EQ(events[0]["width"], 16);
  EXPECT_EQ(events[0]["height"], 8);
  EXPECT_EQ(fromBase64(events[0]["pixels"].get<std::string>())->size(), 3u * 16 * 8);
  slow = true;
  for (int i = 0; i < 300; ++i) ahead += 0.01, frame();
  EXPECT_LE(thumbnails(), 7u) << "the hub reads slowly";
  images.observe({}, now);
  slow = false;
  for (int i = 0; i < 300; ++i) ahead += 0.01, frame();
  EXPECT_LE(thumbnails(), 7u);
  EXPECT_EQ(program.wanted, Wanted::none);
}

TEST_F(ImagesTest, TheLastFrameGetsAThumbnail) {
  frame(), pass(1);
  images.observe({true, 16, 0.5}, now);
  pass(0.01);
  EXPECT_EQ(program.woken, 1) << "for the first one";
  ahead = now - nowSeconds();
  frame();
  EXPECT_EQ(thumbnails(), 1u);
  pass(5), pass(5);
  EXPECT_EQ(program.woken, 1);
  ahead = now - nowSeconds();
  frame(), ahead += 0.01, frame();  // one thumbnail for two frames
  EXPECT_EQ(thumbnails(), 2u);
  pass(0.1);
  EXPECT_EQ(program.woken, 1) << "it is not time";
  pass(0.5);
  EXPECT_EQ(program.woken, 2);
  EXPECT_EQ(program.wanted, Wanted::next);
  frame();
  EXPECT_EQ(thumbnails(), 3u);
}

TEST_F(ImagesTest, RequestsToDrawEnd) {
  images.observe({true, 16, 0.05}, now);
  for (int i = 0; i < 100; ++i) {  // two frames for each request
    const int before = program.woken;
    pass(0.1), ahead = now - nowSeconds();
    if (program.woken > before) frame(), ahead += 0.001, frame();
  }
  EXPECT_LE(program.woken, ImageRequests::kMaxDrawRequests + 10 / ImageRequests::kRarely) << "in 10 s";
  const int before = program.woken;
  frame(), ahead += 0.001, frame(), pass(0.2);
  EXPECT_EQ(program.woken, before + 1) << "frames of its own";
  for (int i = 0; i < 30; ++i) pass(0.1);
  EXPECT_EQ(program.woken, before + 1) << "it does not draw";
  for (int i = 0; i < 30; ++i) pass(0.1);
  EXPECT_EQ(program.woken, before + 2) << "the request may have been lost";
}

}  // namespace
}  // namespace gluray::control

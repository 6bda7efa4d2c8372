// Every scene, traced from what another process reads: the same image to the bit.
#include "cluster/stream/snapshot_decoder.h"
#include "cluster/stream/snapshot_encoder.h"
#include "frame/tracing/renderer.h"
#include "intercept/present/tracing_presenter.h"
#include "scenes/scene.h"
#include "tests/reference/drawn_scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::test {
namespace {

/// Traces what arrives at the other end of a stream, with a renderer of its own.
class FarRenderer {
 public:
  bool render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error) {
    const cluster::EncodedSnapshot sent = encoder_.encode(snapshot);
    for (const cluster::ArraySource& array : sent.arrays)
      if (!arrays_.contains(array.name)) arrays_[array.name] = cluster::makeArray(array);
    try {
      const scene::SnapshotPtr received = decoder_.decode(sent.message);
      ++count;
      return renderer_.render(*received, image, cost, error);
    } catch (const cluster::Malformed& malformed) {
      ADD_FAILURE() << malformed.what();
      return false;
    }
  }
  int count = 0;

 private:
  cluster::SnapshotEncoder encoder_;
  std::unordered_map<Hash128, cluster::Array> arrays_;
  cluster::SnapshotDecoder decoder_{[this](const Hash128& name) {
    const auto known = arrays_.find(name);
    return known == arrays_.end() ? cluster::Array{} : known->second;
  }};
  frame::Renderer renderer_;
};

class StreamTest : public testing::TestWithParam<const scenes::Scene*> {
 protected:
  static DrawnImage drawn(TracedContext& context) {
    GetParam()->draw(context.gl(), kSceneWidth, kSceneHeight);
    return context.read();
  }
  static void expectSameImage(const Settings& settings) {
    TracedContext ours({kSceneWidth, kSceneHeight}, settings);
    const DrawnImage expected = drawn(ours);
    FarRenderer far;
    frame::Tracer tracer;
    tracer.trace = [&](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                       std::string& error) { return far.render(snapshot, image, cost, error); };
    TracedContext theirs({kSceneWidth, kSceneHeight}, settings,
                         std::make_unique<present::TracingPresenter>(tracer));
    const DrawnImage got = drawn(theirs);
    EXPECT_TRUE(far.count > 0 || !GetParam()->traced);
    EXPECT_TRUE(expected == got) << compare(expected, got, {0, 0, 0, "none"}).text;
    if (!(expected == got)) writeFailure(TEST_OUTPUT, GetParam()->name, expected, got);
  }
};

TEST_P(StreamTest, LooksTheSame) { expectSameImage(TracedContext::vertexShading()); }

class LitStreamTest : public StreamTest {};

TEST_P(LitStreamTest, LooksTheSame) {
  Settings settings = TracedContext::tracing();
  settings.ao.enabled = settings.shadows.enabled = true;
  settings.ground.kind = GroundKind::catcher;
  settings.lights.rig = LightRig::threePoint;
  expectSameImage(settings);
}

/// Every so many-th scene.
std::vector<const scenes::Scene*> some(size_t step) {
  std::vector<const scenes::Scene*> all = pointers(scenes::scenes()), chosen;
  for (size_t i = 0; i < all.size(); i += step) chosen.push_back(all[i]);
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(Scenes, StreamTest, testing::ValuesIn(pointers(scenes::scenes())), sceneNameOf);
INSTANTIATE_TEST_SUITE_P(SomeScenes, LitStreamTest, testing::ValuesIn(some(15)), sceneNameOf);
INSTANTIATE_TEST_SUITE_P(MoreCases, LitStreamTest, testing::ValuesIn(pointers(scenes::scenes())),
                         sceneNameOf);

}  // namespace
}  // namespace gluray::test

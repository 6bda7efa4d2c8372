// Matrices that files cannot hold.
#include "saved/testing/test_export.h"

namespace gluray::saved {
namespace {

using test::exported;

TEST(GlbWorlds, SurfacesWithoutAPlaceAreLeftOut) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.instances.push_back(s.instances[0]);
  s.instances[0].eyeFromObject[0] = glm::dvec4(0);
  s.eyeFromWorld = s.instances[0].eyeFromObject;
  std::vector<std::string> notes;
  const test::GlbFile file = exported(s, &notes);
  EXPECT_EQ(file.meshNodes().size(), 1u);
  EXPECT_EQ(file.matrixOf(file.meshNodes()[0]), glm::dmat4(1));
  EXPECT_EQ(notes,
            std::vector<std::string>{"surfaces without a place, whose matrix has no inverse, were left out"});
}

TEST(GlbWorlds, SurfacesBeyondTheRangeOfNumbersAreLeftOut) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.instances.push_back(s.instances[0]);
  s.instances[1].eyeFromObject[0][0] = 1e300, s.instances[1].eyeFromObject[1][0] = 1e300;  // sheared, too
  s.instances[1].eyeFromObject[1][1] = 1e-150;
  std::vector<std::string> notes;
  EXPECT_EQ(exported(s, &notes).meshNodes().size(), 1u);
  EXPECT_EQ(notes.size(), 1u);
}

}  // namespace
}  // namespace gluray::saved

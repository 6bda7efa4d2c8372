// Which calls CurrentValues makes, by a fake OpenGL that counts them.
#include "gl/capture/current_values.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

struct SentValues {
  int colors = 0, normals = 0;  // sent
  int queries = 0;
  bool operator==(const SentValues&) const = default;
};
SentValues g_sentValues;
void PrintTo(const SentValues& c, std::ostream* out) {
  *out << c.colors << " colours, " << c.normals << " normals, " << c.queries << " queries";
}

RealGl sentValuesTable() {
  RealGl real;
  loadRealGl(
      real, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  real.Color4fv = [](const GLfloat*) { ++g_sentValues.colors; };
  real.Normal3fv = [](const GLfloat*) { ++g_sentValues.normals; };
  real.GetMaterialfv = [](GLenum, GLenum, GLfloat*) { ++g_sentValues.queries; };
  real.GetFloatv = [](GLenum, GLfloat*) { ++g_sentValues.queries; };
  return real;
}

constexpr float kStoredColor[4] = {1, 0, 0, 1}, kStoredNormal[4] = {0, 1, 0, 0};

class CurrentValuesTest : public ::testing::Test {
 protected:
  void SetUp() override { g_sentValues = {}; }
  RealGl real_ = sentValuesTable();
  CurrentValues current_;
};

TEST_F(CurrentValuesTest, ADrawStoresWhatIsHeldBack) {
  current_.drawn(real_);
  EXPECT_EQ(g_sentValues, SentValues{});
  current_.set(real_, kColor, kStoredColor);
  current_.drawn(real_);
  EXPECT_EQ(g_sentValues, (SentValues{.colors = 1, .queries = 1}));
  EXPECT_TRUE(current_.held().due);
  current_.stateChanges();
  current_.drawn(real_);
  EXPECT_EQ(g_sentValues, (SentValues{.colors = 1, .queries = 1}));
}

TEST_F(CurrentValuesTest, ARunSendsWhatItChanges) {
  EXPECT_FALSE(current_.keepChanged(kColor, current_[kColor]));
  current_.sendRun(real_, 0);
  EXPECT_EQ(g_sentValues, SentValues{});
  EXPECT_FALSE(current_.holdsAny());
  EXPECT_TRUE(current_.keepChanged(kNormal, kStoredNormal));
  current_.sendRun(real_, bit(kNormal));
  EXPECT_EQ(g_sentValues, (SentValues{.normals = 1, .queries = 1}));
  EXPECT_TRUE(current_.held().due && !current_.held().pending);
}

TEST_F(CurrentValuesTest, ARunStoresValuesThatWereSetBeforeIt) {
  current_.set(real_, kColor, kStoredColor);
  current_.sendRun(real_, 0);
  EXPECT_EQ(g_sentValues, (SentValues{.colors = 1, .queries = 1}));
  // Without a change of state in between, the real OpenGL would let go of both: they are sent again.
  current_.keep(kNormal, kStoredNormal);
  current_.sendRun(real_, bit(kNormal));
  EXPECT_EQ(g_sentValues, (SentValues{.colors = 2, .normals = 1, .queries = 3}));
  EXPECT_EQ(current_.held().slots, bit(kColor) | bit(kNormal));
}

TEST_F(CurrentValuesTest, DrawsOfARunStoreValuesTogether) {
  for (int i = 0; i < 3; ++i) current_.setLater(kColor, kStoredColor), current_.drawnLater(real_);
  EXPECT_EQ(g_sentValues, SentValues{});
  current_.sendLater(real_);
  EXPECT_GT(g_sentValues.colors, 0);
  EXPECT_LE(g_sentValues.queries, 4);
}

}  // namespace
}  // namespace gluray::gl

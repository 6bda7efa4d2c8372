// The triangles of strips, fans and restarted primitives.
#include "gl/arrays/assembly.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Numbers = std::vector<uint32_t>;

TEST(Assembly, StripsKeepTheirSideAndTheirProvokingVertex) {
  const Numbers strip{10, 11, 12, 13, 14};
  EXPECT_EQ((Assembly{GL_TRIANGLE_STRIP}.corners(strip)), (Numbers{10, 11, 12, 12, 11, 13, 12, 13, 14}));
  EXPECT_EQ((Assembly{GL_TRIANGLE_STRIP, true}.corners(strip)),
            (Numbers{10, 11, 12, 11, 13, 12, 12, 13, 14}));
  EXPECT_EQ((Assembly{GL_TRIANGLE_FAN}.corners(strip)), (Numbers{10, 11, 12, 10, 12, 13, 10, 13, 14}));
  EXPECT_EQ((Assembly{GL_TRIANGLE_FAN, true}.corners(strip)), (Numbers{11, 12, 10, 12, 13, 10, 13, 14, 10}));
}

TEST(Assembly, UnfinishedPrimitivesAreDropped) {
  EXPECT_EQ((Assembly{GL_TRIANGLES}.corners({1, 2, 3, 4, 5})), (Numbers{1, 2, 3}));
  EXPECT_EQ((Assembly{GL_QUADS}.corners({1, 2, 3, 4, 5})), (Numbers{1, 2, 3, 4}));
  EXPECT_TRUE((Assembly{GL_TRIANGLE_STRIP}.corners({1, 2})).empty());
}

TEST(Assembly, RestartBeginsAnew) {
  const Numbers numbers{9, 1, 2, 9, 3, 4, 5, 6, 9, 9, 7, 8, 1, 9};
  EXPECT_EQ((Assembly{GL_TRIANGLES, false, 9}.corners(numbers)), (Numbers{3, 4, 5, 7, 8, 1}));
  EXPECT_EQ((Assembly{GL_QUADS, false, 9}.corners(numbers)), (Numbers{3, 4, 5, 6}));
  EXPECT_EQ((Assembly{GL_TRIANGLE_STRIP, false, 9}.corners(numbers)), (Numbers{3, 4, 5, 5, 4, 6, 7, 8, 1}));
  EXPECT_EQ((Assembly{GL_TRIANGLE_FAN, false, 9}.corners(numbers)), (Numbers{3, 4, 5, 3, 5, 6, 7, 8, 1}));
}

TEST(Assembly, OtherPrimitivesHaveOtherNames) {
  const Hash128 name{1, 2};
  EXPECT_EQ((Assembly{GL_TRIANGLES, true}.added(name)), name);
  EXPECT_EQ((Assembly{GL_TRIANGLE_STRIP}.added(name)), name);
  const Hash128 first = Assembly{GL_TRIANGLE_STRIP, true}.added(name),
                restarted = Assembly{GL_TRIANGLE_STRIP, false, 0}.added(name);
  EXPECT_FALSE(first == name || restarted == name || first == restarted);
  EXPECT_FALSE(restarted == (Assembly{GL_TRIANGLE_STRIP, false, 1}.added(name)));
}

}  // namespace
}  // namespace gluray::gl

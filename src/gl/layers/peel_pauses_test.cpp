#include "gl/layers/peel_pauses.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

PeelPauses::Pass passInto(GLuint framebuffer, bool label = false) {
  return {.framebuffer = framebuffer, .viewport = {0, 0, 4, 4}, .mode = GL_TRIANGLES, .label = label};
}

/// Fails as often as it is begun, over so many passes of `draws` draws. Returns how often it was begun.
int begun(PeelPauses& pauses, const PeelPauses::Pass& first, int passes, int draws, bool labels) {
  int count = 0;
  for (int i = 0; i < passes; ++i) {
    bool begins = false;
    for (int k = 0; k < draws && !begins; ++k) begins = pauses.mayBegin(first, 1);
    pauses.endPass();
    if (begins) pauses.failed(first, labels), ++count;
  }
  return count;
}

TEST(PeelPauses, GrowByPassesWhateverTheirDraws) {
  for (const int draws : {1, 30}) {
    PeelPauses pauses;
    // Begun in passes 1, 2, 4, 7, 12, 21, 38.
    EXPECT_EQ(begun(pauses, passInto(1), 40, draws, false), 7) << draws;
  }
}

TEST(PeelPauses, ArePerKindOfPass) {
  PeelPauses pauses;
  begun(pauses, passInto(1, true), 40, 5, true);
  EXPECT_FALSE(pauses.mayBegin(passInto(1, true), 1));
  pauses.endPass();
  EXPECT_TRUE(pauses.mayBegin(passInto(1), 1));
  EXPECT_TRUE(pauses.mayBegin(passInto(2, true), 1));
  pauses.succeeded(passInto(2, true));
  EXPECT_FALSE(pauses.mayBegin(passInto(1, true), 1));
}

TEST(PeelPauses, OfLabelsEndWhereASurfaceIsAmongThem) {
  for (const bool labels : {false, true}) {
    PeelPauses pauses;
    begun(pauses, passInto(1, true), 40, 5, labels);
    EXPECT_FALSE(pauses.mayBegin(passInto(1, true), 1));
    EXPECT_FALSE(pauses.mayBegin(passInto(1), 1));  // the second draw of that pass
    pauses.endPass();
    EXPECT_EQ(pauses.mayBegin(passInto(1, true), 1), labels);
  }
}

TEST(PeelPauses, EndWithSuccess) {
  PeelPauses pauses;
  begun(pauses, passInto(1), 40, 1, false);
  pauses.succeeded(passInto(1));
  EXPECT_EQ(begun(pauses, passInto(1), 2, 1, false), 2);
}

TEST(PeelPauses, APassEndsWithItsFrame) {
  PeelPauses pauses;
  pauses.failed(passInto(1), false);
  pauses.failed(passInto(1), false);
  EXPECT_FALSE(pauses.mayBegin(passInto(1), 1));
  EXPECT_FALSE(pauses.mayBegin(passInto(1), 1));
  EXPECT_TRUE(pauses.mayBegin(passInto(1), 2));
}

TEST(PeelPauses, AreKeptForAFewPasses) {
  PeelPauses pauses;
  for (GLuint framebuffer = 1; framebuffer < 20; ++framebuffer)
    begun(pauses, passInto(framebuffer), 2, 1, false);
  EXPECT_TRUE(pauses.mayBegin(passInto(1), 1));
  EXPECT_FALSE(pauses.mayBegin(passInto(19), 1));
}

}  // namespace
}  // namespace gluray::gl

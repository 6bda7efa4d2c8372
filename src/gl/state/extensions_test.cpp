#include "gl/state/extensions.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const GLubyte* text(const char* s) { return reinterpret_cast<const GLubyte*>(s); }

TEST(Extensions, ParsesVersionStrings) {
  EXPECT_EQ(parseVersion(text("4.5 (Compatibility Profile) Mesa 22.3.6"), 10), 45);
  EXPECT_EQ(parseVersion(text("4.50"), 100), 450);
  EXPECT_EQ(parseVersion(nullptr, 10), 0);
}

TEST(Extensions, ParsesMesaVersions) {
  EXPECT_EQ(mesaVersionOf(text("4.5 (Compatibility Profile) Mesa 22.3.6")), 2203);
  EXPECT_EQ(mesaVersionOf(text("4.5 (Compatibility Profile) Mesa 25.0.7-2+deb13u1")), 2500);
  EXPECT_EQ(mesaVersionOf(text("3.1 Mesa 25.2.0-devel (git-0123456789)")), 2502);
  EXPECT_EQ(mesaVersionOf(text("4.6.0 NVIDIA 535.183.01")), 0);
  EXPECT_EQ(mesaVersionOf(text("4.5 Mesa")), 0);
  EXPECT_EQ(mesaVersionOf(nullptr), 0);
}

}  // namespace
}  // namespace gluray::gl

#include "gl/real/extensions.h"

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

TEST(Extensions, OnlyKnownRenderersFilterInBytes) {
  const char* const renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  const char* const version = "4.5 (Compatibility Profile) Mesa 22.3.6";
  const auto filters = [](const char* name, const char* mesa, const char* tuning) {
    return filtersBytes(text(name), text(mesa), tuning);
  };
#ifdef __x86_64__
  EXPECT_TRUE(filters(renderer, version, nullptr));
  EXPECT_TRUE(filters("llvmpipe (LLVM 19.1.7, 128 bits)", "4.5 Mesa 25.0.7-2", "brilinear"));
#endif
  EXPECT_FALSE(filters(renderer, version, "rho_approx,no_aos_sampling"));
  EXPECT_FALSE(filters("llvmpipe (LLVM 15.0.6, 512 bits)", version, nullptr));
  EXPECT_FALSE(filters("softpipe", version, nullptr));
  EXPECT_FALSE(filters(renderer, "4.5 Mesa 21.2.6", nullptr));
  EXPECT_FALSE(filters(renderer, "4.5 Mesa 26.0.0", nullptr));
  EXPECT_FALSE(filters(nullptr, nullptr, nullptr));
}

TEST(Extensions, SomeMesasMisnumberPrimitives) {
  const char* const renderer = "llvmpipe (LLVM 21.1.0, 256 bits)";
  const auto misnumbers = [](const char* name, const char* version) {
    return misnumbersPrimitives(text(name), text(version));
  };
  EXPECT_TRUE(misnumbers(renderer, "4.5 (Core Profile) Mesa 25.3.6-1"));
  EXPECT_TRUE(misnumbers(renderer, "4.5 (Core Profile) Mesa 26.0.0-devel (git-1234)"));
  EXPECT_TRUE(misnumbers(renderer, "4.5 (Core Profile) Mesa 26.1.2"));
  EXPECT_FALSE(misnumbers(renderer, "4.5 (Core Profile) Mesa 25.3.5"));
  EXPECT_FALSE(misnumbers(renderer, "4.5 (Core Profile) Mesa 26.2.0"));
  EXPECT_FALSE(misnumbers(renderer, "4.5 (Core Profile) Mesa 22.3.6"));
  EXPECT_FALSE(misnumbers("AMD Radeon RX 7900 XTX (radeonsi)", "4.6 (Core Profile) Mesa 26.0.0"));
  EXPECT_FALSE(misnumbers(renderer, "4.5 Mesa"));
  EXPECT_FALSE(misnumbers(nullptr, nullptr));
}

const char* const kNames[] = {"GL_EXT_abc", "GL_ARB_b", "GL_EXT_ab"};
int g_asked = 0;
void APIENTRY count(GLenum, GLint* value) { *value = 3; }
const GLubyte* APIENTRY nth(GLenum, GLuint i) { return ++g_asked, text(kNames[i]); }
const GLubyte* APIENTRY all(GLenum) { return text(" GL_EXT_abc  GL_ARB_b GL_EXT_ab "); }

TEST(Extensions, FindsWholeNames) {
  RealGl real{};
  real.GetIntegerv = count, real.GetStringi = nth, real.GetString = all;
  for (const int version : {21, 45}) {
    const Extensions extensions(real, version);
    for (const char* name : kNames) EXPECT_TRUE(extensions.has(name)) << version << name;
    for (const char* name : {"", "GL_EXT_a", "GL_EXT_abcd", "GL_ARB"})
      EXPECT_FALSE(extensions.has(name)) << version << name;
  }
  EXPECT_EQ(g_asked, 3);  // each name once
  EXPECT_TRUE(hasExtension(real, 45, "GL_ARB_b"));
}

const GLubyte* APIENTRY packedOnly(GLenum) { return text("GL_ARB_b GL_ARB_vertex_type_10f_11f_11f_rev"); }

TEST(Extensions, PackedFloatsComeWithTheirExtensionOrWith44) {
  RealGl real{};
  real.GetIntegerv = count, real.GetStringi = nth, real.GetString = all;
  EXPECT_FALSE(takesPackedFloats(real, 21));
  EXPECT_FALSE(takesPackedFloats(real, 43));
  EXPECT_TRUE(takesPackedFloats(real, 44));
  real.GetString = packedOnly;
  EXPECT_TRUE(takesPackedFloats(real, 21));
}

}  // namespace
}  // namespace gluray::gl

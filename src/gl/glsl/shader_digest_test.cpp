#include "gl/glsl/shader_digest.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const char* const kText = "#version 110\nuniform float a;\nvoid main() { gl_FragColor = vec4(a * 0.50); }\n";

TEST(ShaderDigests, IgnoreCommentsAndSpaces) {
  EXPECT_EQ(digestOf(kText), digestOf("// another text\n#version 110\nuniform   float a; /* b */\n"
                                      "void main()\n{\n  gl_FragColor = vec4(a * .5);\n}\n"));
}

TEST(ShaderDigests, SeeEverythingElse) {
  for (const char* other :
       {"#version 120\nuniform float a;\nvoid main() { gl_FragColor = vec4(a * 0.5); }\n",
        "#version 110\nuniform int a;\nvoid main() { gl_FragColor = vec4(a * 0.5); }\n",
        "#version 110\nuniform float a;\nvoid main() { gl_FragColor = vec4(a * 0.6); }\n",
        "#version 110\nuniform float a;\n#if 0\nvoid main() { gl_FragColor = vec4(a * 0.5); }\n#endif\n",
        "#version 110\nuniform float a;\nvoid main() { gl_FragColor = vec4(0.5 * a); }\n", ""})
    EXPECT_NE(digestOf(kText), digestOf(other)) << other;
}

TEST(ShaderDigests, AreTexts) {
  const Hash128 digest = digestOf(kText);
  EXPECT_EQ(digestIn(textOf(digest)), digest);
  EXPECT_EQ(textOf({1, 0xab}), "00000000000000ab0000000000000001");
  for (const char* wrong :
       {"", "12", "0000000000000000000000000000000x", "000000000000000000000000000000000"})
    EXPECT_FALSE(digestIn(wrong)) << wrong;
}

}  // namespace
}  // namespace gluray::gl

#include "tests/fuzz/scenes/state.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::fuzz {

bool writeToggle(Writer& w, uint32_t capability, uint32_t percent) {
  const bool on = w.dice.chance(percent);
  if (on)
    WRITE(w, Enable, GLenum{capability});
  else
    WRITE(w, Disable, GLenum{capability});
  return on;
}

void writeCamera(Writer& w, int size) {
  Dice& dice = w.dice;
  if (dice.chance(85))
    WRITE(w, Viewport, 0, 0, GLsizei{size}, GLsizei{size});
  else
    WRITE(w, Viewport, GLint(dice.below(20)), 7, size - 24, size - 20);
  if (dice.chance(10)) WRITE(w, DepthRange, GLdouble(dice.real(0, 0.3f)), 0.8);
  WRITE(w, MatrixMode, GLenum{GL_PROJECTION});
  WRITE(w, LoadIdentity);
  if (dice.chance(30))
    WRITE(w, Ortho, -3.0, 3.0, -3.0, 3.0, 1.0, 12.0);
  else
    WRITE(w, Frustum, -0.5, 0.5, -0.5, 0.5, 1.0, 2 + GLdouble(dice.real(6, 60)));
  WRITE(w, MatrixMode, GLenum{GL_MODELVIEW});
  WRITE(w, LoadIdentity);
  WRITE(w, Translatef, 0.0f, 0.0f, -6.0f);
  const float angle = dice.real(-60, 60), x = dice.real(-1, 1);
  WRITE(w, Rotatef, angle, x, 1.0f, 0.1f);
}

void writeTexture(Writer& w, uint32_t name) {
  constexpr uint32_t kTexels = 8;
  Dice& dice = w.dice;
  std::array<GLubyte, 4 * kTexels * kTexels> texels;
  for (GLubyte& t : texels) t = static_cast<GLubyte>(dice.below(256));
  const GLenum format = dice.pick({GL_RGBA, GL_RGBA, GL_LUMINANCE_ALPHA});
  const auto internal = static_cast<GLint>(dice.pick({GL_RGBA, GL_RGB, GL_LUMINANCE}));
  w.call("texture", [=](Gl gl, Answers&) {
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, kTexels, kTexels, 0, format, GL_UNSIGNED_BYTE, texels.data());
  });
  const auto filter = static_cast<GLint>(dice.pick({GL_NEAREST, GL_LINEAR}));
  constexpr GLenum kTarget = GL_TEXTURE_2D;
  WRITE(w, TexParameteri, kTarget, GLenum{GL_TEXTURE_MIN_FILTER}, filter);
  WRITE(w, TexParameteri, kTarget, GLenum{GL_TEXTURE_MAG_FILTER}, filter);
  WRITE(w, TexParameteri, kTarget, GLenum{GL_TEXTURE_WRAP_S},
        static_cast<GLint>(dice.pick({GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT})));
}

void writeLights(Writer& w) {
  Dice& dice = w.dice;
  writeToggle(w, GL_LIGHTING, 75);
  for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 3; ++light) {
    writeToggle(w, light, light == GL_LIGHT0 ? 90 : 30);
    std::array<GLfloat, 4> position{};
    for (size_t i = 0; i < 2; ++i) position[i] = dice.real(-4, 4);
    position[2] = dice.real(0, 4), position[3] = dice.chance(50) ? 1.0f : 0.0f;
    WRITE(w, Lightfv, light, GLenum{GL_POSITION}, position);
    WRITE(w, Lightfv, light, GLenum{GL_DIFFUSE}, dice.color());
    WRITE(w, Lightfv, light, GLenum{GL_SPECULAR}, dice.color());
    WRITE(w, Lightf, light, GLenum{GL_SPOT_CUTOFF}, dice.chance(20) ? dice.real(20, 60) : 180.0f);
    const float x = dice.real(-1, 1), y = dice.real(-1, 1);
    WRITE(w, Lightfv, light, GLenum{GL_SPOT_DIRECTION}, std::array<GLfloat, 3>{x, y, -1});
    WRITE(w, Lightf, light, GLenum{GL_LINEAR_ATTENUATION}, dice.chance(20) ? dice.real(0, 0.3f) : 0.0f);
  }
  WRITE(w, LightModeli, GLenum{GL_LIGHT_MODEL_TWO_SIDE}, GLint{w.twoSided && dice.chance(60)});
  WRITE(w, LightModeli, GLenum{GL_LIGHT_MODEL_LOCAL_VIEWER}, GLint{dice.chance(30)});
  WRITE(w, LightModeli, GLenum{GL_LIGHT_MODEL_COLOR_CONTROL},
        static_cast<GLint>(dice.pick({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR})));
  if (dice.chance(20)) WRITE(w, LightModelfv, GLenum{GL_LIGHT_MODEL_AMBIENT}, dice.color());
}

void askColor(Writer& w) {
  w.call("glGetFloatv(GL_CURRENT_COLOR)", [](Gl gl, Answers&) {
    GLfloat asked[4];
    gl.GetFloatv(GL_CURRENT_COLOR, asked);
  });
}

void writeColorMaterial(Writer& w, Asks asks) {
  const GLenum face = w.face();
  if (asks == Asks::color) askColor(w);
  WRITE(w, ColorMaterial, GLenum{face},
        w.dice.pick({GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT}));
  if (asks == Asks::color) w.join(2);
  if (w.dice.chance(70)) writeToggle(w, GL_COLOR_MATERIAL, 65);
}

void writeClipPlanes(Writer& w) {
  for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 3; ++plane) {
    std::array<GLdouble, 4> equation = {0, 1, 0, 0};
    equation[0] = w.dice.real(-1, 1), equation[2] = w.dice.real(-1, 1), equation[3] = w.dice.real(0, 1);
    WRITE(w, ClipPlane, plane, equation);
  }
}

void writeSurface(Writer& w) {
  Dice& dice = w.dice;
  if (dice.chance(60)) WRITE(w, ShadeModel, dice.chance(75) ? GLenum{GL_SMOOTH} : GLenum{GL_FLAT});
  if (dice.chance(60)) writeToggle(w, GL_NORMALIZE, 70);
  if (dice.chance(20)) writeToggle(w, GL_RESCALE_NORMAL, 50);
  if (dice.chance(60)) {
    writeToggle(w, GL_CULL_FACE, 30);
    WRITE(w, CullFace, dice.pick({GL_FRONT, GL_BACK, GL_BACK}));
    WRITE(w, FrontFace, dice.chance(80) ? GLenum{GL_CCW} : GLenum{GL_CW});
  }
  if (dice.chance(60)) {
    writeToggle(w, GL_TEXTURE_2D, 35);
    WRITE(w, BindTexture, GLenum{GL_TEXTURE_2D}, GLuint{1 + dice.below(2)});
    WRITE(w, TexEnvi, GLenum{GL_TEXTURE_ENV}, GLenum{GL_TEXTURE_ENV_MODE},
          static_cast<GLint>(dice.pick({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD})));
  }
  if (dice.chance(50)) {
    writeToggle(w, GL_POLYGON_OFFSET_FILL, 25);
    for (const GLenum offset : {GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
      if (writeToggle(w, offset, 25)) w.offsetsLines = true;
    const float factor = dice.real(-2, 2), units = dice.real(-50, 50);
    WRITE(w, PolygonOffset, factor, units);
  }
  if (dice.chance(20)) {
    const GLenum face = dice.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK});
    WRITE(w, PolygonMode, face, dice.pick({GL_FILL, GL_LINE, GL_POINT, GL_FILL}));
  } else if (dice.chance(50)) {
    WRITE(w, PolygonMode, GLenum{GL_FRONT_AND_BACK}, GLenum{GL_FILL});
  }
  if (dice.chance(30)) {
    const size_t before = w.calls.size();
    writeToggle(w, GL_CLIP_PLANE0 + dice.below(3), 40);
    if (w.samePlace) w.calls.erase(w.calls.begin() + static_cast<ptrdiff_t>(before), w.calls.end());
  }
  if (dice.chance(15)) WRITE(w, LineWidth, dice.chance(50) ? 1.0f : dice.real(1, 4));
  if (dice.chance(15)) WRITE(w, PointSize, dice.chance(30) ? 1.0f : dice.real(1, 6));
}

void writeFragments(Writer& w) {
  Dice& dice = w.dice;
  writeToggle(w, GL_FOG, 20);
  WRITE(w, Fogi, GLenum{GL_FOG_MODE}, static_cast<GLint>(dice.pick({GL_LINEAR, GL_EXP, GL_EXP2})));
  WRITE(w, Fogf, GLenum{GL_FOG_DENSITY}, dice.real(0, 0.3f));
  WRITE(w, Fogf, GLenum{GL_FOG_START}, 3.0f);
  WRITE(w, Fogf, GLenum{GL_FOG_END}, dice.real(6, 12));
  if (dice.chance(50)) WRITE(w, Fogfv, GLenum{GL_FOG_COLOR}, dice.color());
  writeToggle(w, GL_ALPHA_TEST, 15);
  WRITE(w, AlphaFunc, dice.pick({GL_GREATER, GL_LESS, GL_GEQUAL}), 0.5f);
  writeToggle(w, GL_BLEND, 20);
  const GLenum source = dice.pick({GL_SRC_ALPHA, GL_ONE});
  WRITE(w, BlendFunc, source, dice.pick({GL_ONE_MINUS_SRC_ALPHA, GL_ONE}));
  WRITE(w, DepthFunc,
        dice.pick({GL_LESS, GL_LEQUAL, GL_LESS, GL_LEQUAL, GL_LEQUAL, GL_GREATER, GL_EQUAL, GL_ALWAYS,
                   GL_NOTEQUAL, GL_GEQUAL}));
  WRITE(w, DepthMask, static_cast<GLboolean>(dice.chance(90)));
  if (dice.chance(30)) writeToggle(w, GL_DEPTH_TEST, 85);
  writeToggle(w, GL_STENCIL_TEST, 15);
  WRITE(w, StencilFunc, dice.pick({GL_ALWAYS, GL_EQUAL, GL_NOTEQUAL}), 1, 0xffu);
  WRITE(w, StencilOp, GLenum{GL_KEEP}, GLenum{GL_KEEP}, dice.pick({GL_REPLACE, GL_INCR, GL_KEEP}));
  writeToggle(w, GL_SCISSOR_TEST, 10);
  WRITE(w, Scissor, 10, 20, 70, 60);
  std::array<bool, 4> mask;
  for (bool& m : mask) m = dice.chance(93);
  WRITE(w, ColorMask, GLboolean(mask[0]), GLboolean(mask[1]), GLboolean(mask[2]), GLboolean(mask[3]));
}

}  // namespace gluray::fuzz

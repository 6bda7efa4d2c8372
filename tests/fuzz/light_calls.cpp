#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

GLenum light(Player& p) { return p.pick({GL_LIGHT0, GL_LIGHT1, GL_LIGHT7}); }

const Op kLightOps[] = {
    {"Lightfv", 6,
     [](Player& p) {
       const GLenum which = light(p);
       const GLenum name = p.pick({GL_POSITION, GL_DIFFUSE, GL_AMBIENT, GL_SPECULAR, GL_SPOT_DIRECTION});
       p.gl.Lightfv(which, name, p.reals<4>().data());
     }},
    {"Lightf", 3,
     [](Player& p) {
       const GLenum which = light(p);
       const GLenum name =
           p.pick({GL_SPOT_CUTOFF, GL_SPOT_EXPONENT, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION});
       p.gl.Lightf(which, name, 90 * p.real());
     }},
    {"Lightiv", 1,
     [](Player& p) {
       const GLenum which = light(p), name = p.pick({GL_POSITION, GL_DIFFUSE});
       const GLint v[4] = {p.integer(), p.integer(), p.integer(), p.integer()};
       p.gl.Lightiv(which, name, v);
     }},
    {"LightModeli", 2,
     [](Player& p) {
       const GLenum name = p.pick({GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER});
       p.gl.LightModeli(name, p.flag());
     }},
    {"LightModelfv", 1,
     [](Player& p) { p.gl.LightModelfv(p.pick({GL_LIGHT_MODEL_AMBIENT}), p.reals<4>().data()); }},
    {"ColorMaterial", 3,
     [](Player& p) {
       const GLenum face = p.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
       p.gl.ColorMaterial(face,
                          p.pick({GL_AMBIENT_AND_DIFFUSE, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT}));
     }},
    {"ClipPlane", 2,
     [](Player& p) {
       const GLenum plane = p.pick({GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE5});
       const GLdouble equation[4] = {p.real(), p.real(), p.real(), p.real()};
       p.gl.ClipPlane(plane, equation);
     }},
};

std::array<GLdouble, 16> doubles(const std::array<float, 16>& values) {
  std::array<GLdouble, 16> result;
  for (size_t i = 0; i < 16; ++i) result[i] = values[i];
  return result;
}

const Op kMatrixOps[] = {
    {"MatrixMode", 8,
     [](Player& p) {
       p.gl.MatrixMode(p.pick({GL_MODELVIEW, GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
     }},
    {"LoadIdentity", 10, [](Player& p) { p.gl.LoadIdentity(); }},
    {"PushMatrix", 6, [](Player& p) { p.gl.PushMatrix(); }},
    {"PopMatrix", 6, [](Player& p) { p.gl.PopMatrix(); }},
    {"Translatef", 6,
     [](Player& p) {
       const auto v = p.reals<3>();
       p.gl.Translatef(v[0], v[1], v[2]);
     }},
    {"Translated", 1,
     [](Player& p) {
       const auto v = p.reals<3>();
       p.gl.Translated(v[0], v[1], v[2]);
     }},
    {"Rotatef", 6,
     [](Player& p) {
       const auto v = p.reals<4>();
       p.gl.Rotatef(180 * v[0], v[1], v[2], v[3]);
     }},
    {"Scalef", 4,
     [](Player& p) {
       const auto v = p.reals<3>();
       p.gl.Scalef(v[0], v[1], v[2]);
     }},
    {"LoadMatrixf", 1, [](Player& p) { p.gl.LoadMatrixf(p.reals<16>().data()); }},
    {"MultMatrixd", 1, [](Player& p) { p.gl.MultMatrixd(doubles(p.reals<16>()).data()); }},
    {"LoadTransposeMatrixd", 1, [](Player& p) { p.gl.LoadTransposeMatrixd(doubles(p.reals<16>()).data()); }},
    {"MultTransposeMatrixf", 1, [](Player& p) { p.gl.MultTransposeMatrixf(p.reals<16>().data()); }},
    {"Frustum", 2,
     [](Player& p) {
       const auto v = p.reals<6>();
       p.gl.Frustum(v[0] - 1, v[1] + 1, v[2] - 1, v[3] + 1, v[4] + 1.5, v[5] + 4);
     }},
    {"Ortho", 2,
     [](Player& p) {
       const auto v = p.reals<6>();
       p.gl.Ortho(v[0] - 1, v[1] + 1, v[2] - 1, v[3] + 1, v[4] - 1, v[5] + 1);
     }},
};

GLbitfield attributeBits(Player& p) {
  static constexpr GLbitfield kBits[] = {GL_ALL_ATTRIB_BITS,  GL_CURRENT_BIT,        GL_LIGHTING_BIT,
                                         GL_ENABLE_BIT,       GL_TRANSFORM_BIT,      GL_VIEWPORT_BIT,
                                         GL_TEXTURE_BIT,      GL_POLYGON_BIT,        GL_LIST_BIT,
                                         GL_DEPTH_BUFFER_BIT, GL_COLOR_BUFFER_BIT,   GL_FOG_BIT,
                                         GL_SCISSOR_BIT,      GL_EVAL_BIT,           GL_PIXEL_MODE_BIT,
                                         GL_HINT_BIT,         GL_STENCIL_BUFFER_BIT, GL_LINE_BIT};
  const GLbitfield one = kBits[p.below(std::size(kBits))];
  return p.chance(50) ? one : one | kBits[p.below(std::size(kBits))];
}

const Op kStackOps[] = {
    {"PushAttrib", 8, [](Player& p) { p.gl.PushAttrib(attributeBits(p)); }},
    {"PopAttrib", 8,
     [](Player& p) {
       float asked[4];
       if (!p.compiling && !p.insideBegin) p.gl.GetFloatv(GL_CURRENT_COLOR, asked);  // avoided.md
       p.gl.PopAttrib();
     }},
    {"PushClientAttrib", 3,
     [](Player& p) {
       p.gl.PushClientAttrib(p.pick({GL_CLIENT_PIXEL_STORE_BIT, GL_CLIENT_VERTEX_ARRAY_BIT, ~0u}));
     }},
    {"PopClientAttrib", 3, [](Player& p) { p.gl.PopClientAttrib(); }},
};

}  // namespace

Ops lightCalls() { return kLightOps; }
Ops matrixCalls() { return kMatrixOps; }
Ops stackCalls() { return kStackOps; }

}  // namespace gluray::fuzz

#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

GLenum capability(Player& p) {
  return p.pick({GL_LIGHTING,
                 GL_LIGHTING,
                 GL_LIGHT0,
                 GL_LIGHT1,
                 GL_LIGHT7,
                 GL_DEPTH_TEST,
                 GL_DEPTH_TEST,
                 GL_DEPTH_TEST,
                 GL_CULL_FACE,
                 GL_BLEND,
                 GL_ALPHA_TEST,
                 GL_STENCIL_TEST,
                 GL_SCISSOR_TEST,
                 GL_FOG,
                 GL_NORMALIZE,
                 GL_RESCALE_NORMAL,
                 GL_COLOR_MATERIAL,
                 GL_COLOR_MATERIAL,
                 GL_CLIP_PLANE0,
                 GL_CLIP_PLANE1,
                 GL_CLIP_PLANE5,
                 GL_TEXTURE_2D,
                 GL_TEXTURE_2D,
                 GL_TEXTURE_1D,
                 GL_TEXTURE_3D,
                 GL_POLYGON_OFFSET_FILL,
                 GL_LINE_STIPPLE,
                 GL_POLYGON_STIPPLE,
                 GL_DITHER,
                 GL_COLOR_LOGIC_OP,
                 GL_TEXTURE_GEN_S,
                 GL_TEXTURE_GEN_T,
                 GL_AUTO_NORMAL,
                 GL_MAP1_VERTEX_3,
                 GL_MAP2_VERTEX_3,
                 GL_MAP2_NORMAL,
                 GL_COLOR_SUM,
                 GL_MULTISAMPLE,
                 GL_LINE_SMOOTH,
                 GL_POINT_SMOOTH,
                 GL_TEXTURE_CUBE_MAP,
                 GL_PRIMITIVE_RESTART,
                 GL_POLYGON_OFFSET_LINE,
                 GL_VERTEX_PROGRAM_TWO_SIDE});
}

GLenum comparison(Player& p) {
  return p.pick(
      {GL_LESS, GL_LESS, GL_LEQUAL, GL_ALWAYS, GL_NEVER, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_GEQUAL});
}
GLenum factor(Player& p) {
  return p.pick({GL_ONE, GL_ZERO, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_COLOR, GL_CONSTANT_COLOR,
                 GL_SRC_ALPHA_SATURATE});
}
GLenum face(Player& p) { return p.pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}); }
GLenum stencilOp(Player& p) {
  return p.pick({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP});
}

const Op kStateOps[] = {
    {"Enable", 20, [](Player& p) { p.gl.Enable(capability(p)); }},
    {"Disable", 20, [](Player& p) { p.gl.Disable(capability(p)); }},
    {"ShadeModel", 4,
     [](Player& p) {
       p.gl.ShadeModel(p.pick({GL_FLAT, GL_SMOOTH}));
     }},
    {"CullFace", 2, [](Player& p) { p.gl.CullFace(face(p)); }},
    {"FrontFace", 3,
     [](Player& p) {
       p.gl.FrontFace(p.pick({GL_CW, GL_CCW}));
     }},
    {"PolygonMode", 2,
     [](Player& p) {
       const GLenum side = face(p), mode = p.pick({GL_FILL, GL_FILL, GL_LINE, GL_POINT});
       p.gl.PolygonMode(side, mode);
     }},
    {"PolygonOffset", 2,
     [](Player& p) {
       const float slope = p.real(), units = p.real();
       p.gl.PolygonOffset(slope, units);
     }},
    {"DepthFunc", 4, [](Player& p) { p.gl.DepthFunc(comparison(p)); }},
    {"DepthMask", 3, [](Player& p) { p.gl.DepthMask(p.flag()); }},
    {"DepthRange", 2,
     [](Player& p) {
       const double first = p.real(), second = p.real();
       p.gl.DepthRange(first, second);
     }},
    {"ColorMask", 2,
     [](Player& p) {
       const GLboolean r = p.flag(), g = p.flag(), b = p.flag(), a = p.flag();
       p.gl.ColorMask(r, g, b, a);
     }},
    {"BlendFunc", 2,
     [](Player& p) {
       const GLenum source = factor(p), target = factor(p);
       p.gl.BlendFunc(source, target);
     }},
    {"BlendFuncSeparate", 1,
     [](Player& p) {
       const GLenum a = factor(p), b = factor(p), c = factor(p), d = factor(p);
       p.gl.BlendFuncSeparate(a, b, c, d);
     }},
    {"BlendEquation", 1,
     [](Player& p) {
       p.gl.BlendEquation(p.pick({GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_MIN, GL_MAX}));
     }},
    {"BlendColor", 1,
     [](Player& p) {
       const auto c = p.reals<4>();
       p.gl.BlendColor(c[0], c[1], c[2], c[3]);
     }},
    {"AlphaFunc", 2,
     [](Player& p) {
       const GLenum function = comparison(p);
       p.gl.AlphaFunc(function, p.real());
     }},
    {"StencilFunc", 1,
     [](Player& p) {
       const GLenum function = comparison(p);
       const GLint reference = p.integer();
       p.gl.StencilFunc(function, reference, p.bits());
     }},
    {"StencilOp", 1,
     [](Player& p) {
       const GLenum a = stencilOp(p), b = stencilOp(p), c = stencilOp(p);
       p.gl.StencilOp(a, b, c);
     }},
    {"StencilOpSeparate", 1,
     [](Player& p) {
       const GLenum side = face(p), a = stencilOp(p), b = stencilOp(p), c = stencilOp(p);
       p.gl.StencilOpSeparate(side, a, b, c);
     }},
    {"StencilMask", 1, [](Player& p) { p.gl.StencilMask(p.bits()); }},
    {"LogicOp", 1,
     [](Player& p) {
       p.gl.LogicOp(p.pick({GL_COPY, GL_XOR, GL_AND, GL_NOOP, GL_INVERT}));
     }},
    {"Fogf", 2,
     [](Player& p) {
       const GLenum name = p.pick({GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END});
       p.gl.Fogf(name, p.real());
     }},
    {"Fogi", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_FOG_MODE, GL_FOG_COORD_SRC});
       p.gl.Fogi(name,
                 static_cast<GLint>(p.pick({GL_LINEAR, GL_EXP, GL_EXP2, GL_FRAGMENT_DEPTH, GL_FOG_COORD})));
     }},
    {"Fogfv", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_FOG_COLOR, GL_FOG_DENSITY});
       p.gl.Fogfv(name, p.reals<4>().data());
     }},
    {"Hint", 1,
     [](Player& p) {
       const GLenum target = p.pick({GL_FOG_HINT, GL_PERSPECTIVE_CORRECTION_HINT, GL_POLYGON_SMOOTH_HINT});
       p.gl.Hint(target, p.pick({GL_NICEST, GL_FASTEST, GL_DONT_CARE}));
     }},
    {"LineWidth", 1, [](Player& p) { p.gl.LineWidth(3 * p.real()); }},
    {"LineStipple", 1,
     [](Player& p) {
       const GLint repeat = p.integer();
       p.gl.LineStipple(repeat, static_cast<GLushort>(p.bits()));
     }},
    {"PointSize", 1, [](Player& p) { p.gl.PointSize(4 * p.real()); }},
    {"PointParameterfv", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_DISTANCE_ATTENUATION});
       p.gl.PointParameterfv(name, p.reals<4>().data());
     }},
    {"Viewport", 2,
     [](Player& p) {
       const GLint x = p.integer(), y = p.integer();
       const GLsizei width = p.count(kSize), height = p.count(kSize);
       p.gl.Viewport(x, y, width, height);
     }},
    {"Scissor", 2,
     [](Player& p) {
       const GLint x = p.integer(), y = p.integer();
       const GLsizei width = p.count(kSize), height = p.count(kSize);
       p.gl.Scissor(x, y, width, height);
     }},
    {"whole viewport", 2, [](Player& p) { p.gl.Viewport(0, 0, kSize, kSize); }},
    {"ClearColor", 1,
     [](Player& p) {
       const auto c = p.reals<4>();
       p.gl.ClearColor(c[0], c[1], c[2], c[3]);
     }},
    {"ClearDepth", 1, [](Player& p) { p.gl.ClearDepth(p.real()); }},
    {"ClearStencil", 1, [](Player& p) { p.gl.ClearStencil(p.integer()); }},
    {"PolygonStipple", 1, [](Player& p) { p.gl.PolygonStipple(reinterpret_cast<const GLubyte*>(p.read())); }},
    {"SampleCoverage", 1,
     [](Player& p) {
       const float value = p.real();
       p.gl.SampleCoverage(value, p.flag());
     }},
};

}  // namespace

Ops stateCalls() { return kStateOps; }

}  // namespace gluray::fuzz

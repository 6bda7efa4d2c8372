#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

constexpr double kUntouched = -77;

/// Queries up to 16 numbers of type T by `ask(values)`.
template <class T, class Ask>
void ask(Player& p, const char* what, GLenum name, Ask question) {
  std::array<T, 16> got;
  got.fill(static_cast<T>(kUntouched));
  question(got.data());
  p.answer(std::string(what) + " " + std::to_string(name), {got.begin(), got.end()});
}

GLenum stateName(Player& p) {
  return p.pick({GL_CURRENT_COLOR,
                 GL_CURRENT_NORMAL,
                 GL_CURRENT_TEXTURE_COORDS,
                 GL_CURRENT_SECONDARY_COLOR,
                 GL_CURRENT_FOG_COORD,
                 GL_CURRENT_INDEX,
                 GL_EDGE_FLAG,
                 GL_CURRENT_RASTER_POSITION,
                 GL_CURRENT_RASTER_COLOR,
                 GL_MODELVIEW_MATRIX,
                 GL_PROJECTION_MATRIX,
                 GL_TEXTURE_MATRIX,
                 GL_MATRIX_MODE,
                 GL_MODELVIEW_STACK_DEPTH,
                 GL_ATTRIB_STACK_DEPTH,
                 GL_CLIENT_ATTRIB_STACK_DEPTH,
                 GL_VIEWPORT,
                 GL_DEPTH_RANGE,
                 GL_SHADE_MODEL,
                 GL_COLOR_MATERIAL_FACE,
                 GL_COLOR_MATERIAL_PARAMETER,
                 GL_LIST_BASE,
                 GL_LIST_INDEX,
                 GL_LIST_MODE,
                 GL_ARRAY_BUFFER_BINDING,
                 GL_ELEMENT_ARRAY_BUFFER_BINDING,
                 GL_VERTEX_ARRAY_BUFFER_BINDING,
                 GL_VERTEX_ARRAY_STRIDE,
                 GL_VERTEX_ARRAY_TYPE,
                 GL_ACTIVE_TEXTURE,
                 GL_CLIENT_ACTIVE_TEXTURE,
                 GL_TEXTURE_BINDING_2D,
                 GL_DRAW_BUFFER,
                 GL_READ_BUFFER,
                 GL_DEPTH_FUNC,
                 GL_DEPTH_WRITEMASK,
                 GL_BLEND_SRC,
                 GL_POLYGON_MODE,
                 GL_FRONT_FACE,
                 GL_CULL_FACE_MODE,
                 GL_LIGHT_MODEL_AMBIENT,
                 GL_FOG_COLOR,
                 GL_COLOR_WRITEMASK,
                 GL_SCISSOR_BOX,
                 GL_STENCIL_FUNC,
                 GL_RENDER_MODE,
                 GL_FRAMEBUFFER_BINDING,
                 GL_READ_FRAMEBUFFER_BINDING,
                 GL_CURRENT_PROGRAM,
                 GL_UNPACK_ALIGNMENT,
                 GL_COLOR_CLEAR_VALUE,
                 GL_NAME_STACK_DEPTH,
                 GL_LINE_WIDTH,
                 GL_POINT_SIZE,
                 GL_CURRENT_RASTER_TEXTURE_COORDS,
                 GL_CURRENT_RASTER_POSITION_VALID,
                 GL_MAP2_GRID_DOMAIN});
}

const Op kAskOps[] = {
    {"GetError", 20, [](Player& p) { p.answer("GetError", {static_cast<double>(p.gl.GetError())}); }},
    {"GetFloatv", 10,
     [](Player& p) {
       const GLenum name = stateName(p);
       ask<GLfloat>(p, "GetFloatv", name, [&](GLfloat* v) { p.gl.GetFloatv(name, v); });
     }},
    {"GetDoublev", 3,
     [](Player& p) {
       const GLenum name = stateName(p);
       ask<GLdouble>(p, "GetDoublev", name, [&](GLdouble* v) { p.gl.GetDoublev(name, v); });
     }},
    {"GetIntegerv", 5,
     [](Player& p) {
       const GLenum name = stateName(p);
       ask<GLint>(p, "GetIntegerv", name, [&](GLint* v) { p.gl.GetIntegerv(name, v); });
     }},
    {"GetBooleanv", 2,
     [](Player& p) {
       const GLenum name = stateName(p);
       ask<GLboolean>(p, "GetBooleanv", name, [&](GLboolean* v) { p.gl.GetBooleanv(name, v); });
     }},
    {"IsEnabled", 5,
     [](Player& p) {
       const GLenum name =
           p.pick({GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_TEXTURE_2D, GL_COLOR_MATERIAL, GL_VERTEX_ARRAY,
                   GL_COLOR_ARRAY, GL_BLEND, GL_CLIP_PLANE0, GL_NORMALIZE, GL_TEXTURE_GEN_S});
       p.answer("IsEnabled " + std::to_string(name), {static_cast<double>(p.gl.IsEnabled(name))});
     }},
    {"GetMaterialfv", 6,
     [](Player& p) {
       const GLenum face = p.pick({GL_FRONT, GL_BACK});
       const GLenum name = p.pick({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS});
       ask<GLfloat>(p, "GetMaterialfv", name, [&](GLfloat* v) { p.gl.GetMaterialfv(face, name, v); });
     }},
    {"GetLightfv", 3,
     [](Player& p) {
       const GLenum light = p.pick({GL_LIGHT0, GL_LIGHT1});
       const GLenum name = p.pick({GL_POSITION, GL_DIFFUSE, GL_SPOT_DIRECTION, GL_SPOT_CUTOFF});
       ask<GLfloat>(p, "GetLightfv", name, [&](GLfloat* v) { p.gl.GetLightfv(light, name, v); });
     }},
    {"GetClipPlane", 1,
     [](Player& p) {
       const GLenum plane = p.pick({GL_CLIP_PLANE0, GL_CLIP_PLANE1});
       ask<GLdouble>(p, "GetClipPlane", plane, [&](GLdouble* v) { p.gl.GetClipPlane(plane, v); });
     }},
    {"GetTexEnviv", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB});
       ask<GLint>(p, "GetTexEnviv", name, [&](GLint* v) { p.gl.GetTexEnviv(GL_TEXTURE_ENV, name, v); });
     }},
    {"GetTexParameteriv", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_MAX_LEVEL});
       ask<GLint>(p, "GetTexParameteriv", name,
                  [&](GLint* v) { p.gl.GetTexParameteriv(GL_TEXTURE_2D, name, v); });
     }},
    {"GetTexLevelParameteriv", 1,
     [](Player& p) {
       const GLint level = p.integer();
       const GLenum name = p.pick({GL_TEXTURE_WIDTH, GL_TEXTURE_INTERNAL_FORMAT});
       ask<GLint>(p, "GetTexLevelParameteriv", name,
                  [&](GLint* v) { p.gl.GetTexLevelParameteriv(GL_TEXTURE_2D, level, name, v); });
     }},
    {"GetVertexAttribfv", 1,
     [](Player& p) {
       const GLuint index = p.below(17);
       const GLenum name = p.pick({GL_CURRENT_VERTEX_ATTRIB, GL_VERTEX_ATTRIB_ARRAY_ENABLED});
       ask<GLfloat>(p, "GetVertexAttribfv", name,
                    [&](GLfloat* v) { p.gl.GetVertexAttribfv(index, name, v); });
     }},
};

}  // namespace

Ops askCalls() { return kAskOps; }

}  // namespace gluray::fuzz

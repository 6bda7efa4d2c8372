#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

GLenum colorFormat(Player& p) { return p.pick({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_BGRA}); }
GLenum type(Player& p) { return p.pick({GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT}); }

template <void (*Read)(Player&, GLint, GLint, GLsizei, GLsizei)>
void rectangle(Player& p) {
  const GLint x = p.integer(), y = p.integer();
  const GLsizei width = p.count(8), height = p.count(8);
  Read(p, x, y, width, height);
}

void map1(Player& p) {
  static constexpr GLint kOrder = 4;
  const GLenum which = p.pick({GL_MAP1_VERTEX_3, GL_MAP1_COLOR_4, GL_MAP1_NORMAL});
  const float from = p.real(), to = p.real();
  const GLint order = p.chance(5) ? p.integer() : kOrder;
  p.gl.Map1f(which, from, to, 4, order, reinterpret_cast<const GLfloat*>(p.read()));
}

void map2(Player& p) {
  const GLenum which =
      p.pick({GL_MAP2_VERTEX_3, GL_MAP2_VERTEX_3, GL_MAP2_NORMAL, GL_MAP2_TEXTURE_COORD_2, GL_MAP2_COLOR_4});
  const auto span = p.reals<4>();
  p.gl.Map2f(which, span[0], span[1], 4, 3, span[2], span[3], 12, 3,
             reinterpret_cast<const GLfloat*>(p.read()));
}

const Op kPixelOps[] = {
    {"RasterPos3f", 4,
     [](Player& p) {
       const auto v = p.reals<3>();
       p.gl.RasterPos3f(v[0], v[1], v[2]);
     }},
    {"RasterPos2iv", 1,
     [](Player& p) {
       const GLint v[2] = {p.integer(), p.integer()};
       p.gl.RasterPos2iv(v);
     }},
    {"WindowPos2f", 2,
     [](Player& p) {
       const float x = kSize * p.real(), y = kSize * p.real();
       p.gl.WindowPos2f(x, y);
     }},
    {"Bitmap", 3,
     [](Player& p) {
       const GLsizei width = p.count(16), height = p.count(8);
       const auto move = p.reals<2>();
       p.gl.Bitmap(width, height, 0, 0, move[0], move[1], reinterpret_cast<const GLubyte*>(p.read()));
     }},
    {"DrawPixels", 3,
     [](Player& p) {
       const GLsizei width = p.count(8), height = p.count(8);
       const GLenum format = p.chance(10) ? GLenum{GL_DEPTH_COMPONENT} : colorFormat(p), t = type(p);
       p.gl.DrawPixels(width, height, format, t, p.read());
     }},
    {"CopyPixels", 2, rectangle<[](Player& p, GLint x, GLint y, GLsizei width, GLsizei height) {
       p.gl.CopyPixels(x, y, width, height, p.pick({GL_COLOR, GL_DEPTH}));
     }>},
    {"ReadPixels", 3, rectangle<[](Player& p, GLint x, GLint y, GLsizei width, GLsizei height) {
       const GLenum format = p.chance(30) ? GLenum{GL_DEPTH_COMPONENT} : colorFormat(p);
       p.gl.ReadPixels(x, y, width, height, format, type(p), p.sink().bytes.data());
     }>},
    {"PixelZoom", 1,
     [](Player& p) {
       const float x = p.real(), y = p.real();
       p.gl.PixelZoom(x, y);
     }},
    {"PixelStorei alignment", 2,
     [](Player& p) {
       const GLenum name = p.pick({GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT});
       if (name == GL_UNPACK_ALIGNMENT || name == GL_PACK_ALIGNMENT) p.gl.PixelStorei(name, 1 << p.below(4));
     }},
    {"PixelStorei", 2,
     [](Player& p) {  // rows at least as long as the images: avoided.md
       static constexpr GLint kLengths[] = {0, 0, 64, -1};
       const GLenum name = p.below(2) ? GL_UNPACK_ROW_LENGTH : GL_PACK_ROW_LENGTH;
       p.gl.PixelStorei(name, kLengths[p.below(4)]);
       p.gl.PixelStorei(GL_UNPACK_LSB_FIRST, p.flag());
       p.gl.PixelStorei(GL_UNPACK_SKIP_ROWS, static_cast<GLint>(p.below(5)));
     }},
    {"PixelTransferf", 1,
     [](Player& p) {
       const GLenum name = p.pick({GL_RED_SCALE, GL_GREEN_BIAS, GL_ALPHA_SCALE, GL_DEPTH_BIAS});
       p.gl.PixelTransferf(name, p.real());
     }},
    {"PixelMapfv", 1,
     [](Player& p) {
       const GLenum which = p.pick({GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_A_TO_A});
       p.gl.PixelMapfv(which, 1 << p.below(4), reinterpret_cast<const GLfloat*>(p.read()));
     }},
    {"Map1f", 2, map1},
    {"Map2f", 2, map2},
    {"MapGrid1f", 1,
     [](Player& p) {
       const float from = p.real(), to = p.real();
       p.gl.MapGrid1f(static_cast<GLint>(1 + p.below(8)), from, to);
     }},
    {"MapGrid2f", 1,
     [](Player& p) {
       const auto span = p.reals<4>();
       p.gl.MapGrid2f(4, span[0], span[1], 4, span[2], span[3]);
     }},
};

}  // namespace

Ops pixelCalls() { return kPixelOps; }

}  // namespace gluray::fuzz

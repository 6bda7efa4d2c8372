#include "tests/fuzz/calls.h"

namespace gluray::fuzz {
namespace {

constexpr uint32_t kTextures = 5;

GLenum textureTarget(Player& p) {
  return p.pick({GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D});
}
GLint internalFormat(Player& p) {
  return static_cast<GLint>(p.pick({GL_RGB, GL_RGBA, GL_RGBA8, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA,
                                    GL_INTENSITY, 3, 4, GL_RGB5_A1, GL_DEPTH_COMPONENT}));
}
GLenum format(Player& p) {
  return p.pick({GL_RGB, GL_RGBA, GL_LUMINANCE, GL_BGRA, GL_ALPHA, GL_LUMINANCE_ALPHA, GL_RED});
}
GLenum pixelType(Player& p) {
  return p.pick({GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT, GL_BYTE});
}
GLint level(Player& p) { return p.chance(70) ? 0 : static_cast<GLint>(p.below(5)); }
GLsizei size(Player& p) { return p.chance(70) ? 1 << p.below(5) : p.count(16); }

void texImage2D(Player& p) {
  const GLint at = level(p), inside = internalFormat(p);
  const GLsizei width = size(p), height = size(p);
  const GLint border = p.chance(5) ? p.integer() : 0;
  const GLenum f = format(p), t = pixelType(p);
  const auto* pixels = p.read();
  p.gl.TexImage2D(GL_TEXTURE_2D, at, inside, width, height, border, f, t, pixels);
}

const Op kTextureOps[] = {
    {"BindTexture", 10,
     [](Player& p) {
       const GLenum which = textureTarget(p);
       // A texture keeps the target that it was first bound to, so each target has its own names.
       const GLuint base = which == GL_TEXTURE_1D ? 20 : which == GL_TEXTURE_3D ? 40 : 0;
       const GLuint name = p.name(kTextures);
       p.gl.BindTexture(which, name ? name + base : 0);
     }},
    {"TexImage2D", 10, texImage2D},
    {"TexImage1D", 2,
     [](Player& p) {
       const GLint at = level(p), inside = internalFormat(p);
       const GLsizei width = size(p);
       const GLenum f = format(p), t = pixelType(p);
       p.gl.TexImage1D(GL_TEXTURE_1D, at, inside, width, 0, f, t, p.read());
     }},
    {"TexImage3D", 1,
     [](Player& p) {
       const GLint inside = internalFormat(p);
       const GLsizei width = p.count(4), height = p.count(4), depth = p.count(4);
       const GLenum f = format(p), t = pixelType(p);
       p.gl.TexImage3D(GL_TEXTURE_3D, 0, inside, width, height, depth, 0, f, t, p.read());
     }},
    {"TexSubImage2D", 5,
     [](Player& p) {
       const GLint at = level(p), x = p.integer(), y = p.integer();
       const GLsizei width = p.count(8), height = p.count(8);
       const GLenum f = format(p), t = pixelType(p);
       p.gl.TexSubImage2D(GL_TEXTURE_2D, at, x, y, width, height, f, t, p.read());
     }},
    {"TexSubImage1D", 1,
     [](Player& p) {
       const GLint x = p.integer();
       const GLsizei width = p.count(8);
       const GLenum f = format(p), t = pixelType(p);
       p.gl.TexSubImage1D(GL_TEXTURE_1D, 0, x, width, f, t, p.read());
     }},
    {"CopyTexImage2D", 2,
     [](Player& p) {
       const auto inside = static_cast<GLenum>(internalFormat(p));
       const GLint x = p.integer(), y = p.integer();
       const GLsizei width = size(p), height = size(p);
       p.gl.CopyTexImage2D(GL_TEXTURE_2D, 0, inside, x, y, width, height, 0);
     }},
    {"CopyTexSubImage2D", 2,
     [](Player& p) {
       const GLint x = p.integer(), y = p.integer();
       const GLsizei width = p.count(8), height = p.count(8);
       p.gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, x, y, width, height);
     }},
    {"TexParameteri", 8,
     [](Player& p) {
       const GLenum which = textureTarget(p);
       const GLenum name =
           p.pick({GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                   GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_GENERATE_MIPMAP});
       const bool number =
           name == GL_TEXTURE_BASE_LEVEL || name == GL_TEXTURE_MAX_LEVEL || name == GL_GENERATE_MIPMAP;
       const GLint value =
           number ? static_cast<GLint>(p.below(4))
                  : static_cast<GLint>(p.pick({GL_NEAREST, GL_LINEAR, GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
                                               GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT,
                                               GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST_MIPMAP_NEAREST}));
       p.gl.TexParameteri(which, name, value);
     }},
    {"TexParameterfv", 2,
     [](Player& p) {
       const GLenum which = textureTarget(p);
       p.gl.TexParameterfv(which, p.pick({GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_PRIORITY, GL_TEXTURE_LOD_BIAS}),
                           p.reals<4>().data());
     }},
    {"TexEnvi", 4,
     [](Player& p) {
       const GLenum name =
           p.pick({GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_SRC0_RGB, GL_OPERAND0_RGB});
       p.gl.TexEnvi(GL_TEXTURE_ENV, name,
                    static_cast<GLint>(p.pick({GL_MODULATE, GL_DECAL, GL_REPLACE, GL_BLEND, GL_ADD,
                                               GL_COMBINE, GL_TEXTURE, GL_PREVIOUS, GL_SRC_COLOR})));
     }},
    {"TexEnvfv", 1,
     [](Player& p) { p.gl.TexEnvfv(GL_TEXTURE_ENV, p.pick({GL_TEXTURE_ENV_COLOR}), p.reals<4>().data()); }},
    {"TexGeni", 2,
     [](Player& p) {
       const GLenum coordinate = p.pick({GL_S, GL_T, GL_R, GL_Q});
       p.gl.TexGeni(
           coordinate, GL_TEXTURE_GEN_MODE,
           static_cast<GLint>(p.pick({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP})));
     }},
    {"TexGenfv", 2,
     [](Player& p) {
       const GLenum coordinate = p.pick({GL_S, GL_T});
       p.gl.TexGenfv(coordinate, p.pick({GL_OBJECT_PLANE, GL_EYE_PLANE}), p.reals<4>().data());
     }},
    {"ActiveTexture", 2,
     [](Player& p) {
       p.gl.ActiveTexture(p.pick({GL_TEXTURE1, GL_TEXTURE7}));
     }},
    {"ActiveTexture 0", 4, [](Player& p) { p.gl.ActiveTexture(GL_TEXTURE0); }},
    {"GenerateMipmap", 1, [](Player& p) { p.gl.GenerateMipmap(textureTarget(p)); }},
    {"DeleteTextures", 2,
     [](Player& p) {
       const GLuint name = p.name(kTextures);
       p.gl.DeleteTextures(1, &name);
     }},
    {"IsTexture", 1,
     [](Player& p) { p.answer("IsTexture", {static_cast<double>(p.gl.IsTexture(p.name(kTextures)))}); }},
    {"GetTexImage", 1,
     [](Player& p) {
       const GLint at = level(p);
       const GLenum f = format(p), t = pixelType(p);
       p.gl.GetTexImage(GL_TEXTURE_2D, at, f, t, p.sink().bytes.data());
     }},
};

}  // namespace

Ops textureCalls() { return kTextureOps; }

}  // namespace gluray::fuzz

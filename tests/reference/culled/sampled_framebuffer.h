// A multisampled framebuffer object of textures, all of whose samples can be read.
#pragma once
#include "tests/reference/culled/culled_frames.h"

#include <algorithm>
#include <cstring>

namespace gluray::test::culled {

class SampledFramebuffer {
 public:
  /// Makes it. `depth`: the format of its depths.
  SampledFramebuffer(Gl gl, int samples, GLenum depth = GL_DEPTH24_STENCIL8) : samples_(samples) {
    gl.GenTextures(2, textures_.data()), gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const auto attach = [&](GLuint texture, GLenum format, GLenum attachment) {
      gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
      gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, kSide, kSide, GL_TRUE);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
    };
    const bool stencil = depth == GL_DEPTH24_STENCIL8 || depth == GL_DEPTH32F_STENCIL8;
    attach(textures_[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(textures_[1], depth, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    makeReader(gl);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  }

  /// Binds it, with all state that read() changes.
  void bind(Gl gl) const {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_MULTISAMPLE);
  }

  /// One image above the other, of the samples in their order. Call after bind().
  DrawnImage read(Gl gl) const {
    const size_t pixels = size_t{kSide} * kSide;
    DrawnImage all{kSide, kSide * samples_, {}, {}};
    all.colors.resize(pixels * static_cast<size_t>(samples_)), all.depths.resize(all.colors.size());
    gl.BindFramebuffer(GL_FRAMEBUFFER, reader_);
    gl.BindVertexArray(array_), gl.UseProgram(program_);
    gl.Viewport(0, 0, kSide, kSide);
    for (const GLenum off : {GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE}) gl.Disable(off);
    for (size_t i = 0; i < 2; ++i)
      gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i)),
          gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, textures_[i]);
    for (int s = 0; s < samples_; ++s) {
      gl.Uniform1i(gl.GetUniformLocation(program_, "s"), s);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
      gl.ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, &all.colors[pixels * size_t(s)]);
      gl.ReadBuffer(GL_COLOR_ATTACHMENT1);
      gl.ReadPixels(0, 0, kSide, kSide, GL_RED, GL_FLOAT, &all.depths[pixels * size_t(s)]);
    }
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0})
      gl.ActiveTexture(unit), gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    return all;
  }

 private:
  void makeReader(Gl gl) {
    program_ = makeProgram(gl, R"(#version 150
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})",
                           R"(#version 150
uniform sampler2DMS colors, depths;
uniform int s;
out vec4 parts[2];
void main() {
  parts[0] = texelFetch(colors, ivec2(gl_FragCoord.xy), s);
  parts[1] = texelFetch(depths, ivec2(gl_FragCoord.xy), s);
})");
    gl.GenVertexArrays(1, &array_);
    gl.UseProgram(program_);
    gl.Uniform1i(gl.GetUniformLocation(program_, "colors"), 0);
    gl.Uniform1i(gl.GetUniformLocation(program_, "depths"), 1);
    gl.GenFramebuffers(1, &reader_), gl.BindFramebuffer(GL_FRAMEBUFFER, reader_);
    std::array<GLuint, 2> images{};
    gl.GenRenderbuffers(2, images.data());
    for (GLuint i = 0; i < 2; ++i) {
      gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
      gl.RenderbufferStorage(GL_RENDERBUFFER, i == 0 ? GL_RGBA8 : GL_R32F, kSide, kSide);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_RENDERBUFFER, images[i]);
    }
    constexpr std::array<GLenum, 2> kBoth{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.DrawBuffers(2, kBoth.data());
  }

  int samples_;
  GLuint framebuffer_ = 0, reader_ = 0, program_ = 0, array_ = 0;
  std::array<GLuint, 2> textures_{};
};

/// compareFrames(); with several samples in such a framebuffer, and all of them are compared.
inline gl::Statistics compareSamples(const std::string& name, int frames, int samples, GLenum depth,
                                     const std::function<void(Gl)>& prepare,
                                     const std::function<void(Gl, int)>& draw,
                                     const Settings* settings = nullptr,
                                     const ContextWish& wish = {kSide, kSide, true, 3, 2}) {
  if (samples == 1) return compareFrames(name, frames, prepare, draw, settings, wish);
  std::optional<SampledFramebuffer> framebuffer;
  return compareFrames(
      name, frames,
      [&](Gl gl) {
        framebuffer.emplace(gl, samples, depth);
        prepare(gl);
      },
      [&](Gl gl, int frame) {
        framebuffer->bind(gl);
        draw(gl, frame);
      },
      settings, wish, [&](Gl gl) { return framebuffer->read(gl); });
}

}  // namespace gluray::test::culled

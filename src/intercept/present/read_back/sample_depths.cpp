#include "intercept/present/read_back/sample_depths.h"

#include "gl/real/state_queries.h"
#include "intercept/present/read_back/view_program.h"
#include "intercept/present/state/state_guard.h"
#include "intercept/present/state/texture_growth.h"
#include "intercept/present/state/texture_names.h"

#include <GL/glext.h>
#include <glm/glm.hpp>

#include <array>
#include <mutex>

namespace gluray::present {
namespace {

using gl::RealGl;

constexpr const char* kReduceSamples = R"(#version 150
uniform sampler2DMS depths;
uniform ivec2 samples;
uniform bool least;
uniform ivec2 corner;
out vec4 farthest;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) + corner;
  float most = texelFetch(depths, at, samples.x).r;
  for (int s = samples.x + 1; s < samples.y; ++s) {
    float depth = texelFetch(depths, at, s).r;
    most = least ? min(most, depth) : max(most, depth);
  }
  farthest = vec4(most);
}
)";

/// Of the bound draw framebuffer, in its pixels.
std::vector<glm::vec2> samplePlaces(const RealGl& real, GLint samples) {
  std::vector<glm::vec2> places(static_cast<size_t>(samples));
  for (GLuint i = 0; i < static_cast<GLuint>(samples); ++i)
    real.GetMultisamplefv(GL_SAMPLE_POSITION, i, &places[i].x);
  return places;
}

}  // namespace

bool SampleDepths::ready(const RealGl& real, const Features& has) {
  if (program_ != 0 || impossible_) return !impossible_;
  impossible_ = has.version < 32 || !has.readFramebuffers;
  if (impossible_) return false;
  StateGuard guard(real, has);
  program_ = buildViewProgram(real, has.compatibility, kReduceSamples);
  impossible_ = program_ == 0;
  if (impossible_) return takeErrors(real), false;
  if (!has.compatibility) real.GenVertexArrays(1, &vertexArray_);
  guard.program(program_);
  real.Uniform1i(real.GetUniformLocation(program_, "depths"), has.textureUnit);
  return true;
}

bool SampleDepths::copy(const RealGl& real, const Features& has, const scene::Region& region) {
  if (!ready(real, has)) return false;
  const GLint samples = gl::integer(real, GL_SAMPLES);
  return samples > 1 && copySamples(real, has, region, samples, copy_);
}

bool SampleDepths::reduce(const RealGl& real, const Features& has, const scene::Region& region,
                          const SampleCopy& from, const Range& range, void* out) {
  StateGuard guard(real, has);
  guard.openFragmentPath();
  guard.capability(GL_DEPTH_TEST, false);
  guard.viewport(0, 0, region.width, region.height);
  guard.scissorOff();
  guard.plainPack();
  guard.program(program_);
  if (vertexArray_ != 0) guard.vertexArray(vertexArray_);
  real.Uniform2i(real.GetUniformLocation(program_, "samples"), range.first, range.end);
  real.Uniform1i(real.GetUniformLocation(program_, "least"), range.least);
  real.Uniform2i(real.GetUniformLocation(program_, "corner"), range.at.x, range.at.y);
  {
    std::unique_lock lock(textureNaming(), std::defer_lock);
    if (target_.texture == 0) lock.lock(), target_.texture = newTextureName(real, has);
    guard.texture2D(has.textureUnit + 1, target_.texture);
  }
  if (const glm::ivec2 size = grownSize(target_.size, {region.width, region.height}); size != target_.size) {
    target_.size = size;
    real.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    real.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, size.x, size.y, 0, GL_RED, GL_FLOAT, nullptr);
  }
  guard.textureMultisample(has.textureUnit, from.texture);
  const CopyFramebuffer framebuffer(real);
  real.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_.texture, 0);
  real.DrawBuffer(GL_COLOR_ATTACHMENT0);
  drawAroundView(real, has.compatibility);
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
  real.ReadPixels(0, 0, region.width, region.height, GL_RED, GL_FLOAT, out);
  const bool read = takeErrors(real).empty();
  if (!read) target_.size = {};
  return read;
}

bool SampleDepths::readFarthest(const RealGl& real, const Features& has, const scene::Region& region,
                                bool least, float* out) {
  if (stage_.framebuffer != 0)
    return reduce(real, has, region, stage_.depths, {0, stage_.depths.samples, least, {region.x, region.y}},
                  out);
  return copy(real, has, region) && reduce(real, has, region, copy_, {0, copy_.samples, least}, out);
}

bool SampleDepths::resolveColors(const RealGl& real, const Features& has, const scene::Region& region,
                                 void* out) {
  StateGuard guard(real, has);
  guard.scissorOff();
  guard.plainPack();
  guard.readFrom(static_cast<GLuint>(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING)),
                 static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0)));
  GLuint colors = 0;
  real.GenRenderbuffers(1, &colors);
  const GLint bound = gl::integer(real, GL_RENDERBUFFER_BINDING);
  real.BindRenderbuffer(GL_RENDERBUFFER, colors);
  real.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, region.width, region.height);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  {
    const CopyFramebuffer framebuffer(real);
    real.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
    real.DrawBuffer(GL_COLOR_ATTACHMENT0);
    real.BlitFramebuffer(region.x, region.y, region.x + region.width, region.y + region.height, 0, 0,
                         region.width, region.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    real.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    real.ReadPixels(0, 0, region.width, region.height, GL_RGBA, GL_FLOAT, out);
  }
  real.DeleteRenderbuffers(1, &colors);
  return takeErrors(real).empty();
}

bool SampleDepths::resolve(const RealGl& real, const Features& has, const scene::Region& region,
                           uint32_t* out) {
  if (!ready(real, has) || gl::integer(real, GL_SAMPLES) < 2) return false;
  std::vector<glm::vec4> wide(static_cast<size_t>(region.width) * static_cast<size_t>(region.height));
  if (!resolveColors(real, has, region, wide.data())) return false;
  for (size_t i = 0; i < wide.size(); ++i) out[i] = glm::packUnorm4x8(wide[i]);
  return true;
}

bool SampleDepths::readAll(const RealGl& real, const Features& has, const scene::Region& region,
                           std::vector<uint32_t>& out) {
  if (!copy(real, has, region)) return false;
  const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
  out.resize(pixels * (4 + static_cast<size_t>(copy_.samples)));
  if (!resolveColors(real, has, region, out.data())) return false;
  for (int s = 0; s < copy_.samples; ++s)
    if (!reduce(real, has, region, copy_, {s, s + 1, false},
                out.data() + pixels * (4 + static_cast<size_t>(s))))
      return false;
  return true;
}

bool SampleDepths::bindCopy(const RealGl& real, const Features& has, const scene::Region& region,
                            bool colors) {
  const GLint samples = gl::integer(real, GL_SAMPLES);
  if (!ready(real, has) || samples < 2) return false;
  const StateGuard guard(real, has);
  if (!copySamples(real, has, region, samples, stage_.depths, {region.x, region.y})) return false;
  const std::vector<glm::vec2> places = samplePlaces(real, samples);
  stage_.program = gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING);
  real.GenFramebuffers(1, &stage_.framebuffer);
  real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, stage_.framebuffer);
  attachSamples(real, stage_.depths);
  real.DrawBuffer(GL_NONE);
  if (colors) attachColors(real, samples);
  const bool complete = real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
                        samplePlaces(real, samples) == places && takeErrors(real).empty();
  if (!complete) unbindCopy(real), takeErrors(real);
  return complete;
}

/// Black ones.
void SampleDepths::attachColors(const RealGl& real, GLint samples) {
  const GLint bound = gl::integer(real, GL_RENDERBUFFER_BINDING);
  real.GenRenderbuffers(1, &stage_.colors);
  real.BindRenderbuffer(GL_RENDERBUFFER, stage_.colors);
  real.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA32F, stage_.depths.size.x,
                                      stage_.depths.size.y);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  real.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, stage_.colors);
  real.DrawBuffer(GL_COLOR_ATTACHMENT0);
  constexpr std::array<GLfloat, 4> kBlack{};
  real.ClearBufferfv(GL_COLOR, 0, kBlack.data());
}

void SampleDepths::unbindCopy(const RealGl& real) {
  if (stage_.framebuffer == 0) return;
  real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(stage_.program));
  real.DeleteFramebuffers(1, &stage_.framebuffer);
  if (stage_.colors != 0) real.DeleteRenderbuffers(1, &stage_.colors);
  stage_.framebuffer = stage_.colors = 0;
}

gl::SharedNames SampleDepths::takeNames() {
  gl::SharedNames names;
  names.textures = {copy_.texture, target_.texture, stage_.depths.texture};  // deleting name 0 does nothing
  names.programs = {program_};
  *this = {};
  return names;
}

}  // namespace gluray::present

#include "gl/shadow/shadow_state.h"

#include "gl/basics/failsafe.h"
#include "gl/capture/solid_settings.h"
#include "gl/real/errors.h"

#include <string_view>
#include <utility>

namespace gluray::gl {
namespace {

bool isSoftware(const RealGl& real) {
  const auto* name = reinterpret_cast<const char*>(real.GetString(GL_RENDERER));
  const std::string_view renderer = name ? name : "";
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos ||
         renderer.find("Software") != renderer.npos;
}

}  // namespace

ShadowState::ShadowState(const RealGl& realGl, std::shared_ptr<ShareGroup> shareGroup,
                         const ContextInfo& contextInfo, const Settings& ofFrame, Errors& contextErrors,
                         Failsafe& failsafe)
    : real(realGl),
      sharedGroup(std::move(shareGroup)),
      group(*sharedGroup),
      info(contextInfo),
      settings(ofFrame),
      errors(contextErrors),
      attachments(group.deletedBuffers),
      images(group.deletedImages),
      latch(settings.quirks.has(Quirk::materialLatch) && MaterialLatch::isIn(realGl)),
      textures(group),
      program(real, group, info),
      failsafe_(failsafe) {}

bool ShadowState::isSoftwareBelow() {
  if (!softwareBelow_) softwareBelow_ = isSoftware(real);
  return *softwareBelow_;
}

void ShadowState::refresh(uint32_t groups) noexcept {
  const uint32_t stale = dirty & (info.core ? groups & ~kFixedFunction : groups);
  if (stale) failsafe_.protect([&] { read(stale); });
}

void ShadowState::read(uint32_t stale) {
  // A query that the real OpenGL refuses sets an error; the program must see only its own errors.
  errors.keepPending();
  if (!state.rare.asked) {
    state.rare = readRareState(real);
    state.rare.fogsWholeSum = state.rare.fogsWholeSum && settings.quirks.has(Quirk::fogSum);
  }
  state.rare.fixedFunction = !info.core;
  if (stale & kCurrent) current.read(real);
  syncCurrent();
  if (stale & kModelview) readModelview(real, state);
  if (stale & kProjection) readProjection(real, state);
  if (stale & kViewport) readViewport(real, state);
  if (stale & kRaster) readRaster(real, state);
  if (stale & kLighting) readLighting(real, state);
  // Colours sent while lighting was off changed the material without setting kMaterial.
  const bool recolored = (stale & kLighting) && state.shading.colorMaterial != scene::ColorMaterial{};
  if ((stale & kMaterial) || recolored) {
    readMaterial(real, state);
    latch.drawn();
  } else if (stale & kCurrent) {
    latch.restore(real);
  }
  if (stale & kFixedTextures) state.textureReason = textures.read(real, state.rare, state.textures);
  if (stale & kClip) readClipPlanes(real, state);
  if (stale & kTarget) readTarget(real, images, state);
  if (stale & kFixedArrays) readArrays(real, group, arrays), attachments.check(arrays);
  if (stale & (kProgram | kProgramTextures)) readProgramInUse();
  if (stale & kAttributes) {
    readAttributes(real, group, state.program.known.get(), attributes);
    attachments.check(attributes);
  }
  while (real.GetError() != GL_NO_ERROR) {}
  dirty &= ~stale;
  readBack |= stale;
}

std::shared_ptr<const KnownProgram> ShadowState::recognise(GLuint name) {
  if (auto known = group.recognised(name)) return known;
  errors.keepPending();
  auto known = program.known(name);
  while (real.GetError() != GL_NO_ERROR) {}
  return known;
}

void ShadowState::readProgramInUse() {
  ProgramState& inUse = state.program;
  const GLuint name = program.name();
  const auto before = inUse.known;
  inUse.known = name ? program.known(name) : nullptr;
  if (inUse.known != before) dirty |= kAttributes;
  if (!inUse.known) {
    inUse.reason = Reason::program;
    return;
  }
  readProgram(real, group, state.rare, textures, inUse, drawsAnySolids(settings));
  // A deleted program lives only while it is in use. OtherProgram cannot hold it in each version of OpenGL.
  GLint deleted = 0;
  real.GetProgramiv(name, GL_DELETE_STATUS, &deleted);
  if (deleted) inUse.reason = Reason::program;
}

const std::shared_ptr<const KnownProgram>& ShadowState::programInUse() {
  refresh(kProgram);
  return state.program.known;
}

void ShadowState::sendBuffers() {
  const auto send = [&](const std::shared_ptr<Buffer>& buffer) {
    if (buffer) buffer->sendTo(real);
  };
  if (!group.anyBuffersHeldBack()) return;
  refresh(kRaster);
  const bool programs = state.raster.program != 0 || info.core;
  refresh(programs ? kProgram | kAttributes : uint32_t{kFixedArrays});
  const ArrayState& used = programs ? attributes : arrays;
  used.forEach([&](const ArraySource& source) { send(source.buffer); });
  for (const ArraySource& source : used.generic) send(source.buffer);
  send(used.elements);
  // Fixed-function arrays may feed programs that use built-in attributes.
  if (programs && info.core) return;
  if (programs) refresh(kFixedArrays);
  if (programs) arrays.forEach([&](const ArraySource& source) { send(source.buffer); });
  if (!arrays.others || programs) return;
  for (const auto& buffer : group.buffers.all()) send(buffer);
}

}  // namespace gluray::gl

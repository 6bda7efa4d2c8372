#include "gl/shadow/shadow_state.h"

#include "gl/basics/affine.h"
#include "gl/basics/failsafe.h"
#include "gl/capture/solid_settings.h"
#include "gl/real/clip_depths.h"
#include "gl/real/errors.h"
#include "gl/real/extensions.h"

#include <utility>

namespace gluray::gl {
ShadowState::ShadowState(const RealGl& realGl, const BeginEnd& beginEnd,
                         std::shared_ptr<ShareGroup> shareGroup, const ContextInfo& contextInfo,
                         const Settings& ofFrame, Errors& contextErrors, Failsafe& failsafe)
    : real(realGl),
      sharedGroup(std::move(shareGroup)),
      group(*sharedGroup),
      info(contextInfo),
      settings(ofFrame),
      errors(contextErrors),
      attachments(group.deletedBuffers),
      images(group.deletedImages),
      latch(settings.quirks.has(Quirk::materialLatch) && MaterialLatch::isIn(realGl), current),
      textures(group),
      currentProgram(real, group, info),
      beginEnd_(beginEnd),
      failsafe_(failsafe),
      readable_(info.core ? kAllGroups & ~kFixedFunction : uint32_t{kAllGroups}),
      dirty_(readable_) {
  if (mesaVersionOf(real.GetString(GL_VERSION)) == 0) current.holdNothingBack();
}

void ShadowState::madeCurrent(uintptr_t drawable) {
  target_.drawable = drawable;
  touch(kAllGroups);
}

void ShadowState::shareImpostorValues() {
  attributes_.impostorRadius = program_.impostorRadius;
  if (attributes_.shape != scene::Shape::triangles) attributes_.impostorCaps = program_.impostorCaps;
}

void ShadowState::readBack(uint32_t groups) noexcept {
  if (beginEnd_.realIsInside()) return;
  const uint32_t stale = (dirty_ | expired_) & groups;
  // If reading fails, the next refresh() tries again. Until then, accessors do not.
  expired_ |= stale, dirty_ &= ~stale;
  failsafe_.protect([&] {
    read(stale);
    expired_ &= ~stale, dirty_ &= ~stale;
    readBack_ |= stale;
  });
}

void ShadowState::readRare() {
  rare_ = readRareState(real);
  rare_.fogsWholeSum = rare_.fogsWholeSum && settings.quirks.has(Quirk::fogSum);
  rare_.fixedFunction = !info.core;
}

void ShadowState::askRare() noexcept {
  if (asksRare_ || beginEnd_.realIsInside()) return;
  asksRare_ = true;  // a failure draws pending draws, which may call this
  failsafe_.protect([&] {
    errors.keepPending();
    readRare();
    while (real.GetError() != GL_NO_ERROR) {}
  });
  asksRare_ = false;
}

void ShadowState::checkArrays(ArrayState& arrays) {
  attachments.check(arrays);
  if (fractions.apply(real, info.core, arrays)) latch.restore(real);
}

void ShadowState::read(uint32_t stale) {
  // A query that the real OpenGL refuses sets an error; the program must see only its own errors.
  errors.keepPending();
  if (!rare_.asked) readRare();
  if (stale & kCurrent) current.read(real);
  if (stale & kModelview) {
    modelview_ = readMatrix(real, GL_MODELVIEW_MATRIX);
    modelviewInvertible_ = isInvertible(modelview_);
  }
  if (stale & kProjection) {
    projection_ = readMatrix(real, GL_PROJECTION_MATRIX);
    if (hasDepthsFromZero(real, rare_)) projection_ = toUsualDepths(projection_);
    projectionInvertible_ = isInvertible(projection_);
  }
  if (stale & kViewport) readViewport(real, viewport_);
  if (stale & kRaster) readRaster(real, rare_, raster_, shading_.fog);
  if (stale & kLighting) readLighting(real, rare_, shading_);
  // Colours sent while lighting was off changed the material without marking kMaterial.
  const bool recolored = (stale & kLighting) && shading_.colorMaterial != scene::ColorMaterial{};
  if ((stale & kMaterial) || recolored) {
    readMaterial(real, material_);
    latch.drawn();
    current.restore(real);
    // What is stale has been read by now.
    follows_ = !isDirty(kCurrent & ~stale) &&
               materialOfColor(material_, shading_.colorMaterial, current[kColor]) == material_;
  } else if (stale & kCurrent) {
    latch.restore(real);
  }
  if (stale & kFixedTextures) textureReason_ = textures.read(real, rare_, fixedTextures_);
  if (stale & kClip) clipPlanes_ = readClipPlanes(real);
  if (stale & kTarget) readTarget(real, rare_, images, target_);
  if (stale & kFixedArrays) readArrays(real, group, arrays_), checkArrays(arrays_);
  if (stale & (kProgram | kProgramTextures)) readProgramInUse();
  if (stale & kAttributes) {
    readAttributes(real, group, program_.known.get(), attributes_);
    checkArrays(attributes_);
  }
  while (real.GetError() != GL_NO_ERROR) {}
}

std::shared_ptr<const KnownProgram> ShadowState::recognise(GLuint name) {
  if (auto known = group.recognised(name)) return known;
  errors.keepPending();
  auto known = currentProgram.known(name);
  while (real.GetError() != GL_NO_ERROR) {}
  return known;
}

void ShadowState::readProgramInUse() {
  ProgramState& inUse = program_;
  const GLuint name = currentProgram.name();
  const auto before = inUse.known;
  inUse.known = name ? currentProgram.known(name) : nullptr;
  if (inUse.known)
    readProgram(real, group, rare_, textures, inUse, drawsAnySolids(settings));
  else
    inUse.reason = Reason::program, inUse.pulled.reset();
  if (inUse.known != before) touch(kAttributes);
  if (!inUse.known) return;
  // A deleted program lives only while it is in use. Not every version of OpenGL lets OtherProgram keep it
  // alive.
  GLint deleted = 0;
  real.GetProgramiv(name, GL_DELETE_STATUS, &deleted);
  if (deleted) inUse.reason = Reason::program;
}

const ArrayState& ShadowState::vertices() {
  const ArrayState& own = attributes();
  if (!program().pulled) return own;
  if (program_.pulled->indexed) program_.pulled->arrays.elements = own.elements;
  return program_.pulled->arrays;
}

bool ShadowState::takeValuesOfCells(uint32_t triangles) {
  if (!program_.pulled || !program_.pulled->sortsCells()) return true;
  const auto take = [&](scene::Attribute& values, uint32_t& count) {
    if (!values) return true;
    std::optional<scene::Attribute> taken = valuesOfCells_.take(*program_.pulled, values, count, triangles);
    if (taken) values = std::move(*taken), count = triangles;
    return taken.has_value();
  };
  const bool all = take(program_.triangleColors, program_.triangleColorCount) &&
                   take(program_.triangleNormals, program_.triangleNormalCount);
  program_.pulled->cells = {}, program_.pulled->primitivesPerCell = 1;
  program_.opaqueTriangleColors = textures.isOpaque(program_.triangleColors, program_.triangleColorCount);
  expire(kProgram);
  return all;
}

void ShadowState::sendBuffers() {
  const auto send = [&](const std::shared_ptr<Buffer>& buffer) {
    if (buffer) buffer->sendTo(real);
  };
  if (!group.anyBuffersHeldBack()) return;
  const bool programs = raster().program != 0 || info.core;
  if (programs) refresh(kProgram | kAttributes);
  const ArrayState& used = programs ? attributes() : arrays();
  used.forEach([&](const ArraySource& source) { send(source.buffer); });
  for (const ArraySource& source : used.generic) send(source.buffer);
  send(used.elements);
  // Fixed-function arrays may feed programs that use built-in attributes.
  if (programs && info.core) return;
  if (programs) return arrays().forEach([&](const ArraySource& source) { send(source.buffer); });
  if (!used.others) return;
  for (const auto& buffer : group.buffers.all()) send(buffer);
}

}  // namespace gluray::gl

// Shadow copy of the real OpenGL's state. State calls are forwarded at once and mark groups of it as dirty;
// whoever reads a group that is dirty has it read back first. A part of each Context, GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/arrays/attachments.h"
#include "gl/arrays/signed_fractions.h"
#include "gl/capture/current_values.h"
#include "gl/clock/context_info.h"
#include "gl/program_state/current_program.h"
#include "gl/program_state/program_state.h"
#include "gl/real/begin_end.h"
#include "gl/real/real.h"
#include "gl/shadow/material_latch.h"
#include "gl/sharing/share_group.h"
#include "gl/state/state.h"
#include "gl/textures/texture_cache.h"

#include <GL/gl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

class Errors;
class Failsafe;

class ShadowState {
 public:
  /// `ofFrame`: the settings of the current frame, which may change between frames.
  ShadowState(const RealGl& real, const BeginEnd& beginEnd, std::shared_ptr<ShareGroup> group,
              const ContextInfo& info, const Settings& ofFrame, Errors& errors, Failsafe& failsafe);

  const RealGl& real;
  const std::shared_ptr<ShareGroup> sharedGroup;
  ShareGroup& group;
  ContextInfo info;
  const Settings& settings;  // of this frame
  Errors& errors;

  Attachments attachments;  // buffers in vertex array objects
  AttachedImages images;    // in framebuffer objects
  CurrentValues current;    // current attributes; valid after refresh(kCurrent)
  MaterialLatch latch;
  TextureCache textures;
  CurrentProgram currentProgram;
  SignedFractions fractions;
  int activeQueries = 0;  // queries and conditional renderings that count or guard draws
  GLenum matrixMode = 0;  // 0: query the real OpenGL

  // Values of the real OpenGL. Groups that are dirty are read back first, but not between its glBegin and
  // glEnd, where queries are errors: the values are then the last that were read, as after a failure.
  // References stay valid; later calls change what they refer to. Core profiles have initial values for fixed
  // function.
  const RareState& rare() {
    if (!rare_.asked) [[unlikely]]
      askRare();
    return rare_;
  }
  const glm::dmat4& modelview() { return fresh(kModelview, modelview_); }
  const glm::dmat4& projection() { return fresh(kProjection, projection_); }
  bool modelviewIsInvertible() { return fresh(kModelview, modelviewInvertible_); }
  bool projectionIsInvertible() { return fresh(kProjection, projectionInvertible_); }
  const ViewportState& viewport() { return fresh(kViewport, viewport_); }
  const RasterState& raster() { return fresh(kRaster, raster_); }
  const TargetState& target() { return fresh(kTarget, target_); }
  PixelState pixelState() { return {target(), raster(), viewport()}; }
  /// With fog, but without textures and alpha test.
  const scene::Shading& shading() { return fresh(kLighting | kRaster, shading_); }
  /// Colours change it while GL_COLOR_MATERIAL is on.
  const scene::MaterialPair& material() { return fresh(kMaterial | kLighting, material_); }
  /// Why fixed function's textures cannot be traced, or Reason::traced.
  Reason textureReason() { return fresh(kFixedTextures, textureReason_); }
  /// Of the enabled texture units of fixed function.
  const std::vector<scene::Texture>& fixedTextures() { return fresh(kFixedTextures, fixedTextures_); }
  /// The enabled ones, in eye space.
  const std::vector<glm::dvec4>& clipPlanes() { return fresh(kClip, clipPlanes_); }
  /// Where raster().program is not 0: its inputs.
  const ProgramState& program() { return fresh(kProgram | kProgramTextures, program_); }
  /// Vertex arrays of fixed function.
  const ArrayState& arrays() { return fresh(kFixedArrays, arrays_); }
  /// Vertex arrays of the shader program in use, whose family says what they mean.
  const ArrayState& attributes() { return fresh(kAttributes, attributes_); }

  /// The shader program in use; `known` is null if there is none. Its textures may be those that program()
  /// has read last.
  const ProgramState& programInUse() {
    refresh(kProgram);
    return program_;
  }
  /// What raster() has returned last, for draws that must not wait for queries.
  const RasterState& lastRaster() const { return raster_; }

  /// A call may have changed these groups.
  void touch(uint32_t groups) { dirty_ |= groups & readable_; }
  /// The same where nothing tells when they change: their values hold for this draw, until refresh().
  void expire(uint32_t groups) { expired_ |= groups & readable_; }
  /// Whether one of these groups would be read back by refresh().
  bool isDirty(uint32_t groups) const { return ((dirty_ | expired_) & groups) != 0; }
  /// Reads back those of `groups` that are dirty, together. Call where a draw begins, whose reads then ask
  /// the real OpenGL only once for its errors.
  void refresh(uint32_t groups) noexcept {
    if (isDirty(groups)) [[unlikely]]
      readBack(groups);
  }
  /// Whether one of these groups was read back since forgetReadBack().
  bool wasReadBack(uint32_t groups) const { return (readBack_ & groups) != 0; }
  void forgetReadBack(uint32_t groups) { readBack_ &= ~groups; }

  /// The current colour was set: with GL_COLOR_MATERIAL the material follows it.
  void colorSet() {
    // Where kLighting is dirty, material() is read back with it.
    if (shading_.colorMaterial != scene::ColorMaterial{}) touch(kMaterial);
  }
  /// Number of the context in this process.
  void setContextNumber(uint64_t number) { target_.context = number; }
  /// The context has become current with `drawable` (0: unknown): the thread or the drawable may be others.
  void madeCurrent(uintptr_t drawable);

  // What draws find out about the shader program in use beyond its inputs; until it is read back again.
  /// Details for the user why it is not traced.
  void setProgramWhy(std::string why) { program_.why = std::move(why); }
  /// scene::Impostors::size of its impostors.
  void setImpostorSize(const glm::vec2& size) { program_.impostors.size = size; }
  /// Gives attributes() the radius, and the caps of impostors, that the program has for all of them.
  void shareImpostorValues();

  /// The shader program `name` with its family. The host program sees no errors of this. May throw
  /// std::bad_alloc.
  std::shared_ptr<const KnownProgram> recognise(GLuint name);
  /// Nothing: current values are sent at once.
  void syncCurrent() {}
  /// Sends the real OpenGL held-back contents of buffers that its next draw may read.
  void sendBuffers();
  double viewportPixels() {
    const glm::ivec4& box = viewport().box;
    return static_cast<double>(box.z) * static_cast<double>(box.w);
  }
  /// Whether the real OpenGL renders on the CPU.
  bool isSoftwareBelow();

 private:
  template <class Value>
  const Value& fresh(uint32_t groups, const Value& value) {
    if (dirty_ & groups) [[unlikely]]
      readBack(groups);
    return value;
  }
  void readBack(uint32_t groups) noexcept;
  void read(uint32_t stale);
  void readProgramInUse();
  void checkArrays(ArrayState& arrays);
  void askRare() noexcept;
  void readRare();

  const BeginEnd& beginEnd_;
  Failsafe& failsafe_;
  const uint32_t readable_;  // groups that the context has
  uint32_t dirty_, expired_ = 0;
  uint32_t readBack_ = kAllGroups;  // since forgetReadBack()
  bool asksRare_ = false;
  std::optional<bool> softwareBelow_;

  RareState rare_;
  glm::dmat4 modelview_{1}, projection_{1};
  bool modelviewInvertible_ = true, projectionInvertible_ = true;
  ViewportState viewport_;
  RasterState raster_;
  TargetState target_;
  scene::Shading shading_;
  scene::MaterialPair material_;
  Reason textureReason_ = Reason::traced;
  std::vector<scene::Texture> fixedTextures_;
  std::vector<glm::dvec4> clipPlanes_;
  ProgramState program_;
  ArrayState arrays_, attributes_;
};

/// Groups that decide whether and how a surface is traced.
inline constexpr uint32_t kDrawGroups = kModelview | kProjection | kViewport | kRaster | kLighting |
                                        kMaterial | kFixedTextures | kClip | kTarget | kCurrent;

/// Groups that decide this for surfaces drawn by a shader program.
inline constexpr uint32_t kProgramGroups =
    kViewport | kRaster | kTarget | kClip | kProgram | kProgramTextures | kAttributes;

}  // namespace gluray::gl

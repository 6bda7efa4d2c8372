// Shadow copy of the real OpenGL's state. State calls are forwarded at once and mark groups of state as
// dirty. An accessor reads a dirty group back before it returns it. A part of each Context, GL thread.
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

  // Values of the real OpenGL. Dirty groups are read back first, except between its glBegin and glEnd, where
  // queries are errors. There, and after a failure, the values are the last that were read. References stay
  // valid; later calls change the values that they refer to. In core profiles, fixed function's values are
  // the initial ones.
  const RareState& rare() {
    if (!rare_.asked) [[unlikely]]
      askRare();
    return rare_;
  }
  const glm::dmat4& modelview() { return fresh(kModelview, modelview_); }
  /// Maps to clip space with depths from -1 to 1, whatever glClipControl says.
  const glm::dmat4& projection() { return fresh(kProjection, projection_); }
  bool modelviewIsInvertible() { return fresh(kModelview, modelviewInvertible_); }
  bool projectionIsInvertible() { return fresh(kProjection, projectionInvertible_); }
  const ViewportState& viewport() { return fresh(kViewport, viewport_); }
  const RasterState& raster() { return fresh(kRaster, raster_); }
  const TargetState& target() { return fresh(kTarget, target_); }
  PixelState pixelState() { return {target(), raster(), viewport()}; }
  /// Includes fog, but neither textures nor alpha test.
  const scene::Shading& shading() { return fresh(kLighting | kRaster, shading_); }
  /// Colours change the material while GL_COLOR_MATERIAL is on.
  const scene::MaterialPair& material() { return fresh(kMaterial | kLighting, material_); }
  /// Why fixed function's textures cannot be traced, or Reason::traced.
  Reason textureReason() { return fresh(kFixedTextures, textureReason_); }
  /// Textures of the enabled units of fixed function.
  const std::vector<scene::Texture>& fixedTextures() { return fresh(kFixedTextures, fixedTextures_); }
  /// The enabled clip planes, in eye space.
  const std::vector<glm::dvec4>& clipPlanes() { return fresh(kClip, clipPlanes_); }
  /// Inputs of the shader program, if raster().program is not 0.
  const ProgramState& program() { return fresh(kProgram | kProgramTextures, program_); }
  /// Vertex arrays of fixed function.
  const ArrayState& arrays() { return fresh(kFixedArrays, arrays_); }
  /// Vertex arrays of the shader program in use, assigned to their roles by its family.
  const ArrayState& attributes() { return fresh(kAttributes, attributes_); }

  /// The vertices of the shader program in use: attributes(), or what it pulls from buffer textures.
  const ArrayState& vertices();

  /// The shader program in use; `known` is null if there is none. Its textures may be those that program()
  /// read last.
  const ProgramState& programInUse() {
    refresh(kProgram);
    return program_;
  }
  /// Whether primitive restart begins a new primitive within the draw, so that it cannot be traced. `arrays`:
  /// arrays() or attributes().
  bool isRestarted(const ArrayState& arrays, const Elements& elements) {
    return restarted_.isRestarted(real, arrays.restart, arrays.elements.get(), elements);
  }
  /// The last result of raster(), without a read-back, for draws that must not wait for queries.
  const RasterState& lastRaster() const { return raster_; }

  /// Marks groups as dirty, because a call may have changed them.
  void touch(uint32_t groups) { dirty_ |= groups & readable_; }
  /// Marks groups that change without any call that GLuRay sees: their values hold for this draw, until
  /// refresh().
  void expire(uint32_t groups) { expired_ |= groups & readable_; }
  /// Whether one of these groups would be read back by refresh().
  bool isDirty(uint32_t groups) const { return ((dirty_ | expired_) & groups) != 0; }
  /// Reads back, together, all dirty groups among `groups`. Call when a draw begins; its reads then query the
  /// real OpenGL's errors only once.
  void refresh(uint32_t groups) noexcept {
    if (isDirty(groups)) [[unlikely]]
      readBack(groups);
  }
  /// Whether one of these groups was read back since forgetReadBack().
  bool wasReadBack(uint32_t groups) const { return (readBack_ & groups) != 0; }
  void forgetReadBack(uint32_t groups) { readBack_ &= ~groups; }

  /// Reports that the current colour was set: with GL_COLOR_MATERIAL the material follows it.
  void colorSet() {
    // If kLighting is dirty, material() reads the material back with it.
    if (shading_.colorMaterial != scene::ColorMaterial{}) followColor();
  }
  /// The colour that vertices without one have: the current colour or, where the real OpenGL draws with
  /// materials that it has stored (MaterialLatch), what of the material follows the colour.
  glm::vec4 colorOfMaterial();
  /// Reports glMaterial with valid arguments, outside glBegin and glEnd.
  void materialSet(const MaterialChange& change);
  /// Reports a traced draw that uses the current values.
  void drawnTraced() {
    current.drawn(real);
    latch.drawn();
  }
  /// Number of the context in this process.
  void setContextNumber(uint64_t number) { target_.context = number; }
  /// Reports that the context has become current with `drawable` (0: unknown): the thread or the drawable may
  /// have changed.
  void madeCurrent(uintptr_t drawable);

  // Results that draws add to the shader program in use, until it is read back again.
  /// Why the program is not traced, for the user.
  void setProgramWhy(std::string why) { program_.why = std::move(why); }
  /// Sets scene::Impostors::size of the program's impostors.
  void setImpostorSize(const glm::vec2& size) { program_.impostors.size = size; }
  /// Sets scene::Impostors::coordinateShift of the program's impostors.
  void setCoordinateShift(const glm::vec2& pixels) { program_.impostors.coordinateShift = pixels; }
  /// Lets the first `triangles` triangles of a draw have the values of their cells. Does nothing if the
  /// program does not pull its vertices, or cells are triangles. Returns false if there are too few values.
  /// May throw std::bad_alloc.
  bool takeValuesOfCells(uint32_t triangles);
  /// Sets radius and caps of attributes() to those that the program uses for all its impostors.
  void shareImpostorValues();

  /// The shader program `name` and its family. Hides GL errors of this from the host program. May throw
  /// std::bad_alloc.
  std::shared_ptr<const KnownProgram> recognise(GLuint name);
  /// Sends held-back contents of those buffers that the real OpenGL's next draw may read.
  void sendBuffers();
  double viewportPixels() {
    const glm::ivec4& box = viewport().box;
    return static_cast<double>(box.z) * static_cast<double>(box.w);
  }
  /// Whether the real OpenGL renders on the CPU.
  bool isSoftwareBelow() const { return info.software; }

 private:
  template <class Value>
  const Value& fresh(uint32_t groups, const Value& value) {
    if (dirty_ & groups) [[unlikely]]
      readBack(groups);
    return value;
  }
  void followColor();
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

  RareState rare_;
  glm::dmat4 modelview_{1}, projection_{1};
  bool modelviewInvertible_ = true, projectionInvertible_ = true;
  ViewportState viewport_;
  RasterState raster_;
  TargetState target_;
  scene::Shading shading_;
  scene::MaterialPair material_;
  bool follows_ = false;  // what of material_ follows the colour has the current colour
  Reason textureReason_ = Reason::traced;
  std::vector<scene::Texture> fixedTextures_;
  std::vector<glm::dvec4> clipPlanes_;
  ProgramState program_;
  ValuesOfCells valuesOfCells_;
  ArrayState arrays_, attributes_;
  RestartedDraws restarted_;
};

/// Groups that decide whether and how a surface is traced.
inline constexpr uint32_t kDrawGroups = kModelview | kProjection | kViewport | kRaster | kLighting |
                                        kMaterial | kFixedTextures | kClip | kTarget | kCurrent;

/// The same groups for surfaces that a shader program draws.
inline constexpr uint32_t kProgramGroups =
    kViewport | kRaster | kTarget | kClip | kProgram | kProgramTextures | kAttributes;

}  // namespace gluray::gl

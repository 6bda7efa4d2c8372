// Shadow copy of the real OpenGL's state. State calls are forwarded at once and mark groups of it as dirty; a
// draw that needs a group reads it back. A part of each Context, GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/arrays/attachments.h"
#include "gl/capture/current_values.h"
#include "gl/clock/context_info.h"
#include "gl/program_state/current_program.h"
#include "gl/real/real.h"
#include "gl/shadow/material_latch.h"
#include "gl/sharing/share_group.h"
#include "gl/state/state.h"
#include "gl/textures/texture_cache.h"

#include <GL/gl.h>

#include <memory>
#include <optional>

namespace gluray::gl {

class Errors;
class Failsafe;

class ShadowState {
 public:
  /// `ofFrame`: the settings of the current frame, which may change between frames.
  ShadowState(const RealGl& real, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
              const Settings& ofFrame, Errors& errors, Failsafe& failsafe);

  const RealGl& real;
  const std::shared_ptr<ShareGroup> sharedGroup;
  ShareGroup& group;
  ContextInfo info;
  const Settings& settings;  // of this frame
  Errors& errors;

  uint32_t dirty = kAllGroups;     // StateGroups to read back when a draw needs them
  uint32_t readBack = kAllGroups;  // those that were read back since SmallDraws has cleared them
  State state;                     // valid where not dirty; use refresh()
  ArrayState arrays;               // the same for kFixedArrays
  ArrayState attributes;           // the same for kAttributes
  Attachments attachments;         // buffers in vertex array objects
  AttachedImages images;           // in framebuffer objects
  CurrentValues current;           // current attributes; valid after refresh(kCurrent)
  MaterialLatch latch;
  TextureCache textures;
  CurrentProgram program;
  int activeQueries = 0;  // queries and conditional renderings that count or guard draws
  GLenum matrixMode = 0;  // 0: query the real OpenGL

  void touch(uint32_t groups) { dirty |= groups; }
  /// Reads back those of `groups` that are dirty.
  void refresh(uint32_t groups) noexcept;
  /// The program `name` with its family. The program sees no errors of this. May throw std::bad_alloc.
  std::shared_ptr<const KnownProgram> recognise(GLuint name);
  /// The program in use; null if there is none. Outside glBegin and glEnd.
  const std::shared_ptr<const KnownProgram>& programInUse();
  void syncCurrent() {
    if (current.anyUnsent()) [[unlikely]]
      current.send(real);
  }
  /// Sends the real OpenGL held-back contents of buffers that its next draw may read.
  void sendBuffers();
  double viewportPixels() const {
    return static_cast<double>(state.viewport.z) * static_cast<double>(state.viewport.w);
  }
  /// Whether the real OpenGL renders on the CPU.
  bool isSoftwareBelow();

 private:
  void read(uint32_t stale);
  void readProgramInUse();

  Failsafe& failsafe_;
  std::optional<bool> softwareBelow_;
};

/// Groups that decide whether and how a surface is traced.
inline constexpr uint32_t kDrawGroups = kModelview | kProjection | kViewport | kRaster | kLighting |
                                        kMaterial | kFixedTextures | kClip | kTarget | kCurrent;

/// Groups that decide this for surfaces drawn by a shader program.
inline constexpr uint32_t kProgramGroups =
    kViewport | kRaster | kTarget | kClip | kProgram | kProgramTextures | kAttributes;

}  // namespace gluray::gl

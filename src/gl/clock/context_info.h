// The arguments with which intercept/ or a test creates a Context.
#pragma once
#include "base/clock.h"
#include "gl/families/family.h"
#include "gl/trials/engine_choice.h"
#include "scene/region.h"
#include "settings/live/settings_source.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>

namespace gluray::gl {

class Decisions;
class DrawKinds;

struct ContextInfo {
  int version = 0;                   // of its OpenGL, 10 times major plus minor
  bool packedFloats = false;         // takesPackedFloats()
  bool software = false;             // rendersInSoftware()
  bool core = false;                 // core profile: no fixed function
  bool doubleBuffered = true;        // of its drawable; otherwise glFlush and glFinish show the image
  bool off = false;                  // pass every call through
  Settings settings;                 // used if `source` is null
  SettingsSource* source = nullptr;  // read when the context is created and when a frame begins
  /// Returns width and height of the window or pixmap that the context draws into, in pixels; {0, 0} if
  /// unknown. May be slow: called only if a viewport exceeds the largest known size. Empty: never known.
  std::function<glm::ivec2()> drawableSize;
  /// Whether the user sees what the context draws, because its drawable is a window on the screen. Called
  /// while settings change images. Empty: no.
  std::function<bool()> isShown;
  std::shared_ptr<DrawKinds> kinds;            // records draws for `gluray explain`; null: not explaining
  std::shared_ptr<Decisions> decisions;        // logs these draws; null: no log. Needs `kinds`
  std::shared_ptr<const FamilyList> families;  // of shader programs; null: builtInFamilies()
  /// Called before and after a frame of a single-buffered context ends. May be empty.
  std::function<void()> frameEnding, frameEnded;
  /// Called when the program has read a picture, as long as the read framebuffer shows what it got. The
  /// region that was read, in pixels of that framebuffer. May be empty.
  std::function<void(const scene::Region&)> pictureRead;
  EngineChoice::Clock clock = nowSeconds;  // measures frames
  std::shared_ptr<Precedents> precedents;  // of these engines, for engine = auto; null: none
};

}  // namespace gluray::gl

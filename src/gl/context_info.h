// What a context is made with.
#pragma once
#include "base/clock.h"
#include "gl/draws/draw_kinds.h"
#include "gl/families/family.h"
#include "gl/window/engine_choice.h"
#include "settings/settings_source.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>

namespace gluray::gl {

struct ContextInfo {
  bool core = false;                       // core profile: no fixed function
  bool doubleBuffered = true;              // otherwise glFlush and glFinish show the picture
  bool off = false;                        // pass every call through
  Settings settings;                       // where there is no source
  const SettingsSource* source = nullptr;  // asked when the context is made, and when a frame begins
  /// Width and height of the window or pixmap that the context draws into, in pixels; {0, 0} if that is
  /// unknown. May be slow: asked only where a viewport is larger than what was known. Empty: never known.
  std::function<glm::ivec2()> drawableSize;
  std::shared_ptr<DrawKinds> kinds;            // takes what is drawn, by kind; null: nobody explains
  std::shared_ptr<const FamilyList> families;  // of shader programs; null: those that are built in
  /// Called before and after a frame of a single-buffered context ends. May be empty.
  std::function<void()> frameEnding, frameEnded;
  EngineChoice::Clock clock = nowSeconds;  // measures frames
};

}  // namespace gluray::gl

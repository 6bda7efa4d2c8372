// How a finished batch leaves the shadow GL: implemented in intercept/present/, by fakes in tests. GL thread.
#pragma once
#include "base/image.h"
#include "gl/programs/held_pass.h"
#include "gl/real.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {

/// What a framebuffer (0: the window) was last cleared to as a whole, depth to 1, nothing having been drawn
/// or sent into it since.
struct ClearedTarget {
  GLuint framebuffer = 0;
  scene::Region region;          // pixels
  std::array<float, 4> color{};  // as given to glClearColor
};

/// What the write-back must know about the framebuffer beside the snapshot. The framebuffer itself is bound
/// when present() is called.
struct PresentTarget {
  GLenum depthFunc = GL_LESS;  // LESS or LEQUAL: how the batch's depth meets the framebuffer's
  bool core = false;           // core profile: no fixed function
  bool rasterise = false;      // the instances are to be drawn by the real OpenGL, not traced
  std::vector<ProgramDraw> programDraws = {};  // those instances that shader programs draw
  // The instances were traced already: the depth of what is seen of them is made that which the real OpenGL
  // gives them, to the bit. Fixed function alone; nothing else changes.
  bool depthAgain = false;
  /// Then: or this mesh alone, which a shader program put there by a matrix.
  struct ByMatrix {
    scene::MeshPtr mesh;
    glm::dmat4 clipFromObject{1};
  } byMatrix = {};
  bool mayRepeat =
      true;  // where nothing has changed the last picture may do; false: what it costs is measured
  /// What lies under the whole region of the snapshot, if that is known and pictures may be sent instead of
  /// drawn; no stencil value in the framebuffer matters then.
  std::optional<ClearedTarget> cleared = {};
};

/// A picture for the window, which holds nothing else but what it was cleared to: misses have that colour,
/// and so has the rest of the window. Hits beyond the window depth `farthest` count as misses. The lower left
/// pixel is image.x, image.y of the window. Pictures of the same number are the same.
struct ShownPicture {
  const Image& image;
  float farthest;
  uint64_t number;
  int threads = 0;  // that may work on it; 0: all
};
/// Shows one. False where it could not: the window is as it was.
using ShowPicture = std::function<bool(const ShownPicture&)>;

struct ShowTarget {
  ClearedTarget cleared;  // the window
  float farthest = 1;
  bool core = false;      // core profile
  bool mayRepeat = true;  // as PresentTarget's
  const ShowPicture& show;
};

/// Where the pixels go that the samples of a picture come to.
struct ResolveTarget {
  scene::Resolve how;
  bool core = false;  // core profile
  bool colors = true, depths = true;
  /// RGBA8 texture of the resolved size that takes the colours; 0: the bound draw framebuffer does. Depths go
  /// there.
  GLuint texture = 0;
  bool mayRepeat = true;  // as PresentTarget's
};

/// What presenting cost and did.
struct PresentResult {
  enum Outcome {
    traced,      // colour and depth are in the framebuffer
    rasterised,  // tracing failed; the same instances were drawn by the real OpenGL
    failed,      // neither was possible
  } outcome = failed;
  double buildSeconds = 0, traceSeconds = 0, presentSeconds = 0;
  uint64_t blasBuilds = 0, blasRefinements = 0, bvhBytes = 0;
  bool blasRefining = false;  // a better acceleration structure is being built
  bool repeated = false;      // nothing had changed: the picture was there
  bool averages = false;      // pixels are averages of several rays
  /// One peel would not show all layers: how many there are. Rasterised, or the picture waits.
  std::optional<LayerCounts> layers;
  std::vector<uint32_t> picture;
  GLenum pendingError =
      GL_NO_ERROR;  // an error of the program's that was found on the way, to be reported to it
  std::string why;  // where it was not traced: one line for the user, who has not been told yet
};

/// Real objects that all contexts of a share group see.
struct SharedNames {
  std::vector<GLuint> lists, textures, programs;
};

/// A clear of the window's whole back buffer, as it was asked for.
struct WindowClear {
  GLbitfield mask = 0;
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  GLint stencil = 0;
};

/// What becomes of a picture that is traced ahead and that nobody presents.
struct Overdue {
  glm::ivec2 size{0};       // of the window in pixels
  GLenum buffer = GL_BACK;  // of it, where the picture goes
  std::chrono::steady_clock::duration after{};
  /// Shows the whole window: `size` pixels, RGBA8, bottom row first. Called by a thread of ours, `after` that
  /// time or when it is traced, whichever is later; while it runs present() waits. Empty: it waits for ever.
  std::function<void(const uint32_t* pixels)> show;
};

struct AheadTarget {
  GLenum depthFunc = GL_LESS;
  std::optional<ClearedTarget> cleared = {};  // the window, where it holds nothing else
  float farthest = 1;                         // then, as ShownPicture's
  Overdue overdue = {};
};

enum class LagRefusal : uint8_t;

class Presenter {
 public:
  virtual ~Presenter() = default;
  /// Traces `snapshot` and merges it into the bound framebuffer, leaving every queryable GL state as it was.
  /// Never throws.
  virtual PresentResult present(const RealGl& real, const scene::SnapshotPtr& snapshot,
                                const PresentTarget& target) noexcept = 0;
  /// Traces the layers of `snapshot` into `target.result`, or puts there the picture that waits. Where that
  /// fails, or `rasterise`, the real OpenGL makes the held passes instead. Otherwise as present().
  virtual PresentResult presentLayers(const RealGl&, const scene::SnapshotPtr&,
                                      const LayersTarget& /*target*/, bool /*rasterise*/) noexcept {
    return {};
  }
  /// Traces layers alone: their picture is in the result, as where presentLayers() lets it wait.
  virtual PresentResult traceLayers(const scene::SnapshotPtr&, const LayersTarget& /*target*/) noexcept {
    return {};
  }
  /// Traces `snapshot` and has its picture shown in the place of what is in the back buffer, which stays as
  /// it is. Otherwise as present(); not traced: nothing was shown.
  virtual PresentResult show(const RealGl&, const scene::SnapshotPtr&,
                             const ShowTarget& /*target*/) noexcept {
    return {};
  }
  /// Traces `snapshot`, whose framebuffer is multisampled, and writes the pixels it comes to into another,
  /// over all that is there. Otherwise as present(); not traced: nothing was drawn.
  virtual PresentResult resolve(const RealGl&, const scene::SnapshotPtr&,
                                const ResolveTarget& /*target*/) noexcept {
    return {};
  }
  /// Makes a pass for its fragments to be counted alone, where the texture that it reads has so many pixels
  /// that are not 0. False where that is not possible. Never throws.
  virtual bool countPixels(const RealGl&, const HeldPass&, GLuint /*texture*/, glm::ivec2 /*size*/,
                           uint64_t /*pixels*/) noexcept {
    return false;
  }
  /// Reads red and green of level 0 of the texture bound to GL_TEXTURE_2D of unit `unit`, `size` pixels of
  /// two floats. False where it is of another kind, or cannot be read. Never throws.
  virtual bool readDepths(const RealGl&, GLint /*unit*/, glm::ivec2 /*size*/,
                          std::vector<glm::vec2>& /*out*/) noexcept {
    return false;
  }
  /// Reads the bound draw framebuffer's window depths in `region`, lowest row first, one sample a pixel.
  /// False where there are none, or they cannot be read. No error may be pending. Never throws.
  virtual bool readDepth(const RealGl&, const scene::Region& /*region*/,
                         std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// The same of its colours, RGBA8 with red in the lowest byte, as they are kept.
  virtual bool readColors(const RealGl&, const scene::Region& /*region*/,
                          std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// Whether the write-back works with the current context (it needs shaders). Asked once per context, with
  /// it current.
  virtual bool supports(const RealGl& real, bool core, std::string& why) noexcept = 0;
  /// Does what the program's anti-aliasing pass would do: reads the texture bound to GL_TEXTURE_2D of unit
  /// `unit`, RGBA8 of the region's size, and replaces with the result that region of the draw framebuffer's
  /// colour attachment `target`, a texture. False where nothing was done. Never throws.
  virtual bool antialias(const RealGl&, const scene::Fxaa&, GLint /*unit*/, GLuint /*target*/,
                         const scene::Region&, const Settings&) noexcept {
    return false;
  }
  /// Begins to trace `snapshot`, whose framebuffer is the window's back buffer, while the program goes on;
  /// the next present() shall be of it, or dropAhead(). Says why it does not, LagRefusal::none if it does.
  /// The snapshot is not changed any more.
  virtual LagRefusal traceAhead(const RealGl&, const scene::SnapshotPtr&, const AheadTarget&) noexcept;
  /// Nobody wants the picture that is traced ahead.
  virtual void dropAhead() noexcept {}
  /// Clears the window's back buffer as `clear` says, whatever the state. Returns an error of the program's
  /// that was pending.
  virtual GLenum clear(const RealGl&, const WindowClear& /*clear*/) noexcept { return GL_NO_ERROR; }
  /// What it has made in the share group. Asked when the context goes away; the group deletes it.
  virtual SharedNames takeNames() { return {}; }
  /// A context is going away; it may or may not be current. Names made for it need not be freed.
  virtual void forget(const RealGl& real) noexcept = 0;
};

}  // namespace gluray::gl

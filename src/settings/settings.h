// What the user chose. A plain value: the control thread or the launcher makes one, each snapshot carries
// one.
#pragma once
#include "settings/quirks.h"

#include <cstdint>
#include <string>

namespace gluray {

/// How acceleration structures are built: `fast` first picture, `full` fastest rays, `compact` half the
/// memory, `least` a quarter; `automatic`: large geometry fast, then full while frames go on, or as memory
/// allows.
enum class BvhQuality : uint8_t { automatic, fast, full, compact, least };
/// Who draws: the ray tracer what it can (`always`), the real OpenGL everything (`never`), or whichever of
/// them was measured to be faster (`automatic`).
enum class Engine : uint8_t { automatic, always, never };
/// Where the lighting equation is evaluated: once a pixel for each surface that it shows, at the pixel's
/// centre; at the vertices as OpenGL's fixed function does (for exact comparison), the rest as `pixel`; or at
/// every sample of multisampled framebuffers.
enum class ShadingRate : uint8_t { pixel, vertex, sample };
/// Who makes the picture: Embree, or nobody (prices interception alone: every pixel is a miss).
enum class Renderer : uint8_t { embree, null };

/// Whether frames are traced while the program prepares the next one and shown then: never, always where it
/// can be, or while frames follow each other.
enum class LagMode : uint8_t { off, on, automatic };

constexpr int kMostSpp = 1024;

struct Settings {
  int threads =
      0;  // worker threads; 0 = all cores the process may use, shared with other MPI ranks on the host
  Engine engine = Engine::automatic;
  BvhQuality bvh = BvhQuality::automatic;
  ShadingRate shading = ShadingRate::pixel;
  Renderer renderer = Renderer::embree;
  int spp = 1;  // samples a pixel, where the framebuffer has one: edges are anti-aliased
  QuirkSet quirks;
  bool operator==(const Settings&) const = default;
};

/// What the launcher passes to the engine beside Settings; fixed for the life of the process.
struct Session {
  Settings settings;
  bool off = false;  // pass every call through, for comparison
  LagMode lag = LagMode::off;
  bool hud = false;          // figures in a corner of the window
  std::string reportFile;    // JSON written at exit; empty: none
  std::string logFile;       // empty: stderr
  std::string timelineFile;  // what each thread does when; empty: none
  std::string
      programFamilies;    // files that describe shader programs, separated by ':'; empty: built-in ones alone
  int explainFrames = 0;  // `gluray explain`: frames whose draws are recorded by kind; 0: nobody explains
  bool picture = false;   // and the last of them is kept as a picture, beside the report
  std::string logLevel = "warning";
};

/// Threads of one of `ranks` processes that share `cores` cores of a host, of which this one may run on
/// `allowed`: 0 (all it may use) where it runs alone or has cores of its own.
int threadsOfRank(int cores, int allowed, int ranks);

/// Reads GLURAY_THREADS, GLURAY_ENGINE, GLURAY_BVH, GLURAY_SHADING, GLURAY_RENDERER, GLURAY_SPP, GLURAY_LAG,
/// GLURAY_HUD, GLURAY_OFF, GLURAY_REPORT, GLURAY_LOG, GLURAY_LOG_LEVEL, GLURAY_TIMELINE, GLURAY_QUIRKS,
/// GLURAY_PROGRAM_FAMILIES, GLURAY_EXPLAIN, GLURAY_PICTURE. An unreadable value is reported once through
/// `complain` ("GLURAY_BVH=x: use auto, fast, full, compact or least") and the default kept.
Session sessionFromEnvironment(void (*complain)(const std::string& line));

}  // namespace gluray

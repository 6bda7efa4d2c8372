// Quirks: workarounds for what single OpenGL implementations do. Each has a name, a reason and a test, and
// can be switched (`--quirk NAME=off`). Any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace gluray {

// Identifier, name, what it is for, where it is tested. All but those below are on unless switched off.
#define GLURAY_QUIRKS(X)                                                                                    \
  X(materialLatch, "material-latch",                                                                        \
    "Mesa before 23 stores waiting glMaterial values twice where GL_COLOR_MATERIAL is enabled in between; " \
    "they are sent again after our own drawing, so that they wait as before",                               \
    "tests/reference/lists/material_latch_test.cpp")                                                        \
  X(fogSum, "fog-sum",                                                                                      \
    "Mesa does not clamp the sum of primary and secondary colour before it fades into fog; nor do we "      \
    "above Mesa",                                                                                           \
    "tests/reference/fragments/fog_test.cpp")                                                               \
  X(softwareFxaa, "software-fxaa",                                                                          \
    "VTK's anti-aliasing pass (FXAA) costs software OpenGLs more than tracing a frame; it is computed "     \
    "without them, to the same picture",                                                                    \
    "src/render/film/fxaa_test.cpp, tests/vtk (group effects)")                                             \
  X(sppFxaa, "spp-fxaa",                                                                                    \
    "VTK's anti-aliasing pass (FXAA) blurs pictures whose edges --spp has made smooth already; over "       \
    "nothing but those it is left out",                                                                     \
    "tests/reference/framebuffers/antialiased_picture_test.cpp")                                            \
  X(softwarePut, "software-put",                                                                            \
    "Mesa's llvmpipe takes milliseconds to draw a traced picture with its depth; where a framebuffer "      \
    "object "                                                                                               \
    "holds nothing but what it was cleared to, the picture is sent into its textures",                      \
    "tests/reference/framebuffers/texture_upload_test.cpp")                                                 \
  X(softwareShow, "software-show",                                                                          \
    "Mesa's llvmpipe takes milliseconds to draw a traced picture into a window's back buffer and to show "  \
    "that; where a window holds nothing but what it was cleared to, the X server gets the picture from us", \
    "tests/doors/show_test.py")                                                                             \
  X(softwareDepthBlit, "software-depth-blit",                                                               \
    "Mesa's llvmpipe blits depth by drawing it, which takes ten times as long as copying it; where a blit " \
    "neither moves, scales nor cuts it, it is copied",                                                      \
    "tests/reference/framebuffers/depth_blit_test.cpp")                                                     \
  X(softwareResolve, "software-resolve",                                                                    \
    "Multisampled framebuffers, which VTK has in windows, cost software OpenGLs more than tracing all "     \
    "their samples; where nothing but traced surfaces is in one, the pixels it is resolved to are made "    \
    "without it",                                                                                           \
    "tests/reference/framebuffers/resolve_test.cpp, tests/vtk (group effects)")                             \
  X(depthPeeling, "depth-peeling",                                                                          \
    "VTK composites translucent surfaces by drawing them again for every two layers; all layers are "       \
    "traced in one go, and the later passes find nothing left to do",                                       \
    "tests/reference/layers/peeling_test.cpp, tests/vtk (group translucent)")                               \
  X(hidePersistentMapping, "hide-persistent-mapping",                                                       \
    "What is written through a persistent mapping is not seen, so that draws from it are rasterised; "      \
    "programs that do not find GL_ARB_buffer_storage among the extensions write in ways that are seen. "    \
    "Off unless switched on: GLuRay changes no answer unasked",                                             \
    "tests/reference/engine/hidden_extensions_test.cpp")

enum class Quirk : uint8_t {
#define X(id, name, reason, test) id,
  GLURAY_QUIRKS(X)
#undef X
};
#define X(id, name, reason, test) +1
inline constexpr int kQuirkCount = 0 GLURAY_QUIRKS(X);
#undef X

struct QuirkText {
  std::string_view name, reason, test;
};
/// What is known of a quirk.
const QuirkText& describe(Quirk quirk);

/// Which quirks are switched on.
class QuirkSet {
 public:
  bool has(Quirk quirk) const { return !(off_ & bit(quirk)); }
  /// Switches the quirk of that name; false where there is none.
  bool set(std::string_view name, bool on);
  bool operator==(const QuirkSet&) const = default;

 private:
  static constexpr uint32_t bit(Quirk quirk) { return uint32_t{1} << static_cast<int>(quirk); }
  uint32_t off_ = bit(Quirk::hidePersistentMapping);
};

/// Reads "NAME=on|off", several separated by commas. Empty, or one line of what is wrong; then nothing of the
/// wrong entry is applied.
std::string readQuirks(std::string_view text, QuirkSet& quirks);
/// The text from which readQuirks() makes the same set: what is switched otherwise than at first.
std::string printQuirks(const QuirkSet& quirks);

/// The quirk has just made a difference: counted for reports, logged at the first time.
void noteUse(Quirk quirk) noexcept;
/// Times that noteUse() was called in this process.
uint64_t useCount(Quirk quirk) noexcept;

}  // namespace gluray

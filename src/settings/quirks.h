// Quirks: workarounds for single OpenGL implementations or programs. Each has a name, a reason and a test,
// and can be switched (`--quirk NAME=off`). Any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace gluray {

// Identifier, name, reason (shown to users), tests. All are on by default, except those in QuirkSet::off_.
#define GLURAY_QUIRKS(X)                                                                                     \
  X(materialLatch, "material-latch",                                                                         \
    "Mesa before 23 stores pending glMaterial values twice if GL_COLOR_MATERIAL is enabled in between; "     \
    "GLuRay sends them again after its own drawing, so that they are pending as before",                     \
    "tests/reference/lists/material_latch_test.cpp")                                                         \
  X(fogSum, "fog-sum",                                                                                       \
    "Mesa does not clamp the sum of primary and secondary colour before it applies fog; above Mesa, "        \
    "GLuRay does not either",                                                                                \
    "tests/reference/fragments/fog_test.cpp")                                                                \
  X(softwareFxaa, "software-fxaa",                                                                           \
    "VTK's anti-aliasing pass (FXAA) takes a software OpenGL longer than tracing a frame; GLuRay computes "  \
    "the same image itself",                                                                                 \
    "src/render/resolve/anti_alias_test.cpp, tests/vtk (group effects)")                                     \
  X(sppFxaa, "spp-fxaa",                                                                                     \
    "VTK's anti-aliasing pass (FXAA) blurs images whose edges --spp has made smooth already; GLuRay "        \
    "skips it where the framebuffer holds nothing else",                                                     \
    "tests/reference/framebuffers/antialiased_image_test.cpp")                                               \
  X(softwarePut, "software-put",                                                                             \
    "Mesa's llvmpipe takes milliseconds to draw a traced image with its depth; where a framebuffer "         \
    "object has only been cleared, GLuRay uploads the image into its textures",                              \
    "tests/reference/framebuffers/texture_upload_test.cpp")                                                  \
  X(softwareShow, "software-show",                                                                           \
    "Mesa's llvmpipe takes milliseconds to draw a traced image into a window's back buffer and to show "     \
    "that; where a window has only been cleared, GLuRay sends the image to the X server itself",             \
    "tests/doors/show_test.py")                                                                              \
  X(softwareDepthBlit, "software-depth-blit",                                                                \
    "Mesa's llvmpipe blits depth by drawing it, which takes ten times as long as copying it; GLuRay copies " \
    "it where a blit neither moves, scales nor clips it",                                                    \
    "tests/reference/framebuffers/depth_blit_test.cpp")                                                      \
  X(softwareResolve, "software-resolve",                                                                     \
    "Multisampled framebuffers, which VTK uses in windows, take a software OpenGL longer than tracing all "  \
    "their samples; where one holds only traced surfaces, GLuRay computes the resolved pixels itself",       \
    "tests/reference/framebuffers/resolve_test.cpp, tests/vtk (group effects)")                              \
  X(depthPeeling, "depth-peeling",                                                                           \
    "VTK composites translucent surfaces by drawing them again for every two layers; GLuRay traces all "     \
    "layers at once, and the later passes find nothing left to do",                                          \
    "tests/reference/layers/peeling_test.cpp, tests/vtk (group translucent)")                                \
  X(hidePersistentMapping, "hide-persistent-mapping",                                                        \
    "GLuRay cannot see writes through a persistent mapping, so draws from it are rasterised; programs that " \
    "do not find GL_ARB_buffer_storage among the extensions write in ways that GLuRay sees. Off by "         \
    "default, because GLuRay changes no answer of OpenGL unasked",                                           \
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
/// The name, reason and test of a quirk.
const QuirkText& describe(Quirk quirk);

/// Which quirks are switched on.
class QuirkSet {
 public:
  bool has(Quirk quirk) const { return !(off_ & bit(quirk)); }
  /// Switches the quirk of that name. Returns false if there is none.
  bool set(std::string_view name, bool on);
  bool operator==(const QuirkSet&) const = default;

 private:
  static constexpr uint32_t bit(Quirk quirk) { return uint32_t{1} << static_cast<int>(quirk); }
  uint32_t off_ = bit(Quirk::hidePersistentMapping);
};

/// Parses "NAME=on|off" entries, separated by commas. Skips wrong entries. Returns an error message, or an
/// empty string.
std::string readQuirks(std::string_view text, QuirkSet& quirks);
/// The quirks that differ from their default, as text for readQuirks().
std::string printQuirks(const QuirkSet& quirks);

/// Records that the quirk made a difference: counts it for reports, logs the first time.
void noteUse(Quirk quirk) noexcept;
/// Number of noteUse() calls in this process.
uint64_t useCount(Quirk quirk) noexcept;

}  // namespace gluray

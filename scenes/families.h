// The scenes by topic; scenes() strings them together.
#pragma once
#include "scenes/scene.h"

namespace gluray::scenes {

std::span<const Scene> primitiveScenes();
std::span<const Scene> lightScenes();
std::span<const Scene> materialScenes();
std::span<const Scene> textureScenes();
std::span<const Scene> mipmapScenes();
std::span<const Scene> combinerScenes();  // GL_COMBINE and several texture units
std::span<const Scene> texGenScenes();
std::span<const Scene> textureKindScenes();  // 3D, cube, rectangle, borders, formats
std::span<const Scene> surfaceScenes();      // culling, clipping, offset, depth range
std::span<const Scene> coincidentScenes();   // triangles upon others
std::span<const Scene> fragmentScenes();     // fog, alpha test
std::span<const Scene> passScenes();         // the same surface again
std::span<const Scene> layerScenes();        // cameras, viewports, clears, overlays
std::span<const Scene> rasterScenes();       // what is not traced, among what is
std::span<const Scene> listScenes();
std::span<const Scene> textureMixtureScenes();
std::span<const Scene> arrayScenes();
std::span<const Scene> readBackScenes();  // selection, feedback, reading and copying in mid-frame
std::span<const Scene> framebufferScenes();

}  // namespace gluray::scenes

#include "scenes/families.h"

#include <vector>

namespace gluray::scenes {

std::span<const Scene> scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> list;
    for (const auto family :
         {primitiveScenes(), lightScenes(), materialScenes(), textureScenes(), mipmapScenes(),
          combinerScenes(), texGenScenes(), textureKindScenes(), textureMixtureScenes(), surfaceScenes(),
          coincidentScenes(), fragmentScenes(), passScenes(), layerScenes(), rasterScenes(), listScenes(),
          arrayScenes(), readBackScenes(), framebufferScenes()})
      list.insert(list.end(), family.begin(), family.end());
    return list;
  }();
  return all;
}

const Scene* findScene(std::string_view name) {
  for (const auto list : {scenes(), variants()})
    for (const Scene& scene : list)
      if (name == scene.name) return &scene;
  return nullptr;
}

}  // namespace gluray::scenes

// Materials of draws, for files. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"
#include "saved/export/gather/scene_parts.h"
#include "saved/export/gather/shown_colors.h"
#include "scene/snapshot.h"

#include <array>
#include <deque>
#include <map>
#include <utility>

namespace gluray::saved {

/// What a draw's vertices get from its colours and textures.
struct ShownSurface {
  ExportedMaterial material;
  SourcePtr colors;                    // as ExportedMesh
  std::array<SourcePtr, 2> texcoords;  // likewise
  SourcePtr tangents;
};

class ShownSurfaces {
 public:
  ShownSurfaces(const Abilities& abilities, SceneParts& parts, Notes& notes)
      : abilities_(abilities), parts_(parts), notes_(notes) {}
  /// `honest`: the draw's surface without light; `given`: its shading in the snapshot, which must outlive
  /// this. Equal draws of a mesh share the result.
  const ShownSurface& of(const render::Surface& honest, const scene::Shading& given, const scene::Snapshot&,
                         const CornersPtr& corners);

 private:
  /// Whether what the draws' vertices get is the same, given the same mesh and shading.
  static bool isAlike(const scene::Shading&, const scene::Instance&, const scene::Instance&);

  const Abilities& abilities_;
  SceneParts& parts_;
  Notes& notes_;
  std::map<std::pair<const scene::Mesh*, const scene::Shading*>,
           std::deque<std::pair<const scene::Instance*, ShownSurface>>>
      known_;
};

}  // namespace gluray::saved

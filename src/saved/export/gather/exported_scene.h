// A frame as files of other programs have it: meshes with materials, placed by nodes. Plain data, made by
// gather_scene.h, written by the writers of the formats.
#pragma once
#include "frame/questions/viewer.h"
#include "saved/export/arrays/array_source.h"
#include "saved/export/arrays/png_encoder.h"
#include "scene/light_source.h"
#include "scene/texture.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gluray::saved {

/// An image with its sampler.
struct ExportedTexture {
  /// How texels become those of the file: as they are; with white in place of their colour (images of alpha
  /// alone); without alpha.
  enum class Texels : uint8_t { all, white, opaque };
  std::shared_ptr<const scene::TextureImage> image;
  Texels texels = Texels::all;
  scene::Wrap wrapS = scene::Wrap::repeat,
              wrapT = scene::Wrap::repeat;  // repeat, clampToEdge, mirroredRepeat
  scene::Filter magFilter = scene::Filter::linear, minFilter = scene::Filter::linear;
  scene::MipFilter mipFilter = scene::MipFilter::none;
  bool operator==(const ExportedTexture&) const = default;
};

/// A texture of a material; none if `texture` is negative.
struct TextureUse {
  int texture = -1;
  int coordinates = 0;  // index into ExportedMesh::texcoords
  bool operator==(const TextureUse&) const = default;
  explicit operator bool() const { return texture >= 0; }
};

/// Colours are values as they are displayed (sRGB), not linear light.
struct ExportedMaterial {
  enum class Alpha : uint8_t { opaque, mask, blend };
  glm::vec4 color{1};     // factor of vertex colours and of `base`
  glm::vec3 emission{0};  // factor of `emissionMap`
  bool unlit = false, doubleSided = true;
  Alpha alpha = Alpha::opaque;
  float cutoff = 0.5f;  // Alpha::mask: less is not drawn
  float metallic = 0, roughness = 1;
  float normalScale = 1, occlusionStrength = 1;
  TextureUse base, metallicRoughness, normal, occlusion, emissionMap;
  glm::vec3 specular{0};  // of classic materials
  float shininess = 0;
  bool operator==(const ExportedMaterial&) const = default;
};

/// Values of glTF.
enum class MeshMode : uint8_t { points = 0, lines = 1, triangles = 4 };

struct ExportedMesh {
  MeshMode mode = MeshMode::triangles;
  SourcePtr positions;                 // float3, all finite
  SourcePtr indices;                   // null: the vertices in their order
  SourcePtr normals;                   // float3 of unit length; null: flat
  SourcePtr tangents;                  // float4
  SourcePtr colors;                    // float4 or bytes4, displayed values; null: white
  std::array<SourcePtr, 2> texcoords;  // float2
  size_t material = 0;
  glm::vec3 lower{0}, upper{0};  // of all positions
  bool operator==(const ExportedMesh&) const = default;
  size_t elementCount() const { return indices ? indices->count() : positions->count(); }
};

struct ExportedNode {
  size_t mesh = 0;
  glm::dmat4 worldFromMesh{1};
  uint32_t object = 0;  // scene::ObjectNumber
};

struct ExportedLight {
  scene::LightSource source;  // world space, or if it follows the viewer, that of the camera
  bool followsViewer = false;
};

/// One view of the frame. The camera is missing where the format could not hold it.
struct ExportedView {
  std::vector<ExportedNode> nodes;
  std::optional<frame::CameraDescription> camera;
  double aspect = 1;  // width / height
  std::vector<ExportedLight> lights;
};

struct ExportedScene {
  std::vector<ExportedView> views;  // the one that shows most pixels is first
  std::vector<ExportedMesh> meshes;
  std::vector<ExportedMaterial> materials;
  std::vector<ExportedTexture> textures;
  std::set<std::string> notes;
  PngEncoder png;  // of textures
  void note(std::string text) { notes.insert(std::move(text)); }
};

/// What a format can hold.
struct Abilities {
  bool textures = true;    // otherwise their colours become those of vertices
  bool otherViews = true;  // several views
  bool camera = true;      // camera and lights
  bool lines = true;       // otherwise: a note
  bool instances = true;
  // Materials beside their colours: with highlights by roughness, with those of OpenGL, none.
  enum class Materials : uint8_t { physical, classic, none };
  Materials materials = Materials::physical;
};

}  // namespace gluray::saved

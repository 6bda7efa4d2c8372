#include "saved/export/formats/glb_buffer.h"

#include "saved/export/arrays/linear_colors.h"
#include "saved/export/formats/png_bytes.h"

namespace gluray::saved {
namespace {

using nlohmann::json;

constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedInt = 5125;

json formOf(Element element) {
  switch (element) {
    case Element::float2: return {{"componentType", kFloat}, {"type", "VEC2"}};
    case Element::float3: return {{"componentType", kFloat}, {"type", "VEC3"}};
    case Element::float4: return {{"componentType", kFloat}, {"type", "VEC4"}};
    case Element::shorts4: return {{"componentType", kUnsignedShort}, {"type", "VEC4"}, {"normalized", true}};
    default: return {{"componentType", kUnsignedInt}, {"type", "SCALAR"}};
  }
}

}  // namespace

size_t GlbBuffer::addPart(Part part, int target) {
  json view = {{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", part.size()}};
  if (target) view["target"] = target;
  bytes_ += (part.size() + 3) / 4 * 4;
  parts_.push_back(std::move(part));
  views_.push_back(std::move(view));
  return views_.size() - 1;
}

size_t GlbBuffer::accessor(const SourcePtr& source, int target) {
  const auto [at, fresh] = known_.emplace(source, accessors_.size());
  if (!fresh) return at->second;
  json accessor = formOf(source->element());
  accessor["bufferView"] = addPart({source, ""}, target);
  accessor["count"] = source->count();
  accessors_.push_back(std::move(accessor));
  return at->second;
}

size_t GlbBuffer::vertices(const SourcePtr& source) { return accessor(source, kArrayBuffer); }

size_t GlbBuffer::indices(const SourcePtr& source) { return accessor(source, kElementArrayBuffer); }

size_t GlbBuffer::positions(const SourcePtr& source, const glm::vec3& lower, const glm::vec3& upper) {
  const size_t index = vertices(source);
  accessors_[index]["min"] = {lower.x, lower.y, lower.z};
  accessors_[index]["max"] = {upper.x, upper.y, upper.z};
  return index;
}

size_t GlbBuffer::colors(const SourcePtr& source) {
  SourcePtr& linear = linear_[source];
  if (!linear) linear = linearColors(source);
  return vertices(linear);
}

size_t GlbBuffer::image(const ExportedTexture& texture, const PngEncoder& png) {
  const auto [at, fresh] =
      knownImages_.emplace(std::pair(texture.image.get(), texture.texels), images_.size());
  if (!fresh) return at->second;
  // OpenGL's first row is at t = 0, as the first row of a file is in glTF: texture coordinates stay as they
  // are.
  const size_t view = addPart({nullptr, pngOf(*texture.image, texture.texels, false, png)}, 0);
  images_.push_back({{"mimeType", "image/png"}, {"bufferView", view}});
  return at->second;
}

void GlbBuffer::describe(json& gltf) const {
  if (bytes_ == 0) return;
  gltf["buffers"] = json::array({{{"byteLength", bytes_}}});
  gltf["bufferViews"] = views_;
  if (!accessors_.empty()) gltf["accessors"] = accessors_;
  if (!images_.empty()) gltf["images"] = images_;
}

}  // namespace gluray::saved

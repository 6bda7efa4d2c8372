// The binary part of a glTF file: accessors and images, each once, in the order in which they were asked for.
// One thread.
#pragma once
#include "saved/export/gather/exported_scene.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gluray::saved {

class GlbBuffer {
 public:
  /// The accessor of an array of vertices or indices.
  size_t vertices(const SourcePtr&);
  size_t indices(const SourcePtr&);
  /// Those of positions have bounds.
  size_t positions(const SourcePtr&, const glm::vec3& lower, const glm::vec3& upper);
  /// The accessor of vertex colours, which are made linear.
  size_t colors(const SourcePtr&);
  /// The image of a texture.
  size_t image(const ExportedTexture&, const PngEncoder&);

  uint64_t bytes() const { return bytes_; }
  /// Adds bufferViews, accessors and images to a glTF object.
  void describe(nlohmann::json& gltf) const;
  /// Calls write(bytes, size) for the parts of the buffer; false where it returned false.
  template <class Write>
  bool writeTo(const Write& write) const {
    static constexpr char kZeros[4] = {};
    for (const Part& part : parts_) {
      const auto take = [&](const std::byte* data, size_t size) {
        return write(reinterpret_cast<const char*>(data), size);
      };
      if (part.source ? !takePieces(*part.source, take) : !write(part.bytes.data(), part.bytes.size()))
        return false;
      if (const size_t rest = part.size() % 4; rest && !write(kZeros, 4 - rest)) return false;
    }
    return true;
  }

 private:
  struct Part {  // an array or a file
    SourcePtr source;
    std::string bytes;
    size_t size() const { return source ? source->bytes() : bytes.size(); }
  };
  size_t accessor(const SourcePtr&, int target);
  size_t addPart(Part, int target);

  std::vector<Part> parts_;
  uint64_t bytes_ = 0;
  nlohmann::json views_ = nlohmann::json::array(), accessors_ = views_, images_ = views_;
  std::map<SourcePtr, size_t> known_;      // accessors
  std::map<SourcePtr, SourcePtr> linear_;  // of displayed colours
  std::map<std::pair<const scene::TextureImage*, ExportedTexture::Texels>, size_t> knownImages_;
};

}  // namespace gluray::saved

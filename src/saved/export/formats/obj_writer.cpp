#include "saved/export/formats/obj_writer.h"

#include "saved/export/formats/png_bytes.h"
#include "saved/export/formats/world_vertices.h"

#include <charconv>
#include <memory>

namespace gluray::saved {
namespace {

class Text {
 public:
  Text& word(std::string_view text) {
    out_ += text;
    return *this;
  }
  template <class Number>
  Text& number(Number value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out_ += ' ';
    out_.append(digits, end);
    return *this;
  }
  template <class Vector>
  Text& vector(const Vector& v) {
    for (int c = 0; c < Vector::length(); ++c) number(v[c]);
    return *this;
  }
  void end() { out_ += '\n'; }
  std::string& text() { return out_; }

 private:
  std::string out_;
};

std::string nameOf(size_t material) { return "material_" + std::to_string(material); }

/// Folder and name without ending.
std::string stemOf(const std::string& file) {
  const size_t dot = file.rfind('.'), slash = file.rfind('/');
  return dot != std::string::npos && (slash == std::string::npos || dot > slash) ? file.substr(0, dot) : file;
}

std::string baseName(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string imageName(const std::string& stem, int texture) {
  return stem + "_" + std::to_string(texture) + ".png";
}

std::string materialsText(const ExportedScene& scene, const std::string& stem) {
  Text out;
  out.word("# GLuRay " GLURAY_VERSION).end();
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    const ExportedMaterial& m = scene.materials[i];
    out.word("newmtl " + nameOf(i)).end();
    out.word("Ka 0 0 0").end();
    out.word("Kd").vector(glm::vec3(m.color)).end();
    out.word("Ks").vector(m.specular).end();
    if (m.specular != glm::vec3(0)) out.word("Ns").number(m.shininess).end();
    if (m.emission != glm::vec3(0)) out.word("Ke").vector(m.emission).end();
    if (m.alpha == ExportedMaterial::Alpha::blend) out.word("d").number(m.color.a).end();
    if (m.metallic != 0) out.word("Pm").number(m.metallic).end(), out.word("Pr").number(m.roughness).end();
    out.word(m.unlit ? "illum 0" : m.specular == glm::vec3(0) ? "illum 1" : "illum 2").end();
    if (m.base) {
      const ExportedTexture& t = scene.textures[static_cast<size_t>(m.base.texture)];
      const bool clamps = t.wrapS == scene::Wrap::clampToEdge && t.wrapT == scene::Wrap::clampToEdge;
      out.word(clamps ? "map_Kd -clamp on " : "map_Kd ")
          .word(baseName(imageName(stem, m.base.texture)))
          .end();
    }
  }
  return std::move(out.text());
}

/// Numbers of the first vertex, texture coordinate and normal of a mesh, from 1.
struct Firsts {
  size_t vertex = 1, texcoord = 1, normal = 1;
};

class Writer {
 public:
  explicit Writer(files::Draft& draft) : draft_(draft) {}

  bool add(const ExportedMesh& mesh, const glm::vec4& factor) {
    return addVertices(mesh, factor) && addElements(mesh);
  }

 private:
  bool addVertices(const ExportedMesh& mesh, const glm::vec4& factor) {
    return inPieces(mesh.positions->count(), [&](size_t first, size_t count) {
      const VertexPiece piece = vertexPiece(mesh, first, count);
      Text out;
      for (size_t i = 0; i < count; ++i) {
        out.word("v").vector(piece.positions[i]);
        if (!piece.colors.empty()) out.vector(glm::vec3(factor * piece.colors[i]));
        out.end();
      }
      for (const glm::vec2& at : piece.texcoords) out.word("vt").vector(at).end();
      for (const glm::vec3& n : piece.normals) out.word("vn").vector(n).end();
      return draft_.write(out.text());
    });
  }

  bool addElements(const ExportedMesh& mesh) {
    const size_t corners = mesh.mode == MeshMode::triangles ? 3 : mesh.mode == MeshMode::lines ? 2 : 1;
    const char* word = corners == 3 ? "f" : corners == 2 ? "l" : "p";
    const bool written = inPieces(mesh.elementCount(), [&](size_t first, size_t count) {
      const std::vector<uint32_t> indices = indexPiece(mesh, first, count);
      Text out;
      for (size_t i = 0; i < count; ++i) {
        if (i % corners == 0) out.word(word);
        out.number(indices[i] + firsts_.vertex);
        if (corners == 3) addReferences(mesh, indices[i], out);
        if (i % corners == corners - 1) out.end();
      }
      return draft_.write(out.text());
    });
    const size_t count = mesh.positions->count();
    firsts_.vertex += count;
    if (mesh.texcoords[0]) firsts_.texcoord += count;
    if (mesh.normals) firsts_.normal += count;
    return written;
  }

  /// "/vt/vn"
  void addReferences(const ExportedMesh& mesh, size_t index, Text& out) const {
    const auto reference = [&](size_t number) {
      out.word("/");
      if (number) out.word(std::to_string(number));
    };
    if (mesh.texcoords[0] || mesh.normals) reference(mesh.texcoords[0] ? index + firsts_.texcoord : 0);
    if (mesh.normals) reference(index + firsts_.normal);
  }

  files::Draft& draft_;
  Firsts firsts_;
};

}  // namespace

std::string writeObj(const ExportedScene& scene, const std::string& file, files::Draft& draft) {
  const std::string stem = stemOf(file);
  std::vector<std::unique_ptr<files::Draft>> others;
  const auto add = [&](const std::string& name, const std::string& content) {
    files::Draft& other = *others.emplace_back(std::make_unique<files::Draft>(name));
    return other.write(content) ? "" : baseName(name) + ": " + other.why();
  };
  std::string why = add(stem + ".mtl", materialsText(scene, stem));
  for (size_t i = 0; i < scene.textures.size() && why.empty(); ++i)
    why = add(imageName(stem, static_cast<int>(i)),
              pngOf(*scene.textures[i].image, scene.textures[i].texels, true, scene.png));
  if (!why.empty()) return why;

  Text head;
  head.word("# GLuRay " GLURAY_VERSION).end();
  head.word("mtllib " + baseName(stem) + ".mtl").end();
  if (!draft.write(head.text())) return "";
  Writer writer(draft);
  const std::vector<ExportedNode>& nodes = scene.views.front().nodes;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const ExportedMesh mesh = worldMesh(scene, nodes[i]);
    Text group;
    group.word(nodes[i].object ? "g object_" + std::to_string(nodes[i].object) + "_instance_"
                               : "g instance_");
    group.word(std::to_string(i)).end();
    group.word("usemtl " + nameOf(mesh.material)).end();
    if (!draft.write(group.text()) || !writer.add(mesh, scene.materials[mesh.material].color)) return "";
  }
  for (const auto& other : others)
    if (!other->place()) return other->why();
  draft.place();
  return "";
}

}  // namespace gluray::saved

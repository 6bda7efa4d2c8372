// Dual depth peeling as in VTK 9.1 (vtkDualDepthPeelingPass), for the tests of translucent surfaces.
#pragma once
#include "tests/reference/layers/layer.h"

#include <functional>
#include <map>
#include <vector>

namespace gluray::test {

class Peeler {
 public:
  explicit Peeler(Gl gl);

  /// Called between the steps of a frame. All may be empty.
  struct Hooks {
    std::function<void()> afterDepths, betweenSurfaces, afterFirstPeel;
  };
  /// Draws the opaque surfaces (opacity 1) and composites the others.
  void frame(const std::vector<Layer>& all, const Hooks& hooks = {});
  /// Peels that the last frame drew.
  int peels() const { return peels_; }
  /// Pixels that each of them wrote at the back.
  const std::vector<GLuint>& written() const { return written_; }
  GLuint depthsFound() const { return textures_[kDepthB]; }
  GLuint result() const { return textures_[kFrontB]; }
  int mostPeels = 4;
  GLuint threshold = 0;  // a peel that wrote so many pixels at the back, or fewer, is the last

  bool blendsRest = false;  // blends the layers that peels have left, in the order of drawing, as VTK does

  enum Stage { kOpaque, kDepths, kPeel, kRest };

 private:
  enum Texture { kBackTemp, kBack, kFrontA, kFrontB, kDepthA, kDepthB, kOpaqueDepth, kTextures };
  struct Ready {
    GLuint program = 0;
    Upload upload;
  };
  void attach(std::initializer_list<Texture> textures);
  void clearTo(std::initializer_list<Texture> textures, float red, float green);
  void bind(int unit, Texture texture);
  void fullScreen(GLuint program, std::initializer_list<std::pair<const char*, int>> samplers);
  void draw(Stage stage, const Layer& one, size_t number);
  void drawAll(Stage stage, const std::vector<Layer>& all, const std::function<void()>& between = {});
  bool peel(const std::vector<Layer>& all, Texture front, Texture frontNext, Texture depths,
            Texture depthsNext, const Hooks& hooks);

  Gl gl_;
  GLuint framebuffer_ = 0, textures_[kTextures] = {}, query_ = 0, screen_ = 0, corners_ = 0;
  GLuint copyDepth_ = 0, blendBack_ = 0, merge_ = 0;
  std::map<std::pair<int, size_t>, Ready> ready_;  // by stage and number of the surface
  int peels_ = 0;
  std::vector<GLuint> written_;
};

}  // namespace gluray::test

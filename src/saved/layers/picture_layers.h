// The layers of an OpenEXR picture, in bands as its colours. One thread.
#pragma once
#include "frame/tracing/renderer.h"
#include "saved/layers/layer_list.h"
#include "saved/layers/sample_tracer.h"
#include "saved/layers/surface_names.h"
#include "saved/shot/shot.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace gluray::saved {

/// Per pixel, of opaque traced surfaces: the albedo is the mean of the samples that the picture's colours
/// have, times what they cover; Cryptomatte names them by coverage. Depth, position and normal are those of
/// the sample at the pixel's centre or, if that shows no surface, of the one nearest to it that does.
class PictureLayers {
 public:
  static constexpr float kNoDepth = 1e10f;  // where no surface is
  /// Leaves out layers that the scene cannot give. `shot` and `renderer` must outlive it.
  PictureLayers(const Shot& shot, frame::Renderer& renderer, const std::vector<Layer>& wanted);

  /// Those that there are.
  const std::vector<Layer>& layers() const { return layers_; }
  /// Values of a pixel.
  size_t channels() const;
  /// Attributes of the file's header.
  std::vector<std::pair<std::string, std::string>> texts() const;
  /// What is left out, and why; a line each.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Writes the values of band `number`, top row first: pixel i has channels() values from to[i * stride] on.
  /// Throws std::runtime_error with one line.
  void write(int number, float* to, size_t stride);

 private:
  class Strip;
  bool has(Layer layer) const;
  void leaveOut(Layer layer, const std::string& why);

  const Shot& shot_;
  std::vector<Layer> layers_;
  std::vector<std::string> notes_;
  SurfaceNames names_;
  std::vector<float> objects_, materials_;  // Cryptomatte's ids of surfaces
  PixelSamples samples_;
  SampleTracer tracer_;
};

}  // namespace gluray::saved

// Edge-stopping wavelet denoiser for light. Any thread; pure.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>

namespace gluray::render {

/// Guides of the filter, row by row. Packed by packReflectances() and packGeometry().
struct FeatureView {
  const uint32_t* reflectance = nullptr;  // reflectance: three mantissas, one exponent
  const uint32_t* normal = nullptr;       // two coordinates (GeometryFeatures: a, b), 16 bits each
  const uint16_t* facing = nullptr;       // c: the leading bits of a float
  const float* distance = nullptr;        // d; 0: no auxiliary features, so that the pixel does not change
  // Light that is left as it is, packed as the reflectance; null: none.
  const uint32_t* noiseless = nullptr;
  // Of pixels that mix several samples or layers (render/resolve/mixed_features.h); null: of none. Packed by
  // packCoverage(); below 0: the pixel shows only a shadow catcher, and its light is its alpha.
  const uint16_t* coverage = nullptr;
  // Standard error of the distance from the plane, in widths of a pixel; packed by packCoverage(). Null: 0.
  const uint16_t* spread = nullptr;
};

/// A noisy image with an estimate of its noise.
struct NoisyImage {
  int width = 0, height = 0;
  const float* color = nullptr;     // RGBA
  const uint16_t* noise = nullptr;  // estimated standard error, kNoiseOne being 1; null: not known
  FeatureView features;
  float target = 0;  // pixels with less noise do not change
  // Brighter values are clamped to it.
  float most = std::numeric_limits<float>::max();
  bool backdrop = false;  // what lies behind the surfaces has colours of its own; otherwise it is black
};

constexpr float kNoiseOne = 65535;
/// The brightest colour that filters of displayed images average. More than 1, so that noise does not darken
/// what is nearly white; not much more, so that single bright samples do not show around their pixels.
constexpr float kBrightest = 1.5f;

/// Packs the auxiliary features of `count` pixels from the wide colours of passes of the modes reflectance
/// and geometry. Pixels with depth `miss` show no surface.
void packReflectances(const float* reflectance, size_t count, uint32_t* packed);
void packGeometry(const float* geometry, const float* depth, size_t count, uint32_t* normal, uint16_t* facing,
                  float* distance);

/// A square of the image that is filtered in one call.
struct WaveletTile {
  static constexpr int kLastStep = 4;  // pixels from a neighbour to the next one in the last round
  static constexpr int kSize = 64, kReach = 4 * kLastStep;  // kReach: pixels read beyond its border
  int x = 0, y = 0;                                         // its corner
};

/// An edge-stopping wavelet transform of light, that is colour divided by reflectance (H. Dammertz and
/// others, "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering", 2010): three
/// rounds of 5 x 5 pixels 1, 2 and 4 apart. Neighbours count that lie on the plane of the pixel, with
/// about its normal and reflectance, and whose light differs by no more than the noise allows (C. Schied and
/// others, "Spatiotemporal Variance-Guided Filtering", 2017). Differs: weights are Tukey's biweights, which
/// end, so that nothing crosses an edge; and opposite neighbours of the same surface count together, by how
/// much their mean differs, so that light that rises evenly is smoothed as far as even light. A pixel gets
/// the share 1 - (target / noise)^2 of its smoothed light: none where its noise is no more than the target.
/// Where noise is not known it is the deviation among neighbours. Pixels that mix surfaces get the light of
/// these from their neighbours (unmix.inl.h). Writes kSize x kSize RGBA to `out`, row by row, as far as they
/// are inside. False: all pixels stay, and nothing was written. `memory`: waveletFloats() floats.
bool smoothTile(const NoisyImage&, const WaveletTile&, float* memory, float* out);
size_t waveletFloats();

}  // namespace gluray::render

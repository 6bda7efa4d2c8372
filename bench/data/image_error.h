// The error of an image against its reference, on the pixels that show a surface.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::bench {

/// Peak signal-to-noise ratio in dB over the three colour channels of RGBA8 pixels where `hit` is not 0;
/// 99 where they are equal. All three have the same size.
double psnr(const std::vector<uint32_t>& image, const std::vector<uint32_t>& reference,
            const std::vector<uint8_t>& hit);

}  // namespace gluray::bench

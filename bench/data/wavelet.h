// The Wavelet: an analytic test volume, the same data as ParaView's "Wavelet" source. Benchmarks only.
#pragma once
#include "bench/data/volume.h"

#include <vector>

namespace gluray::bench {

/// The field at each integer point of [-halfExtent, halfExtent]^3:
///   255 exp(-r^2 / (2 * 0.5^2)) + 10 sin(60 x) + 18 sin(30 y) + 5 cos(40 z),
/// x, y, z being the point divided by 2 * halfExtent, r its length. With halfExtent 100 the values
/// span 33.951..286.341. Source: vtkRTAnalyticSource with its default parameters.
Volume wavelet(int halfExtent = 100);

/// `count` isovalues spread over [low, high]: low + (i + 0.5) / count * (high - low).
std::vector<float> evenIsovalues(float low, float high, int count);

/// How many even isovalues of the 201^3 Wavelet give about so many million triangles: 1, 4, 16, 64, 128, 256
/// as in the benchmark's tables (3 surfaces are 0.87 million triangles, 14 4.1, 55 16.1, ...), others in
/// proportion; >= 1.
int waveletSurfaces(double millionTriangles);

}  // namespace gluray::bench

// Lines through a vector field, and tubes around lines. Benchmarks only; runs on all threads.
#pragma once
#include "bench/data/triangle_mesh.h"

#include <array>
#include <functional>
#include <vector>

namespace gluray::bench {

using Point = std::array<double, 3>;
using Line = std::vector<Point>;

/// A vector field; called on all threads at once.
using Field = std::function<Point(const Point&)>;
/// Whether a line goes on at a point.
using Within = std::function<bool(const Point&)>;

/// The line through `seed` along the field's direction, in steps of length `step`, `segments` at most: it
/// ends where `within` says so or where the field vanishes. Runge and Kutta's method of fourth order on the
/// direction, so that the steps are of equal length.
Line streamline(const Field& field, const Point& seed, double step, int segments, const Within& within);

/// The line with exactly `segments` pieces of equal length; as it is where it has fewer than two points.
Line resampled(const Line& line, int segments);

/// Triangles of the tube around a line of so many pieces: 2 * sides * segments + 2 * (sides - 2).
size_t tubeTriangles(size_t segments, int sides);

/// Closed tubes with `sides` sides, sides >= 3, around the lines, one after the other in one mesh; lines of
/// fewer than two points, or two of them in a row that are the same, have none. The rings are carried along
/// without twist. Throws std::runtime_error where
/// there are more than 2^32 vertices. Source: Wang, Juettler, Zheng and Liu, Computation of Rotation
/// Minimizing Frames, 2008.
TriangleMesh tubes(const std::vector<Line>& lines, double radius, int sides);

}  // namespace gluray::bench

// Data that stand in for those of the paper's evaluation, which are not public: made from formulae, so that
// everybody has the same. All lie within kReach of the origin, as the Wavelet does, so that one camera serves
// all. Benchmarks only; runs on all threads.
#pragma once
#include "bench/data/triangle_mesh.h"
#include "bench/data/tubes.h"

namespace gluray::bench {

inline constexpr double kReach = 173.3;  // world units

/// In place of the paper's Richtmyer-Meshkov instability (316 million triangles): one surface between two
/// fluids that mix, about level, with bubbles, spikes and drops of down to a hundredth of its width; it is
/// open at its sides.
TriangleMesh mixingInterface(double millionTriangles);

/// In place of the paper's VPIC plasma (102 million): two sheets of a current that tears itself apart, an
/// isosurface with four tenths of the triangles, and tubes along the magnetic field around it with the rest.
TriangleMesh plasma(double millionTriangles);

/// In place of the paper's star (86 million): tubes along the magnetic field outside a sphere, that of a
/// dipole and of spots in its surface. 86 million triangles are 48,000 tubes of 149 pieces and six sides;
/// others have tubes in proportion.
TriangleMesh star(double millionTriangles);

/// Moves a mesh in units of a grid's cells to where the grid lies: its first point at origin, others in steps
/// of `step`, all of it `scale` times larger.
void place(TriangleMesh& mesh, const std::array<float, 3>& origin, float step, float scale);

/// The lines of star(), in the order of its tubes, followed in steps of `step`, all of `pieces` pieces.
inline constexpr int kStarSegments = 149;
std::vector<Line> starLines(int count, double step = 1, int pieces = kStarSegments);
/// How many lines star() has.
int starLineCount(double millionTriangles);

}  // namespace gluray::bench

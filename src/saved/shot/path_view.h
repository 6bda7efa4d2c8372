// Views of a saved scene from the cameras of a path. Any thread.
#pragma once
#include "saved/shot/view_camera.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace gluray::saved {

/// The saved view, as a camera in the program's world space. OpenGL knows only products of matrices: where
/// the world ends and objects' own transforms begin must be found out.
struct KnownView {
  ViewCamera camera;
  scene::SnapshotPtr batch;    // one that this camera shows
  glm::dmat4 eyeFromWorld{1};  // of that batch's eye space; its lengths may be others
};

/// Finds which of these cameras is that of the saved view: some surface's object space must be the world in
/// which the camera stands, looks and opens as the program's matrices say. `stated`: there is one camera,
/// which somebody says is the saved view's: then it is enough that some surface's axes are the world's.
/// Throws std::runtime_error with one line.
KnownView knownView(const std::vector<scene::SnapshotPtr>& batches, std::span<const ViewCamera> cameras,
                    bool stated);

/// The matrix from the world to the eye space of the known view's batch, as seenFrom() moves it for the
/// camera: that of known.eyeFromWorld for the known camera. Throws std::runtime_error with one line if the
/// camera cannot be.
glm::dmat4 eyeFromWorld(const KnownView& known, const ViewCamera& camera);

/// The batches as the camera sees them. Batches of the known view's camera are seen from there; others, such
/// as orientation markers, turn about their own middle. Lights stay at the camera. The near and far planes
/// enclose the surfaces. Throws std::runtime_error with one line if the camera cannot be.
std::vector<scene::SnapshotPtr> seenFrom(const std::vector<scene::SnapshotPtr>& batches,
                                         const KnownView& known, const ViewCamera& camera);

}  // namespace gluray::saved

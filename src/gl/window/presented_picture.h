// A traced picture that the user sees in a window already, while the window's back buffer still holds what it
// was cleared to. Software OpenGLs take longer to take a picture with its depth and to hand it on than a
// window system to show it, and most programs clear it away unseen. Where anything else happens to the back
// buffer, the picture is written there first. Owned by Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/programs/program_draw.h"
#include "scene/snapshot.h"

#include <optional>
#include <vector>

namespace gluray::gl {

struct PresentedPicture {
  struct Waiting {
    BatchKey key;
    scene::SnapshotPtr snapshot;
    std::vector<ProgramDraw> draws;
  };
  std::optional<Waiting> waiting;
  /// Pictures in a row that had to be written after all: programs that go on drawing are better off with the
  /// old way.
  int inVain = 0;
  int pause = 0;  // frames that are not tried
};

}  // namespace gluray::gl

// How the mouse and keys move a camera. Pure functions; any thread.
#pragma once
#include "saved/program/view.h"

namespace gluray::panel {

/// Where a picture shows what: the window's view fills it, as --fit all says.
struct ViewShape {
  int windowWidth = 1, windowHeight = 1;    // pixels
  int pictureWidth = 1, pictureHeight = 1;  // pixels

  /// Pixels of the picture for the height of the window's view.
  double viewPixels() const;
  /// The smaller half of the window's view, by half its height.
  double narrow() const {
    return windowWidth < windowHeight ? static_cast<double>(windowWidth) / windowHeight : 1;
  }
};

/// Goes around a point: `right` and `up` in degrees, about the view's own axes.
GlurayCamera turned(const GlurayCamera& camera, const double (&pivot)[3], double right, double up);
/// Moves what the camera looks at by pixels of the picture, to the right and downwards.
GlurayCamera shifted(const GlurayCamera& camera, const ViewShape& shape, double right, double down);
/// Things become larger by this factor.
GlurayCamera zoomed(const GlurayCamera& camera, double factor);
/// Looks at a point in the same direction, from as far away.
GlurayCamera centredOn(const GlurayCamera& camera, const double (&point)[3]);
/// Shows a whole ball, in the same direction.
GlurayCamera fitted(const GlurayCamera& camera, const ViewShape& shape, const double (&middle)[3],
                    double radius);

bool areEqual(const GlurayCamera& a, const GlurayCamera& b);

}  // namespace gluray::panel

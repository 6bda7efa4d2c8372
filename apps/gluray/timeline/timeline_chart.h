// A timeline as a Gantt chart: the whole run, and a few frames of it from near.
#pragma once
#include "timeline/timeline_file.h"

#include <iosfwd>

namespace gluray::launcher {

/// Milliseconds since the beginning of the run.
struct Stretch {
  double from = 0, to = 0;
};

/// Some frames from the middle of the run; where there are none, its middle.
Stretch typicalFrames(const Timeline& timeline);

/// Writes SVG.
void writeChart(const Timeline& timeline, const Stretch& near, std::ostream& out);

/// Prints how long each thread did what, and how often.
void printTimes(const Timeline& timeline, std::ostream& out);

}  // namespace gluray::launcher

// Draws a timeline as a Gantt chart: the whole run, and a close-up of a few frames.
#pragma once
#include "timeline/timeline_file.h"

#include <iosfwd>

namespace gluray::launcher {

/// A stretch of time, in milliseconds since the beginning of the run.
struct Stretch {
  double from = 0, to = 0;
};

/// Five frames from the middle of the run; five batches if it has no frames; or its middle tenth.
Stretch typicalFrames(const Timeline& timeline);

/// Writes the chart as SVG: the whole run, and the close-up `near`.
void writeChart(const Timeline& timeline, const Stretch& near, std::ostream& out);

/// Prints, for each thread and kind of span, how many there were and how long they took.
void printTimes(const Timeline& timeline, std::ostream& out);

}  // namespace gluray::launcher

#include "timeline/show_timeline.h"

#include "base/files.h"
#include "base/printable.h"
#include "say.h"
#include "timeline/timeline_chart.h"

#include <iostream>
#include <sstream>
#include <stdexcept>

namespace gluray::launcher {

int showTimeline(const CommandLine& line) {
  const Timeline timeline = readTimeline(line.program[0]);
  if (timeline.spans.empty())
    throw std::runtime_error(line.program[0] + " is empty: nothing that the program drew was traced");
  // If the chart goes to standard output, the table goes to standard error.
  printTimes(timeline, files::isOutput(line.chart) ? std::cerr : std::cout);
  if (line.chart.empty()) return 0;
  Stretch near = typicalFrames(timeline);
  if (line.from >= 0) near.from = line.from;
  if (line.to >= 0) near.to = line.to;
  if (!(near.from < near.to)) throw std::runtime_error("--from must be before --to");
  std::ostringstream chart;
  writeChart(timeline, near, chart);
  writeFile(line.chart, chart.str());
  if (!files::isOutput(line.chart)) std::cout << "written: " << printable(line.chart) << "\n";
  return 0;
}

}  // namespace gluray::launcher

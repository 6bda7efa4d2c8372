#include "show_timeline.h"

#include "timeline_chart.h"

#include <fstream>
#include <iostream>
#include <stdexcept>

namespace gluray::launcher {

int showTimeline(const CommandLine& line) {
  const Timeline timeline = readTimeline(line.program[0]);
  if (timeline.spans.empty())
    throw std::runtime_error(line.program[0] + " holds nothing: the program drew nothing that was traced");
  printTimes(timeline, std::cout);
  if (line.chart.empty()) return 0;
  Stretch near = typicalFrames(timeline);
  if (line.from >= 0) near.from = line.from;
  if (line.to >= 0) near.to = line.to;
  if (!(near.from < near.to)) throw std::runtime_error("--from must be before --to");
  std::ofstream out(line.chart);
  writeChart(timeline, near, out);
  out.close();
  if (!out) throw std::runtime_error("cannot write " + line.chart);
  std::cout << "written: " << line.chart << "\n";
  return 0;
}

}  // namespace gluray::launcher

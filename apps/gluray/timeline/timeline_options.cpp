#include "timeline/timeline_options.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {

void describeTimeline(CLI::App& app, CommandLine& line) {
  app.description("Prints the work of each thread in a run with --timeline FILE, and draws a chart of it.");
  app.name("gluray timeline");
  app.add_option("FILE", line.program, "A file written by --timeline")->required()->expected(1);
  app.add_option("-o", line.chart, "Draw a chart (SVG): the whole run, and a close-up of some frames")
      ->type_name("CHART.svg");
  app.add_option("--from", line.from, "Start of the close-up [in the middle of the run]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MS");
  app.add_option("--to", line.to, "End of the close-up [some frames later]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MS");
}

}  // namespace gluray::launcher

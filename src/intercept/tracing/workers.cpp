#include "intercept/tracing/workers.h"

#include "base/environment_variable.h"
#include "base/log.h"
#include "control/link/job.h"
#include "control/runtime_directory.h"
#include "intercept/session/session.h"
#include "intercept/tracing/shared_renderer.h"

#include <charconv>
#include <string>

namespace gluray::intercept {
namespace {

/// Rank of this process among the job's processes on this machine, from variables of MPI's launchers; 0
/// without a job.
int rankOnMachine() {
  for (const char* const name : {"OMPI_COMM_WORLD_LOCAL_RANK", "MPI_LOCALRANKID", "SLURM_LOCALID"}) {
    const std::string text = environmentVariable(name);
    int rank = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rank);
    if (error == std::errc() && end == text.data() + text.size() && rank >= 0) return rank;
  }
  return 0;
}

}  // namespace

bool traceHere(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
               const std::function<bool()>& stop) {
  frame::Renderer& renderer = sharedRenderer();
  return stop ? renderer.renderBehind(snapshot, image, cost, error, stop)
              : renderer.render(snapshot, image, cost, error);
}

cluster::RemoteTracer* workers() {
  static cluster::RemoteTracer* const job = [] {
    const std::string& name = session().workers;
    if (name.empty()) return static_cast<cluster::RemoteTracer*>(nullptr);
    const control::Job mpi = control::jobOfThisProcess();
    return new cluster::RemoteTracer(control::runtimeDirectory(), name,
                                     {rankOnMachine(), mpi.name, mpi.rank, mpi.ranks}, traceHere,
                                     [](const std::string& line) { log::write(log::Level::warning, line); });
  }();
  return job;
}

}  // namespace gluray::intercept

// Where the workers of a job listen on their machine. Any thread.
#pragma once
#include "cluster/local/line.h"

#include <optional>
#include <string>

namespace gluray::cluster {

/// "worker-JOB.PLACE": the stem of the names of a worker's files in the runtime directory.
std::string workerPlace(const std::string& job, int place);
/// Why no job may have this name; empty: it may.
std::string whyNoJobName(const std::string& job);
/// A connection to the worker of the job whose socket is in `directory`; of several, that of the place
/// `onMachine`. None: `why` says in one line why not and what to do.
std::optional<Line> lineToWorker(const std::string& directory, const std::string& job, int onMachine,
                                 std::string& why);

}  // namespace gluray::cluster

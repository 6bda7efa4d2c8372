// Socket names of a job's workers on a machine. Any thread.
#pragma once
#include "cluster/local/line.h"

#include <optional>
#include <string>

namespace gluray::cluster {

/// "worker-JOB.PLACE": the stem of the names of a worker's files in the runtime directory.
std::string workerPlace(const std::string& job, int place);
/// Reason why a job name is invalid; empty: valid.
std::string whyNoJobName(const std::string& job);
/// Connects to the worker of the job whose socket is in `directory`; if there are several, to the one at
/// `onMachine`. None on failure, with the reason and a remedy in one line in `why`; `isNobody`: because none
/// runs.
std::optional<Line> lineToWorker(const std::string& directory, const std::string& job, int onMachine,
                                 std::string& why, bool* isNobody = nullptr);

}  // namespace gluray::cluster

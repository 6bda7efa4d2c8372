// Queries a job of workers about its ranks and hosts, for `gluray doctor --job`. Any thread.
#pragma once
#include "cluster/messages/program_messages.h"

#include <optional>
#include <string>

namespace gluray::cluster {

/// Returns the properties of all ranks of the job whose sockets are in `directory`. Waits for seconds if
/// ranks do not answer. None on failure, with one line in `why`.
std::optional<JobFacts> askJob(const std::string& directory, const std::string& job, std::string& why);

}  // namespace gluray::cluster

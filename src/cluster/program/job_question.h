// Asks a job of workers about its ranks and their hosts, for `gluray doctor --job`. Any thread.
#pragma once
#include "cluster/messages/program_messages.h"

#include <optional>
#include <string>

namespace gluray::cluster {

/// The facts of all ranks of the job whose sockets are in `directory`. Waits for seconds where ranks do not
/// answer. None: `why` says in one line why not.
std::optional<JobFacts> askJob(const std::string& directory, const std::string& job, std::string& why);

}  // namespace gluray::cluster

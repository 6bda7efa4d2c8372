// What the facts of a job's ranks mean: the findings of `gluray doctor --job`. Pure functions.
#pragma once
#include "cluster/messages/program_messages.h"
#include "doctor/diagnosis.h"

#include <string>
#include <vector>

namespace gluray::launcher {

/// Adds a line for the job, one for each rank that has answered, and one for each fault.
void judgeJob(const std::string& job, const cluster::JobFacts& facts, Diagnosis& diagnosis);

/// "rank 3", "ranks 0-2, 5". `ranks` rise.
std::string ranksText(const std::vector<int>& ranks);

}  // namespace gluray::launcher

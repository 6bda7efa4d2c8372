// The faults that the facts of a job's ranks show, each with what to do. Pure functions.
#pragma once
#include "cluster/messages/program_messages.h"
#include "doctor/diagnosis.h"

#include <string>

namespace gluray::launcher {

/// Adds a finding for each fault: ranks of other versions or of another MPI, ranks that do not answer, bound
/// to one core, or with more threads than cores; hosts with little memory or a full /dev/shm.
void findFaults(const cluster::JobFacts& facts, Diagnosis& diagnosis);

/// Whether the rank has answered in the language of this version, so that all its facts are there.
bool isKnown(const cluster::RankFacts& rank);
/// "31.2".
std::string inGigabytes(uint64_t bytes);

}  // namespace gluray::launcher

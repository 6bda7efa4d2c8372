// The report of an MPI program whose images workers trace: rank 0 writes one for all ranks, who send their
// figures through the workers. Any thread.
#pragma once
#include "control/link/job.h"

#include <nlohmann/json_fwd.hpp>

namespace gluray::intercept {

/// The MPI job of this process, as reports count it: one rank while `gluray explain` watches, which reads a
/// report of each.
const control::Job& jobOfReport();

/// Whether this process leaves the report to rank 0: it is another rank, and its worker answers, or was not
/// asked yet.
bool isReportedByRankZero() noexcept;

/// The members `ranks`, `workers` and `limit` of rank 0's report; null for all other processes. At the end of
/// the process it waits up to half a second for the other ranks, otherwise a few milliseconds.
nlohmann::json reportOfRanks(bool atEnd);

/// A row of each rank, as of the last images, while somebody observes this program (gluray top); null unless
/// it is rank 0 of an MPI program whose images workers trace. Any thread, also without the process's
/// descriptors.
nlohmann::json observedRanks();

/// At the end of the process: its row says from now on that it ended by itself.
void sayEndToRankZero() noexcept;

}  // namespace gluray::intercept

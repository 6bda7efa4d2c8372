// Lines that several ranks of an MPI job would say on one host: the first that says a line claims it for the
// host. Claims are empty files in the runtime directory. Any thread.
#pragma once
#include "control/link/job.h"

#include <string>

namespace gluray::control {

/// Whether this rank is to say the line: it has said it before, or no other rank of the job on this host has.
/// True for all that are no ranks, and where no claim can be made. `directory`: the runtime directory.
/// `began`: when the process began, in seconds since 1970; claims that are a minute older are of an earlier
/// job of the same name.
bool saysLine(const Job& job, const std::string& line, const std::string& directory, double began);

/// The line with the rank that says it: "LINE (rank 3 of 16; once on this host)". Of all that are no ranks,
/// the line itself.
std::string withRank(const Job& job, const std::string& line);

/// For this process: false, or changes the line to withRank().
bool saysLineHere(std::string& line) noexcept;

}  // namespace gluray::control

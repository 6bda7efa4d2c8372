// Collects properties of this process and its host, from /proc, /sys and system calls. Any thread.
#pragma once
#include "cluster/messages/fact_messages.h"
#include "cluster/ranks/ranks.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace gluray::cluster {

/// Host name; empty: none.
std::string hostName();
/// `threads`: tracing threads of this rank. Sets all members except `answered`.
RankFacts factsOf(const Ranks& ranks, int threads);

/// The value of a line "NAME:   VALUE" of a file of /proc; empty: there is none.
std::string lineOf(std::string_view text, std::string_view name);
/// Bytes of "31234 kB"; 0: it is no such text.
uint64_t memoryOf(std::string_view kilobytes);
/// Number of cores in "0-3,8"; 0: it is no such list.
int countCores(std::string_view list);
/// The word in brackets of "always [madvise] never"; empty: there is none.
std::string chosenWord(std::string_view text);

}  // namespace gluray::cluster

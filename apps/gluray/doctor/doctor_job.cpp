#include "doctor/doctor_job.h"

#include "cluster/program/job_question.h"
#include "cluster/program/worker_place.h"
#include "control/runtime_directory.h"
#include "doctor/job_findings.h"
#include "say.h"

#include <iostream>
#include <string>

namespace gluray::launcher {
namespace {

/// What to do where a job gives no facts; empty: `why` says it.
std::string remedy(const std::string& why, const std::string& job) {
  if (why.starts_with("no gluray-worker"))
    return "start it with a rank on this machine, as the same user: gluray-worker --job " + job +
           ", or mpirun -n RANKS gluray-worker --job " + job;
  if (why.ends_with("does not answer") || why.ends_with("is gone"))
    return "check whether its process is stopped (ps), or end the job and start it again";
  return "";
}

nlohmann::json rankJson(const cluster::RankFacts& rank) {
  if (!rank.answered) return {{"rank", rank.rank}, {"answered", false}};
  return {{"rank", rank.rank},
          {"answered", true},
          {"version", rank.version},
          {"mpi", rank.mpi},
          {"host", rank.host},
          {"rankOnHost", rank.rankHere},
          {"ranksOnHost", rank.ranksHere},
          {"threads", rank.threads},
          {"usableCores", rank.usableCores},
          {"hostCores", rank.hostCores},
          {"cores", rank.cores},
          {"memoryBytes", rank.memoryBytes},
          {"availableBytes", rank.availableBytes},
          {"shmBytes", rank.shmBytes},
          {"shmFreeBytes", rank.shmFreeBytes},
          {"hugePages", rank.hugePages},
          {"byteOrder", rank.isBigEndian ? "big" : "little"}};
}

}  // namespace

int doctorJob(const CommandLine& line) {
  std::string why = cluster::whyNoJobName(line.job);
  if (!why.empty()) return say(why), kUsageError;
  Diagnosis diagnosis;
  nlohmann::json ranks = nlohmann::json::array();
  if (const auto facts = cluster::askJob(control::runtimeDirectory(), line.job, why)) {
    judgeJob(line.job, *facts, diagnosis);
    for (const cluster::RankFacts& rank : facts->ranks) ranks.push_back(rankJson(rank));
  } else {
    diagnosis.broken("job", why, remedy(why, line.job));
  }
  nlohmann::json all = diagnosis.json();
  all["ranks"] = std::move(ranks);
  std::cout << (line.json ? jsonText(all) + "\n" : diagnosis.text());
  return diagnosis.exitCode();
}

}  // namespace gluray::launcher

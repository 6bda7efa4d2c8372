#include "cluster/program/worker_place.h"

#include "control/local_socket.h"
#include "control/runtime_directory.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gluray::cluster {

std::string workerPlace(const std::string& job, int place) {
  return "worker-" + job + "." + std::to_string(place);
}

std::string whyNoJobName(const std::string& job) {
  constexpr size_t kMax = 40;  // as the message says
  const auto usual = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  if (!job.empty() && job.size() <= kMax && std::ranges::all_of(job, usual)) return "";
  std::string why = "\"";
  return why.append(job, 0, kMax)
      .append("\" names no job of workers: use letters, digits, - and _, 40 at most");
}

std::optional<Line> lineToWorker(const std::string& directory, const std::string& job, int onMachine,
                                 std::string& why, bool* isNobody) {
  if (isNobody) *isNobody = false;
  if (why = whyNoJobName(job); !why.empty()) return std::nullopt;
  std::error_code error;
  if (std::filesystem::exists(directory, error))
    if (why = control::whyUnsafe(directory); !why.empty()) return std::nullopt;
  bool nobody = false;
  // A machine may have fewer workers than ranks of the program.
  for (int place = onMachine; place >= 0; place = place > 0 ? place / 2 : -1) {
    control::Descriptor socket =
        control::connectedSocket(directory + "/" + workerPlace(job, place) + ".sock", why, nobody);
    if (socket.get() >= 0) return std::make_optional<Line>(std::move(socket));
  }
  if (isNobody) *isNobody = nobody;
  if (nobody) why = "no gluray-worker --job " + job + " runs on this machine";
  return std::nullopt;
}

}  // namespace gluray::cluster

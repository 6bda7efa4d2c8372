#include "control/auth/waiting_peers.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstring>

namespace gluray::control {

std::string networkOf(const std::string& address) {
  in6_addr six{};
  const std::string withoutZone = address.substr(0, address.find('%'));
  char text[INET6_ADDRSTRLEN] = {};
  if (inet_pton(AF_INET6, withoutZone.c_str(), &six) != 1) return address;
  if (IN6_IS_ADDR_V4MAPPED(&six)) return inet_ntop(AF_INET, six.s6_addr + 12, text, sizeof text);
  std::memset(six.s6_addr + 8, 0, 8);
  return inet_ntop(AF_INET6, &six, text, sizeof text) + std::string("/64");
}

std::optional<uint64_t> WaitingPeers::toClose(const std::string& address) const {
  const std::string network = networkOf(address);
  const auto same = counts_.find(network);
  if (same != counts_.end() && same->second >= kMaxPerNetwork) return oldestOf(network);
  return size() >= kMax ? leastDeserving() : std::nullopt;
}

std::optional<uint64_t> WaitingPeers::leastDeserving() const {
  const auto most = std::max_element(counts_.begin(), counts_.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts_.end() ? std::nullopt : oldestOf(most->first);
}

std::optional<uint64_t> WaitingPeers::oldestOf(const std::string& network) const {
  const auto found = std::find_if(networks_.begin(), networks_.end(),
                                  [&](const auto& one) { return one.second == network; });
  return found == networks_.end() ? std::nullopt : std::optional(found->first);
}

uint64_t WaitingPeers::join(const std::string& address) {
  const std::string network = networkOf(address);
  networks_.emplace(++last_, network);
  ++counts_[network];
  return last_;
}

void WaitingPeers::leave(uint64_t number) {
  const auto found = networks_.find(number);
  if (found == networks_.end()) return;
  if (const auto count = counts_.find(found->second); --count->second == 0) counts_.erase(count);
  networks_.erase(found);
}

}  // namespace gluray::control

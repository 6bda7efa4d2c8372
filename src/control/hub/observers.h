// Records which clients observe which programs. Subscribes to programs for the combined wishes of all
// clients, and forwards events. On the hub's thread.
#pragma once
#include "control/hub/newest.h"
#include "control/hub/programs.h"
#include "control/hub/questions.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gluray::control {

inline constexpr double kMinInterval = 0.05, kMaxInterval = 3600;  // seconds
inline constexpr int kMinSize = 16, kMaxSize = 512,
                     kUsualSize = 256;                // pixels of a thumbnail's longest side
inline constexpr size_t kBehind = size_t{256} << 10;  // bytes waiting for a client that make it slow

/// The data of a program that a client, or all clients together, observe.
struct Wish {
  bool state = false, settings = false, thumbnail = false;
  int size = 0;  // of thumbnails, in pixels; 0: unspecified
  double every = kMaxInterval;
  bool empty() const { return !state && !settings && !thumbnail; }
  void add(const Wish& other);
  bool operator==(const Wish&) const = default;
};

class Observers {
 public:
  Observers(Peers& peers, Programs& programs, Questions& questions)
      : peers_(peers), programs_(programs), questions_(questions) {}

  /// Replaces the client's wishes for these programs.
  void observe(uint64_t client, const std::vector<uint64_t>& programs, const Wish& wish, bool list);
  /// Replaces the client's wishes for all programs, including later ones. `list`: also sends `programs`.
  void observeAll(uint64_t client, const Wish& wish, bool list);

  /// Handles an event from the program's speaker.
  void event(const Program& program, const nlohmann::json& message);
  /// Reports that a program connected, or has another speaker.
  void speakerCame(uint64_t program);
  void programEnded(uint64_t program);
  void clientEnded(uint64_t client);
  /// Reports that the answer to `list` has changed.
  void listChanged();
  /// Sends what the client may receive now.
  void drained(uint64_t client);
  void passed();
  HubTime nextDue() const;

 private:
  struct Client {
    std::map<uint64_t, Wish> wishes;
    std::optional<Wish> all;  // for programs not in `wishes`
    bool list = false;
    bool listDue = false;     // the list has changed since it was last sent
    HubTime listAt{};         // not sent before
    uint64_t listed = 0;      // highest program number in the lists sent
    std::set<uint64_t> told;  // programs whose `settings` it may receive
    Newest newest;
    Wish wishOf(uint64_t program) const;
  };
  void wished(uint64_t program, uint64_t client);
  void ask(uint64_t program, std::vector<uint64_t> clients);
  Wish combinedWish(uint64_t program) const;
  void listIsDue(uint64_t client, Client& state);
  void sendList(uint64_t client, Client& state);
  void sendEvent(uint64_t client, Client& state, uint64_t program, const PeerLink::Line& line);
  bool slow(uint64_t client) { return peers_.waiting(client) > kBehind; }

  Peers& peers_;
  Programs& programs_;
  Questions& questions_;
  std::map<uint64_t, Client> clients_;
  std::map<uint64_t, Wish> asked_;                 // last wish sent, by program
  std::map<uint64_t, PeerLink::Line> thumbnails_;  // last thumbnail by program, for later clients
  PeerLink::Line listLine_;                        // the event `programs`; null: outdated
};

}  // namespace gluray::control

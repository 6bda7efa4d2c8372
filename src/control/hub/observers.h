// Tracks which clients observe which programs: subscribes to programs for the combined wishes of all clients,
// and forwards events. On the hub's thread.
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
inline constexpr size_t kBehind = size_t{256} << 10;  // bytes that wait for a client that reads slowly

/// What a client, or all of them together, want to know of a program.
struct Wish {
  bool state = false, settings = false, thumbnail = false;
  int size = 0;  // of thumbnails, in pixels; 0: not said
  double every = kMaxInterval;
  bool empty() const { return !state && !settings && !thumbnail; }
  void add(const Wish& other);
  bool operator==(const Wish&) const = default;
};

class Observers {
 public:
  Observers(Peers& peers, Programs& programs, Questions& questions)
      : peers_(peers), programs_(programs), questions_(questions) {}

  /// Replaces what the client observes of these programs.
  void observe(uint64_t client, const std::vector<uint64_t>& programs, const Wish& wish, bool list);
  /// The same of all programs, also of those that come later. `list`: `programs`.
  void observeAll(uint64_t client, const Wish& wish, bool list);

  /// An event of the program's speaker.
  void event(const Program& program, const nlohmann::json& message);
  /// A program came or has another speaker.
  void speakerCame(uint64_t program);
  void programEnded(uint64_t program);
  void clientEnded(uint64_t client);
  /// The answer to `list` has changed.
  void listChanged();
  /// Sends what a client may have now.
  void drained(uint64_t client);
  void passed();
  HubTime nextDue() const;

 private:
  struct Client {
    std::map<uint64_t, Wish> wishes;
    std::optional<Wish> all;  // of programs not in `wishes`
    bool list = false;
    bool listDue = false;     // the list has changed since it was last sent
    HubTime listAt{};         // not sent before
    uint64_t listed = 0;      // the highest number of a program in the lists that were sent
    std::set<uint64_t> told;  // programs whose `settings` it may have: a first event with all of them comes
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
  std::map<uint64_t, Wish> asked_;                 // of programs, last
  std::map<uint64_t, PeerLink::Line> thumbnails_;  // the newest of programs, for clients that come later
  PeerLink::Line listLine_;  // the event `programs`; null: not made since the list has changed
};

}  // namespace gluray::control

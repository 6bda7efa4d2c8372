// The settings of this process while it runs: its layers, read again when one of their files changes, and
// values set live. Any thread.
#pragma once
#include "base/clock.h"
#include "settings/layers/settings_layers.h"
#include "settings/live/settings_source.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gluray {

class LiveSettings {
 public:
  /// New settings go to `source`, messages for the user to `complain`. Both must outlive this.
  LiveSettings(SettingsSource& source, Complain complain) : source_(source), complain_(std::move(complain)) {}

  /// Reads all layers.
  Session start(Sources sources);

  /// Reads the files again if one has changed. Cheap: checks at most every kLookSeconds, less often if files
  /// are slow. If a file has a new mistake, all settings stay unchanged until it is corrected.
  void readIfChanged(double now = nowSeconds()) noexcept;

  /// A value that is set live; nullopt: removes it, so that the other layers apply.
  struct Change {
    std::string name;
    std::optional<std::string> value;
  };
  /// The result of change().
  using Changes = std::vector<Change>;
  struct Answer {
    std::string why;       // error: nothing has changed; empty: done
    uint64_t version = 0;  // version in `source` from which on the change applies
    uint64_t ticket = 0;   // ticket in `source`, if the change waits for a frame; version is then 0
    Changes before;        // changes that undo this one, in order
  };
  /// Makes all changes, or none if one is wrong. They apply from the process's frame number `frame` on, or
  /// from the next frame if that one has begun. Changes that wait for another frame then apply from the same
  /// frame. Throws std::bad_alloc.
  Answer change(std::span<const Change> changes, uint64_t frame = 0);
  /// The error that change() would return; empty if none.
  std::string whyNot(std::span<const Change> changes);
  /// The process's first frame with the change of this answer; nullopt if it has not begun.
  std::optional<uint64_t> firstFrameWith(const Answer& answer) const;

  /// A setting's value and origin.
  struct Value {
    const Row* row;
    std::string text;  // in the form of printValue()
    Layer layer;
    std::string place;  // as in Given; empty: built in
    bool operator==(const Value&) const = default;
  };
  /// All settings that files may contain. `waiting`: includes changes that wait for a frame.
  std::vector<Value> values(bool waiting = false);
  /// The values of all layers. `waiting`: as in values().
  Layers layers(bool waiting = false);
  /// Increases whenever values() may have changed.
  uint64_t revision() noexcept;

  static constexpr double kLookSeconds = 0.05;

 private:
  /// Properties that show that a file has changed. `changed` covers permissions and owner.
  struct Stamp {
    int64_t device = 0, inode = 0, size = -1;   // size -1: there is no file
    int64_t modified[2] = {}, changed[2] = {};  // seconds, nanoseconds
    bool operator==(const Stamp&) const = default;
    static Stamp stampOf(const std::string& file);
  };
  using Stamps = std::array<Stamp, 3>;
  using Lines = std::vector<std::string>;
  Stamps stamps() const;
  bool settled(const Stamps& now) const;
  bool isNew(const std::string& mistake) const;
  Session takeSession(Session session);
  struct Next;
  Next settingsAfter(std::span<const Change> changes) const;
  void settle();
  Settings withThreads(Settings settings) const;

  SettingsSource& source_;
  const Complain complain_;
  std::mutex mutex_;  // guards the members below
  Sources sources_;
  std::optional<Sources> later_;  // the sources with changes that wait for a frame
  uint64_t ticket_ = 0;           // ticket of these changes in source_
  std::atomic<uint64_t> revision_{0};
  int ownThreads_ = 0;  // for `threads` = 0
  ConfigFiles files_;   // last read without a new mistake
  Lines mistakes_;      // mistakes in files_, without line numbers
  bool started_ = false;
  Stamps read_, seen_;  // of the last files read; of the last check
  double next_ = 0;     // time of the next check, in seconds
};

}  // namespace gluray

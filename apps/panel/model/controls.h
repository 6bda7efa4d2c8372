// What the panel knows of the hub's programs, and the requests that it makes. GUI thread.
#pragma once
#include "model/calls.h"
#include "model/hub_thread.h"

#include <nlohmann/json.hpp>

#include <QImage>
#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::panel {

inline constexpr int kMaxThumbnailPixels = 512;   // pixels of its longest side: the protocol's limit
inline constexpr size_t kMaxPlottedEvents = 600;  // state events that are remembered

/// A setting's value in a program.
struct Value {
  nlohmann::json value;
  std::string layer, place;
};

/// A program, or the ranks of an MPI job.
struct Program {
  int number = 0;
  int pid = 0, ranks = 1;
  std::string host, name;
  std::map<std::string, Value> values;  // of settings that differ from their built-in values, or did
  int undo = 0, redo = 0;               // steps
  nlohmann::json state = nlohmann::json::object();
  QImage thumbnail;                  // of its window; null: none has come
  std::deque<double> fps;            // one entry a state event, newest last
  std::deque<double> noise, passes;  // the same; NaN where the program says nothing
  QString title() const;
};

class Controls : public QObject {
  Q_OBJECT

 public:
  /// `send` takes requests for the hub.
  explicit Controls(std::function<void(nlohmann::json)> send) : send_(std::move(send)) {}

  const std::vector<Program>& programs() const { return programs_; }
  const Program* find(int number) const;

  /// What widgets show and change: one program, all of them, or, at first and after the chosen one has
  /// ended, none. A program that is alone when it comes is chosen; one that a new hub knows again stays so.
  void choose(int program);
  void chooseAll();
  std::optional<int> chosen() const { return chosen_; }
  bool all() const { return all_; }
  /// The chosen program; of all, the first. Null: there is none.
  const Program* shown() const;
  /// Of what is chosen: the most steps that a program can take back, and make again.
  int undoSteps() const;
  int redoSteps() const;
  /// Whether a chosen program has a live value of the setting.
  bool isLive(const std::string& name) const;
  /// The setting's value in shown(); the built-in one where it says nothing.
  Value value(const std::string& name) const;
  /// Whether programs that are chosen together have different values.
  bool differs(const std::string& name) const;

  /// Null: what the other layers say. Changes with the same, not empty gesture are undone together.
  void set(const std::string& name, const nlohmann::json& value, const std::string& gesture = "");
  /// The same for several settings, by name, that change together.
  void change(const nlohmann::json& values, const std::string& gesture = "");
  void undo();
  void redo();

  /// Calls a function of a program (docs/control-protocol.md). `then` is called later, on this thread, once,
  /// unless `receiver` has gone; also if the program ends.
  void call(int program, const char* name, nlohmann::json arguments, QObject* receiver, CallTaker then);
  /// Requests of one program without `program`, carried out one after the other.
  void batch(int program, nlohmann::json requests, QObject* receiver, BatchTaker then);
  /// Whether a batch is unanswered: while one is under way, settings may be what they shall not stay.
  bool isChanging() const { return calls_.anyChanges(); }
  /// How large thumbnails should be, in pixels of their longest side; of several wishes the largest counts.
  void wantThumbnails(const QObject* who, int size);

  // Called as the hub's thread reports.
  void connected();
  void disconnected(const QString& why);
  void receiveMessage(const Message& message);

 signals:
  void programsChanged();
  void chosenChanged();
  /// Values, or the number of steps, of shown() have changed.
  void settingsChanged();
  void stateChanged(int program);
  void thumbnailChanged(int program);
  /// One line for the user. Empty: the last request was carried out.
  void said(const QString& line);

 private:
  void request(nlohmann::json message, const QString& what = {});
  void observe();
  nlohmann::json target() const;
  void takePrograms(const nlohmann::json& list);
  void chooseAgain(bool first);
  std::vector<const Program*> targets() const;
  std::string failureOf(const nlohmann::json& answer) const;
  void takeAnswer(const nlohmann::json& answer);
  void takeEvent(const nlohmann::json& event);
  void takeSettings(Program& program, const nlohmann::json& event);
  void takeState(Program& program, const nlohmann::json& state);
  void takeThumbnail(Program& program, const nlohmann::json& event);
  Program* findMutable(int number);

  const std::function<void(nlohmann::json)> send_;
  std::vector<Program> programs_;
  std::optional<int> chosen_;
  bool all_ = false;
  bool isConnected_ = false;
  std::pair<std::string, int> identity_;  // host and process of the chosen program
  uint64_t next_ = 1;                     // id of the next request
  std::map<uint64_t, QString> asked_;     // requests without an answer, and what they are about
  Calls calls_;                           // those that a part of the panel waits for
  std::map<const QObject*, int> sizes_;   // of thumbnails that are wanted
};

}  // namespace gluray::panel

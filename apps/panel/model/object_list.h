// The objects that a program draws, as the call `objects` says, asked for again and again while somebody
// looks. GUI thread; never waits.
#pragma once
#include "model/controls.h"

#include <QColor>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <vector>

namespace gluray::panel {

struct DrawnObject {
  uint32_t number = 0;
  QColor color;  // not valid: each vertex or texel has its own
  QString shape, material;
  int64_t triangles = 0;
  QStringList hidden;  // kinds of rays
  bool operator==(const DrawnObject&) const = default;
};

class ObjectList : public QObject {
  Q_OBJECT

 public:
  ObjectList(Controls& controls, QObject* parent);
  /// Whether somebody looks: only then is the chosen program asked, once a second.
  void watch(bool on);
  /// In the order of their numbers. What was there stays for some seconds when the program fails to say it.
  const std::vector<DrawnObject>& objects() const { return objects_; }
  /// How many there are; more than objects() has if there are too many to show.
  int64_t total() const { return total_; }
  /// Why there are none; empty: the program said what it draws.
  const QString& why() const { return why_; }
  /// Whether the program has said anything since it was chosen.
  bool known() const { return known_; }

 signals:
  void changed();

 private:
  void restart();
  void ask();
  void askPage(uint32_t after);
  void receiveAnswer(const CallAnswer& answer, uint64_t round);
  void finish(const QString& why);

  Controls& controls_;
  QTimer timer_;
  std::vector<DrawnObject> objects_, next_;
  nlohmann::json version_;  // of objects_; null: none
  nlohmann::json nextVersion_;
  int64_t total_ = 0, nextTotal_ = 0;
  QString why_;
  QElapsedTimer failing_;  // since the first failure after objects_ came; not valid: none
  int program_ = 0;
  uint64_t round_ = 0;  // answers of earlier rounds do not count
  bool watched_ = false, underWay_ = false, known_ = false;
};

}  // namespace gluray::panel

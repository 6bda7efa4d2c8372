// The panel's end of the control protocol: a thread that connects to the hub of this machine, or is the hub
// itself where none runs, or connects to one by TCP. Signals arrive in the thread of their receivers.
#pragma once
#include "control/connection/connect.h"

#include <nlohmann/json.hpp>

#include <QObject>
#include <functional>
#include <memory>
#include <thread>

namespace gluray::panel {

using Message = std::shared_ptr<const nlohmann::json>;

class HubThread : public QObject {
  Q_OBJECT

 public:
  /// `wake` is HubOptions::wake, called on the thread.
  HubThread(control::HubAddress address, std::function<void(const std::string&, unsigned long)> wake);
  ~HubThread() override;
  /// Begins to connect; connect the signals before.
  void start();

  /// Sends a message if there is a connection. Any thread, never waits.
  void send(nlohmann::json message);

 signals:
  void connected(const QString& to);
  void received(const gluray::panel::Message& message);
  /// Why there is no connection; the thread tries again.
  void lost(const QString& why);

 private:
  class Link;
  std::unique_ptr<Link> link_;
  std::thread thread_;
};

}  // namespace gluray::panel

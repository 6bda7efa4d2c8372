#include "model/hub_thread.h"

#include "control/hub/server/hub_server.h"

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>

#include <exception>
#include <utility>

namespace gluray::panel {
namespace {

using asio::error_code;
using nlohmann::json;
constexpr std::chrono::milliseconds kAfterRefusal{
    90000};                                       // longer than hubs refuse a machine whose key is wrong
constexpr std::chrono::milliseconds kAgain{250};  // between attempts to connect

}  // namespace

/// What the thread owns.
class HubThread::Link {
 public:
  Link(HubThread& owner, control::HubAddress address,
       std::function<void(const std::string&, unsigned long)> wake)
      : owner_(owner), address_(std::move(address)), wake_(std::move(wake)), server_(io_), again_(io_) {}

  void run() noexcept {
    asio::post(io_, [this] { open(); });
    while (!stopped_) try {
        io_.run();
        break;
      } catch (const std::exception& error) {
        // Out of memory, for instance. A connection that ends tries again.
        connection_ ? connection_->close(error.what()) : fail(error.what());
      }
  }

  void send(json message) {
    asio::post(io_, [this, message = std::move(message)] {
      if (connection_) connection_->send(message);
    });
  }

  void stop() {
    asio::post(io_, [this] {
      stopped_ = true;
      again_.cancel();
      if (connection_) connection_->close("the panel ends");
      connection_.reset();
      server_.stop();
      work_.reset();
      io_.stop();
    });
  }

 private:
  void open() {
    if (stopped_) return;
    // Another hub may have ended: then this one takes its place.
    if (address_.host.empty() && !serves_) {
      const std::string why = server_.start({address_.directory, "", "", wake_});
      serves_ = why.empty();
      if (!serves_ && !server_.otherHubRuns()) return fail(why);
    }
    control::connectToHub(io_, address_,
                          [this](std::shared_ptr<control::Connection> connection, const std::string& why,
                                 control::ConnectFailure failure) {
                            connection ? begin(std::move(connection)) : fail(why, failure);
                          });
  }

  void begin(std::shared_ptr<control::Connection> connection) {
    connection_ = std::move(connection);
    connection_->start({[this](json&& message) { take(std::move(message)); },
                        [this](const std::string& why) {
                          connection_.reset();
                          fail("the connection to the hub ended (" + why + "); the panel looks for another");
                        },
                        {}});
    connection_->send(json{{"type", "hello"}, {"version", 1}, {"role", "client"}});
  }

  void take(json&& message) {
    if (message["type"] == "hello")
      emit owner_.connected(
          QString::fromStdString(address_.host.empty() ? address_.directory : address_.host));
    else
      emit owner_.received(std::make_shared<const json>(std::move(message)));
  }

  void fail(const std::string& why, control::ConnectFailure failure = control::ConnectFailure::unreachable) {
    if (stopped_) return;
    emit owner_.lost(QString::fromStdString(why));
    const bool refused =
        failure == control::ConnectFailure::key || failure == control::ConnectFailure::refused;
    again_.expires_after(refused ? kAfterRefusal : kAgain);
    again_.async_wait([this](const error_code& error) {
      if (!error) open();
    });
  }

  HubThread& owner_;
  const control::HubAddress address_;
  const std::function<void(const std::string&, unsigned long)> wake_;
  asio::io_context io_;
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  control::HubServer server_;
  asio::steady_timer again_;
  std::shared_ptr<control::Connection> connection_;
  bool serves_ = false, stopped_ = false;
};

HubThread::HubThread(control::HubAddress address, std::function<void(const std::string&, unsigned long)> wake)
    : link_(std::make_unique<Link>(*this, std::move(address), std::move(wake))) {
  qRegisterMetaType<Message>();
}

void HubThread::start() {
  thread_ = std::thread([this] { link_->run(); });
}

HubThread::~HubThread() {
  link_->stop();
  if (thread_.joinable()) thread_.join();
}

void HubThread::send(json message) { link_->send(std::move(message)); }

}  // namespace gluray::panel

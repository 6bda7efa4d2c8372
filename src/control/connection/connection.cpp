#include "control/connection/connection.h"

#include "control/messages/parsed.h"

#include <asio/buffer.hpp>
#include <asio/write.hpp>

#include <exception>
#include <system_error>
#include <utility>
#include <vector>

namespace gluray::control {
namespace {

using asio::error_code;
using nlohmann::json;
using std::chrono::steady_clock;

constexpr size_t kMaxLinesPerRead = 64;
constexpr std::chrono::seconds kLastWords{1};  // for sending waiting data when a connection is finished

std::string reasonOf(const error_code& error) {
  if (error == asio::error::eof || error == asio::error::connection_reset) return "the other side closed it";
  return error.message();
}

}  // namespace

Connection::Connection(Socket socket, int messagesPerSecond)
    : socket_(std::move(socket)),
      pause_(socket_.get_executor()),
      end_(socket_.get_executor()),
      most_(messagesPerSecond) {}

template <class Work>
void Connection::guarded(Work work) {
  try {
    work();
  } catch (const std::exception& error) {  // out of memory, or from a handler
    close(error.what());
  }
}

void Connection::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  started_ = true;
  read();
  if (!lines_.empty()) write();
}

void Connection::read() {
  socket_.async_read_some(asio::buffer(buffer_),
                          [self = shared_from_this()](const error_code& error, size_t bytes) {
                            if (!self->open_) return;
                            if (error) return self->close(reasonOf(error));
                            self->guarded([&] { self->consumeBytes(bytes); });
                          });
}

void Connection::consumeBytes(size_t bytes) {
  if (!reader_.add({buffer_.data(), bytes})) {
    send(json{{"type", "error"}, {"why", "the message is longer than 1 MiB"}});
    return finish("a message is longer than 1 MiB");
  }
  takeLines();
}

void Connection::takeLines() {
  while (open_ && finishing_.empty()) {
    const auto now = steady_clock::now();
    if (now - second_ >= std::chrono::seconds(1)) second_ = now, taken_ = 0;
    if (most_ > 0 && taken_ >= most_) {
      pause_.expires_at(second_ + std::chrono::seconds(1));
      return pause_.async_wait([self = shared_from_this()](const error_code& error) {
        if (!error) self->guarded([&] { self->takeLines(); });
      });
    }
    const auto line = reader_.nextLine();
    if (!line) return read();
    ++taken_;
    Parsed parsed = parse(*line);
    if (!parsed.why.empty()) {
      send(json{{"type", "error"}, {"why", parsed.why}});
      return finish(parsed.why);
    }
    // A copy: the handler may close the connection, which releases handlers.
    if (const auto handler = handlers_.message) handler(std::move(parsed.message));
  }
}

void Connection::send(const json& message) { send(sharedLine(message)); }

void Connection::send(Line line) {
  if (!open_ || !finishing_.empty()) return;
  if (waiting_ + line->size() > kMaxWaiting) return close("it does not read what is sent to it");
  waiting_ += line->size();
  lines_.push_back(std::move(line));
  if (started_ && !writing_) write();
}

void Connection::write() {
  std::vector<asio::const_buffer> buffers;
  std::vector<Line> kept;
  for (const Line& line : lines_) {
    if (kept.size() == kMaxLinesPerRead) break;
    buffers.emplace_back(asio::buffer(*line));
    kept.push_back(line);
  }
  writing_ = true;
  asio::async_write(socket_, buffers, [self = shared_from_this(), kept](const error_code& error, size_t) {
    if (!self->open_) return;
    if (error) return self->close(reasonOf(error));
    self->guarded([&] { self->wrote(kept.size()); });
  });
}

void Connection::wrote(size_t lines) {
  writing_ = false;
  for (size_t i = 0; i < lines; ++i) waiting_ -= lines_.front()->size(), lines_.pop_front();
  if (!lines_.empty()) return write();
  if (!finishing_.empty()) return close(finishing_);
  if (const auto drained = handlers_.drained) drained();
}

void Connection::finish(const std::string& why) {
  if (!open_ || !finishing_.empty()) return;
  if (lines_.empty()) return close(why);
  finishing_ = why;
  end_.expires_after(kLastWords);
  end_.async_wait([self = shared_from_this()](const error_code& error) {
    if (!error) self->close(self->finishing_);
  });
}

void Connection::close(const std::string& why) {
  if (!open_) return;
  open_ = false;
  error_code ignored;
  socket_.close(ignored);
  pause_.cancel();
  end_.cancel();
  lines_.clear();
  waiting_ = 0;
  const Handlers handlers = std::exchange(handlers_, {});
  if (handlers.closed) handlers.closed(why);
}

Connection::Socket socketOf(asio::io_context& io, int family, int protocol, Descriptor descriptor) {
  Connection::Socket socket(io);
  error_code error;
  socket.assign(Connection::Socket::protocol_type(family, protocol), descriptor.get(), error);
  if (error) throw std::system_error(error);
  descriptor.release();
  return socket;
}

Connection::Line sharedLine(const json& message) {
  return std::make_shared<const std::string>(lineOf(message));
}

}  // namespace gluray::control

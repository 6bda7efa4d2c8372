#include "control/messages/message.h"

#include "control/messages/parsed.h"

#include <algorithm>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

/// The maximum nesting of brackets outside strings.
int depthOf(std::string_view text) {
  int depth = 0, most = 0;
  bool inString = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '[' || c == '{') {
      most = std::max(most, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return most;
}

}  // namespace

bool LineReader::add(std::string_view bytes) {
  if (failed_) return false;
  for (size_t at = 0; at < bytes.size();) {
    const size_t end = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    open_ += end - at;
    const bool ends = bytes[end - 1] == '\n';
    if (open_ > kMaxBytes || (open_ == kMaxBytes && !ends)) return *this = {}, failed_ = true, false;
    if (ends) open_ = 0;
    at = end;
  }
  if (begin_ > kMaxBytes || begin_ == bytes_.size()) bytes_.erase(0, begin_), scanned_ -= begin_, begin_ = 0;
  bytes_.append(bytes);
  return true;
}

std::optional<std::string> LineReader::nextLine() {
  const size_t end = bytes_.find('\n', scanned_);
  if (end == bytes_.npos) {
    scanned_ = bytes_.size();
    return std::nullopt;
  }
  std::string line = bytes_.substr(begin_, end - begin_);
  begin_ = scanned_ = end + 1;
  return line;
}

std::string whyUnfit(std::string_view line) {
  if (line.size() > kMaxBytes) return "the message is longer than 1 MiB";
  if (depthOf(line) > kMaxDepth) return "the message is nested deeper than 16";
  return "";
}

Parsed parse(std::string_view line) {
  if (line.size() >= kMaxBytes) return {{}, "the message is longer than 1 MiB"};
  if (std::string why = whyUnfit(line); !why.empty()) return {{}, std::move(why)};
  try {
    json message = json::parse(line);
    if (!message.is_object()) return {{}, "the message is not a JSON object"};
    const auto type = message.find("type");
    if (type == message.end() || !type->is_string()) return {{}, "the message has no type"};
    return {std::move(message), ""};
  } catch (const json::exception& error) {
    constexpr size_t kMaxQuotedBytes = 200;  // the error quotes the message
    return {{}, "the message is not JSON in UTF-8: " + std::string(error.what()).substr(0, kMaxQuotedBytes)};
  }
}

std::string lineOf(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace gluray::control

// Base64 (RFC 4648, section 4): bytes in messages. Any thread.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace gluray::control {

/// Encodes without line breaks.
std::string toBase64(std::string_view bytes);
/// Decodes; nullopt if the text is not base64, or lacks its padding.
std::optional<std::string> fromBase64(std::string_view text);

}  // namespace gluray::control

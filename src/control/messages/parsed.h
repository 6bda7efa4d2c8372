// A parsed message, for users that read its members. Any thread.
#pragma once
#include "control/messages/message.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gluray::control {

struct Parsed {
  nlohmann::json message;  // an object with a text `type`, if `why` is empty
  std::string why;
};

}  // namespace gluray::control

#include "saved/exr/exr_writer.h"
#include "saved/program/render.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace gluray::saved {
namespace {

/// That the caller has ended the work.
struct Ended {};

void takeTexts(const nlohmann::json& texts, ExrPicture& picture) {
  for (const auto& [name, text] : texts.items()) picture.texts.emplace_back(name, text.get<std::string>());
}

void writeRequested(const GlurayExrRequest& request) {
  if (request.version != kGlurayRenderVersion)
    throw std::runtime_error("install GLuRay again: its library is of another version");
  const nlohmann::json header = nlohmann::json::parse(request.header);
  ExrPicture picture{.width = request.width, .height = request.height};
  for (const auto& channel : header.at("channels"))
    picture.channels.push_back(
        {channel.at("name").get<std::string>(), request.half != 0 && channel.at("color").get<bool>()});
  takeTexts(nlohmann::json::parse(request.texts), picture);
  takeTexts(header.at("texts"), picture);
  bool ended = false;
  picture.row = [&](int y, float* values) {
    if (request.row(request.user, y, values)) return;
    ended = true;
    throw std::runtime_error("ended");
  };
  try {
    writeExr(request.file, picture);
  } catch (const std::exception&) {
    if (ended) throw Ended();
    throw;
  }
}

}  // namespace
}  // namespace gluray::saved

__attribute__((visibility("default"))) int glurayWriteExr(const GlurayExrRequest* request, char* why,
                                                          unsigned long whyBytes) {
  std::snprintf(why, whyBytes, "%s", "");
  try {
    gluray::saved::writeRequested(*request);
    return 1;
  } catch (const gluray::saved::Ended&) { return 0; } catch (const std::exception& e) {
    std::snprintf(why, whyBytes, "%s", e.what());
    return 0;
  }
}

#include "pictures/files/picture_file.h"

#include "pictures/engine_function.h"
#include "pictures/files/png_writer.h"
#include "saved/program/render.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace gluray::launcher {
namespace {

using WriteExr = int (*)(const GlurayExrRequest*, char*, unsigned long);
using Texts = std::vector<std::pair<std::string, std::string>>;

Texts textsOf(const FinishedPicture& picture) {
  Texts texts = {{"Software", "GLuRay " GLURAY_VERSION}, {"Command", picture.command}};
  constexpr std::pair<const char*, const char*> kFacts[] = {{"cameras", "GLuRay cameras"},
                                                            {"hash", "GLuRay scene"},
                                                            {"program", "GLuRay program"},
                                                            {"saved", "GLuRay saved"}};
  for (const auto& [fact, keyword] : kFacts)
    if (picture.facts.contains(fact) && picture.facts[fact].is_string())
      texts.emplace_back(keyword, picture.facts[fact].get<std::string>());
  return texts;
}

void writeAsPng(const std::string& file, const FinishedPicture& picture) {
  const BandFile& bands = picture.bands;
  writePng(file, {.width = bands.plan().width,
                  .height = bands.plan().height,
                  .alpha = picture.options.background == "transparent",
                  .depth = valuesFor(picture.options) == kGlurayDisplayed ? 16 : 8,
                  .texts = textsOf(picture),
                  .row = [&](int y, std::vector<uint32_t>& pixels) { bands.row(y, pixels); },
                  .wideRow = [&](int y, std::vector<float>& values) { bands.row(y, values); }});
}

/// Rows for the engine.
struct ExrRows {
  const BandFile& bands;
  std::string why;
  static int give(void* user, int y, float* values) {
    auto& rows = *static_cast<ExrRows*>(user);
    try {
      rows.bands.row(y, static_cast<void*>(values));
      return 1;
    } catch (const std::exception& e) { return rows.why = e.what(), 0; }
  }
};

void writeAsExr(const std::string& file, const FinishedPicture& picture) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [keyword, text] : textsOf(picture)) all[keyword] = text;
  const std::string texts = all.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  ExrRows rows{picture.bands, {}};
  const GlurayExrRequest request{.version = kGlurayRenderVersion,
                                 .file = file.c_str(),
                                 .width = picture.bands.plan().width,
                                 .height = picture.bands.plan().height,
                                 .half = picture.options.depth == 16,
                                 .header = picture.header.c_str(),
                                 .texts = texts.c_str(),
                                 .user = &rows,
                                 .row = ExrRows::give};
  char why[1024] = "";
  if (engineFunction<WriteExr>("glurayWriteExr")(&request, why, sizeof why)) return;
  throw std::runtime_error(rows.why.empty() ? why : rows.why);
}

}  // namespace

int valuesFor(const PictureOptions& options) {
  if (options.isExr()) return kGlurayLinear;
  return options.depth == 16 ? kGlurayDisplayed : kGlurayBytes;
}

void writePicture(const std::string& file, const FinishedPicture& picture) {
  if (picture.options.isExr())
    writeAsExr(file, picture);
  else
    writeAsPng(file, picture);
}

}  // namespace gluray::launcher

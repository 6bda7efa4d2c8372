#include "pictures/rendered_picture.h"

#include "base/clock.h"
#include "base/hash.h"
#include "pictures/band_file.h"
#include "pictures/png_writer.h"
#include "programs/doors.h"
#include "saved/program/render.h"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using Render = int (*)(const GlurayRenderRequest*, const GlurayRenderSink*, char*, unsigned long);

Render engine() {
  const std::string library = libraryDirectory() + "/libgluray-engine.so";
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(std::string("install GLuRay again: ") + dlerror());
  const auto render = reinterpret_cast<Render>(dlsym(handle, "glurayRender"));
  if (!render) throw std::runtime_error("install GLuRay again: another one's library is " + library);
  return render;
}

/// A hash of all that decides about the picture. A scene's file is never changed in place.
Hash128 identityOf(const PictureOptions& o, const std::vector<std::string>& settings) {
  struct stat info {};
  ::stat(o.scene.c_str(), &info);
  std::string all = std::to_string(info.st_size) + ' ' + std::to_string(info.st_mtim.tv_sec) + ' ' +
                    std::to_string(info.st_mtim.tv_nsec) + ' ' + o.size + ' ' + o.fit + ' ' + o.background +
                    (o.overlays ? " overlays" : "") + " " GLURAY_VERSION;
  for (const std::string& setting : settings) all += '\n' + setting;
  return hashBytes(all.data(), all.size());
}

/// A line on the terminal that says how far the picture is.
class Progress {
 public:
  void passed(int band, int first, int of) {
    constexpr double kSoon = 2;  // seconds
    const double seconds = nowSeconds() - begin_;
    if (!isatty(2) || (seconds < kSoon && !shown_)) return;
    const double left = seconds / (band - first) * (of - band);
    std::fprintf(stderr, "\rgluray: %d %%, %.0f s left \033[K", 100 * band / of, left);
    shown_ = true;
  }
  ~Progress() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
  }

 private:
  const double begin_ = nowSeconds();
  bool shown_ = false;
};

/// Takes the picture from the engine.
struct Work {
  std::string path;  // of the bands
  Hash128 identity;
  int firstBand = 0;
  RenderedPicture picture;
  std::unique_ptr<BandFile> bands;
  Progress progress;
  std::string why;

  /// What throws in `act` ends the work.
  template <class Act>
  int guarded(const Act& act) {
    try {
      act();
      return 1;
    } catch (const std::exception& e) { return why = e.what(), 0; }
  }
  static Work& of(void* user) { return *static_cast<Work*>(user); }
};

int begin(void* user, int width, int height, int bandRows, const char* facts) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    work.picture.width = width, work.picture.height = height;
    work.picture.facts = nlohmann::json::parse(facts);
    work.bands = std::make_unique<BandFile>(
        work.path, BandPlan{work.identity.low, work.identity.high, width, height, bandRows});
  });
}

int takeRows(void* user, int band, int count, const uint32_t* pixels) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    work.bands->add(band, count, pixels);
    const int rows = work.bands->plan().bandRows;
    work.progress.passed(band + 1, work.firstBand, (work.picture.height + rows - 1) / rows);
  });
}

void takeNote(void* user, const char* line) { Work::of(user).picture.notes.emplace_back(line); }

/// The engine writes progress of single bands and messages of its log: they stay as they are.
void trace(const PictureOptions& options, const std::vector<std::string>& settings, Work& work) {
  int width = 0, height = 0;
  if (!options.size.empty())
    if (const std::string why = readSize(options.size, width, height); !why.empty())
      throw std::runtime_error(why);
  std::vector<const char*> texts;
  for (const std::string& setting : settings) texts.push_back(setting.c_str());
  const GlurayRenderRequest request{.version = kGlurayRenderVersion,
                                    .scene = options.scene.c_str(),
                                    .width = width,
                                    .height = height,
                                    .fit = options.fit.c_str(),
                                    .transparent = options.background == "transparent",
                                    .overlays = options.overlays,
                                    .firstBand = work.firstBand,
                                    .settings = texts.data(),
                                    .settingCount = static_cast<int>(texts.size())};
  const GlurayRenderSink sink{&work, begin, takeRows, takeNote};
  char why[1024] = "";
  if (engine()(&request, &sink, why, sizeof why)) return;
  throw std::runtime_error(work.why.empty() ? why : work.why);
}

}  // namespace

RenderedPicture renderPicture(const PictureOptions& options, const NamedValues& settings,
                              const std::string& command) {
  std::vector<std::string> values;
  for (const auto& [name, value] : settings) values.push_back(name + "=" + value);
  Work work{.path = options.file + ".unfinished", .identity = identityOf(options, values)};
  if (options.again) ::unlink(work.path.c_str());
  work.firstBand = BandFile::finishedBands(work.path, work.identity.low, work.identity.high);
  work.picture.resumedBands = work.firstBand;
  trace(options, values, work);
  PngPicture png{.width = work.picture.width,
                 .height = work.picture.height,
                 .alpha = options.background == "transparent",
                 .row = [&](int y, std::vector<uint32_t>& pixels) { work.bands->row(y, pixels); }};
  png.texts = {{"Software", "GLuRay " GLURAY_VERSION}, {"Command", command}};
  for (const char* fact : {"program", "saved"})
    if (work.picture.facts.contains(fact) && work.picture.facts[fact].is_string())
      png.texts.emplace_back(std::string("GLuRay ") + fact, work.picture.facts[fact].get<std::string>());
  writePng(options.file, png);
  work.bands->remove();
  return std::move(work.picture);
}

}  // namespace gluray::launcher

#include "pictures/rendered_picture.h"

#include "base/clock.h"
#include "base/hash.h"
#include "control/images/film_plan.h"
#include "pictures/engine_function.h"
#include "pictures/files/band_file.h"
#include "pictures/files/picture_file.h"
#include "pictures/files/video_stream.h"
#include "saved/program/render.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using Render = int (*)(const GlurayRenderRequest*, const GlurayRenderSink*, char*, unsigned long);

/// A hash of all that decides about the picture. A scene's file is never changed in place.
Hash128 identityOf(const PictureOptions& o, const std::vector<std::string>& settings,
                   const WantedViews& views) {
  struct stat info {};
  ::stat(o.scene.c_str(), &info);
  std::string all = std::to_string(info.st_size) + ' ' + std::to_string(info.st_mtim.tv_sec) + ' ' +
                    std::to_string(info.st_mtim.tv_nsec) + ' ' + std::to_string(o.turntable) + ' ' + o.size +
                    ' ' + o.fit + ' ' + o.background + (o.overlays ? " overlays" : "") + ' ' +
                    std::to_string(valuesFor(o)) + ' ' + o.layers + " " GLURAY_VERSION + ' ' + views.hash();
  for (const std::string& setting : settings) all += '\n' + setting;
  return hashBytes(all.data(), all.size());
}

/// A line on the terminal that says how far the pictures are.
class Progress {
 public:
  /// `done`: the share of all work, of which `before` was done when this began.
  void passed(double done, double before) {
    constexpr double kSoon = 2;  // seconds
    const double seconds = nowSeconds() - begin_;
    if (!isatty(2) || done <= before || (seconds < kSoon && !shown_)) return;
    std::fprintf(stderr, "\rgluray: %.0f %%, %.0f s left \033[K", 100 * done,
                 seconds / (done - before) * (1 - done));
    shown_ = true;
  }
  ~Progress() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
  }

 private:
  const double begin_ = nowSeconds();
  bool shown_ = false;
};

/// Takes pictures from the engine.
struct Work {
  const PictureOptions& options;
  const WantedViews& views;
  const std::string& command;
  std::vector<std::string> files;  // one a picture
  Hash128 identity;
  int firstPicture = 0, firstBand = 0, number = 0, bandRows = 0;
  RenderedPicture picture;
  std::string header;  // of OpenEXR files
  int pixelBytes = 4;
  std::unique_ptr<BandFile> bands;
  std::optional<VideoStream> video;  // in place of files
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
  std::string bandsOf(int one) const { return files[static_cast<size_t>(one)] + ".unfinished"; }
};

int begin(void* user, int number, int width, int height, int bandRows, const char* facts) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    work.number = number, work.bandRows = bandRows;
    work.picture.width = width, work.picture.height = height;
    work.picture.facts = nlohmann::json::parse(facts);
    if (work.video) return work.video->begin(width, height);
    work.bands = std::make_unique<BandFile>(
        work.bandsOf(number),
        BandPlan{work.identity.low, work.identity.high, width, height, bandRows, work.pixelBytes});
  });
}

int takeChannels(void* user, int count, const char* header) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    work.header = header;
    work.pixelBytes = static_cast<int>(sizeof(float)) * count;
  });
}

int takeRows(void* user, int band, int count, const void* pixels) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    if (work.video)
      work.video->add(count, static_cast<const uint32_t*>(pixels));
    else
      work.bands->add(band, count, pixels);
    const int rows = work.bandRows, bands = (work.picture.height + rows - 1) / rows;
    const auto share = [&](int picture, int done) {
      return (picture + static_cast<double>(done) / bands) / work.views.pictures;
    };
    work.progress.passed(share(work.number, band + 1), share(work.firstPicture, work.firstBand));
  });
}

int finish(void* user) {
  Work& work = Work::of(user);
  return work.guarded([&] {
    if (work.video) return work.video->end();
    nlohmann::json facts = work.picture.facts;
    if (!work.views.cameras.empty()) facts["cameras"] = work.views.hash();
    writePicture(work.files[static_cast<size_t>(work.number)],
                 {work.options, *work.bands, work.command, facts, work.header});
    work.bands->remove();
  });
}

void takeNote(void* user, const char* line) {
  std::vector<std::string>& notes = Work::of(user).picture.notes;
  if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.emplace_back(line);
}

void trace(const PictureOptions& options, const std::vector<std::string>& settings, Work& work) {
  int width = 0, height = 0;
  if (!options.size.empty())
    if (const std::string why = readSize(options.size, width, height); !why.empty())
      throw std::runtime_error(why);
  const WantedViews& views = work.views;
  std::vector<const char*> texts;
  for (const std::string& setting : settings) texts.push_back(setting.c_str());
  const GlurayRenderRequest request{
      .version = kGlurayRenderVersion,
      .scene = options.scene.c_str(),
      .width = width,
      .height = height,
      .fit = options.fit.c_str(),
      .transparent = options.background == "transparent",
      .overlays = options.overlays,
      .firstPicture = work.firstPicture,
      .firstBand = work.firstBand,
      .values = valuesFor(options),
      .layers = options.layers.c_str(),
      .pictures = work.views.pictures,
      .settings = texts.data(),
      .settingCount = static_cast<int>(texts.size()),
      .cameras = views.cameras.empty() ? nullptr : views.cameras.data(),
      .savedCameras = views.saved.data(),
      .savedCameraCount = static_cast<int>(views.saved.size()),
      .savedCameraStated = views.stated,
      .sceneHash = options.sceneHash.empty() ? nullptr : options.sceneHash.c_str()};
  const GlurayRenderSink sink{&work, begin, takeChannels, takeRows, finish, takeNote};
  char why[1024] = "";
  if (engineFunction<Render>("glurayRender")(&request, &sink, why, sizeof why)) return;
  throw std::runtime_error(work.why.empty() ? why : work.why);
}

/// The number of the picture that an interrupted run was making; 0: none.
int interrupted(const std::vector<std::string>& files) {
  for (size_t i = 0; i < files.size(); ++i)
    if (::access((files[i] + ".unfinished").c_str(), F_OK) == 0) return static_cast<int>(i);
  return 0;
}

}  // namespace

std::vector<std::string> filesOf(const PictureOptions& options, const WantedViews& views) {
  if (options.video) return {};
  if (!views.numbered) return {options.file};
  FilmName name;
  const std::string why = readFilmName(options.file, name, options.isExr() ? ".exr" : ".png");
  if (!why.empty()) throw std::runtime_error(why);
  std::vector<std::string> files;
  for (int i = 1; i <= views.pictures; ++i) files.push_back(name.file(i));
  return files;
}

RenderedPicture renderPictures(const PictureOptions& options, const NamedValues& settings,
                               const std::string& command, const WantedViews& views) {
  if (!options.camerasHash.empty() && options.camerasHash != views.hash())
    throw std::runtime_error("the cameras of the path are others than those of the picture");
  std::vector<std::string> values;
  for (const auto& [name, value] : settings) values.push_back(name + "=" + value);
  Work work{.options = options,
            .views = views,
            .command = command,
            .files = filesOf(options, views),
            .identity = identityOf(options, values, views),
            .pixelBytes = valuesFor(options) == kGlurayDisplayed ? static_cast<int>(4 * sizeof(float)) : 4};
  if (options.video) {
    FrameRate rate;
    readFrameRate(options.fps, rate);
    work.video.emplace(rate);
    trace(options, values, work);
    return std::move(work.picture);
  }
  work.firstPicture = interrupted(work.files);
  if (options.again) {
    ::unlink(work.bandsOf(work.firstPicture).c_str());
    work.firstPicture = 0;
  }
  const std::string unfinished = work.bandsOf(work.firstPicture);
  if (!BandFile::isOf(unfinished, work.identity.low, work.identity.high)) work.firstPicture = 0;
  work.firstBand = BandFile::finishedBands(unfinished, work.identity.low, work.identity.high);
  work.picture.resumed = work.firstBand > 0 || work.firstPicture > 0;
  trace(options, values, work);
  work.picture.files = std::move(work.files);
  return std::move(work.picture);
}

}  // namespace gluray::launcher

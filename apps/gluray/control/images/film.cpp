#include "control/images/film.h"

#include "base/files.h"
#include "base/printable.h"
#include "control/images/film_settings.h"
#include "control/images/film_text.h"
#include "control/images/refined_state.h"
#include "control/images/window_image.h"
#include "say.h"

#include <asio/signal_set.hpp>

#include <chrono>
#include <csignal>
#include <limits>

namespace gluray::launcher {
namespace {

using std::chrono::steady_clock;

constexpr double kLaterFrameSeconds = 10;  // for a frame later than the one before
constexpr double kPauseSeconds = 0.02;     // between shots of frames that are not later

struct FilmPlan {
  FilmName name;
  std::vector<Ramp> ramps;
  int frames = 0;  // 0: until Ctrl+C or the time is over
};

/// Reads the command line. Empty, or one line that says what is wrong.
std::string readFilmPlan(const ControlOptions& options, FilmPlan& plan) {
  if (std::string why = readFilmName(options.file, plan.name); !why.empty()) return why;
  plan.frames = options.film.frames;
  for (const std::string& text : options.film.ramps)
    if (std::string why = readRamp(text, plan.ramps.emplace_back()); !why.empty()) return why;
  if (plan.frames == 0 && !plan.ramps.empty()) return "--set needs --frames N, over which the values vary";
  if (plan.frames == 0 && options.seconds == 0) return "use --frames N or --seconds S";
  for (int number = 1; number <= std::max(plan.frames, 1); ++number)
    if (std::string why = whyNotInto(plan.name.file(number)); !why.empty()) return why;
  return "";
}

class FilmMaker {
 public:
  FilmMaker(const CommandLine& line, const FilmPlan& plan, HubSession& hub, const RunningProgram& program)
      : plan_(plan), hub_(hub), program_(program), settings_(hub, program, plan.ramps), signals_(hub.io()) {
    if (line.control.film.passes > 0) refined_.emplace(hub, program, line.control.film.passes);
    if (line.control.seconds > 0)
      end_ = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(
                                       std::chrono::duration<double>(line.control.seconds));
    signals_.add(SIGINT), signals_.add(SIGTERM);
    signals_.async_wait([this](const asio::error_code& error, int) {
      if (!error) stopped_ = true, hub_.client().interrupt();
    });
  }

  /// Takes the images; says what keeps it from it.
  FilmMade make(const std::function<void(int)>& progress) {
    const int most = plan_.frames > 0 ? plan_.frames : std::numeric_limits<int>::max();
    try {
      for (int number = 1; number <= most && !ended() && takeImage(number); ++number) progress(number);
    } catch (const std::runtime_error& error) { made_.why = error.what(); }
    try {
      settings_.giveBack();
    } catch (const std::runtime_error& error) {
      if (made_.why.empty()) made_.why = error.what();
    }
    return made_;
  }

 private:
  bool ended() {
    if (hub_.io().stopped()) hub_.io().restart();
    hub_.io().poll();  // signals
    return stopped_ || (end_ && steady_clock::now() >= *end_);
  }

  /// False: the film ends without it.
  bool takeImage(int number) {
    const std::string file = plan_.name.file(number);
    if (const std::string why = whyNotInto(file); !why.empty()) throw std::runtime_error(why);
    const std::optional<int64_t> first = settings_.set(number, plan_.frames);
    if (refined_ && !settings_.same(number, plan_.frames))  // otherwise it is the same image again
      unfinished_ = !refined_->wait(first, [this] { return ended(); });
    if (refined_ && ended()) return false;
    made_.unfinished += unfinished_;
    const std::optional<WindowImage> image = laterImage(first.value_or(0));
    if (!image) return false;
    if (const std::string why = files::replace(file, pngOf(image->pixels)); !why.empty())
      throw std::runtime_error(why);
    made_.add(file, *image);
    return true;
  }

  /// Of a frame from `least` on that is later than the last image's. Nothing: the film has ended.
  std::optional<WindowImage> laterImage(int64_t least) {
    const auto begin = steady_clock::now();
    while (!ended()) {
      const Shot shot = takeShot(hub_, program_);
      if (!shot.frame || (*shot.frame >= least && *shot.frame > made_.lastFrame()))
        return imageOf(hub_, program_, shot);
      if (std::chrono::duration<double>(steady_clock::now() - begin).count() > kLaterFrameSeconds)
        throw std::runtime_error("it shows no later frame");
      hub_.client().awaitEvent(kPauseSeconds);
    }
    return std::nullopt;
  }

  const FilmPlan& plan_;
  HubSession& hub_;
  const RunningProgram& program_;
  FilmSettings settings_;
  std::optional<RefinedState> refined_;
  std::optional<steady_clock::time_point> end_;
  asio::signal_set signals_;
  bool stopped_ = false, unfinished_ = false;
  FilmMade made_;
};

}  // namespace

int makeFilm(const CommandLine& line) {
  FilmPlan plan;
  if (const std::string why = readFilmPlan(line.control, plan); !why.empty()) return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  const FilmMade made = labelled(program, [&] {
    FilmMaker maker(line, plan, hub, program);
    return maker.make([&](int number) { showProgress(number, plan.frames); });
  });
  clearProgress();
  printFilm(line, program, plan.name, made);
  if (!made.why.empty()) say(labelOf(program) + ": " + made.why);
  return made.why.empty() ? 0 : 1;
}

}  // namespace gluray::launcher

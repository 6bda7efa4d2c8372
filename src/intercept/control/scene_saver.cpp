#include "intercept/control/scene_saver.h"

#include <stdexcept>
#include <utility>

namespace gluray::intercept {

void SceneSaver::start(saved::SavedScene scene, const std::string& file) {
  {
    const std::lock_guard lock(mutex_);
    if (!file_.empty() && !result_) throw std::runtime_error("it saves another scene: try again");
  }
  thread_.stop();
  file_ = file, result_.reset();
  const bool started = thread_.start(
      [this, scene = std::move(scene), file](const std::atomic<bool>&) {
        std::string why = saved::saveScene(scene, file, true);
        const std::lock_guard lock(mutex_);
        result_ = std::move(why);
      },
      BackgroundJob::Priority::usual);
  if (started) return;
  file_.clear();
  throw std::runtime_error("it can start no thread to save the scene");
}

bool SceneSaver::isSaved(const std::string& file) {
  std::optional<std::string> result;
  {
    const std::lock_guard lock(mutex_);
    if (file != file_) throw std::runtime_error("it does not save a scene into that file");
    result = result_;
  }
  if (!result) return false;
  thread_.stop();  // lets go of the scene
  if (!result->empty()) throw std::runtime_error(*result);
  return true;
}

}  // namespace gluray::intercept

// Calls about a place in the image: what is there, and what shall be in focus. GUI thread.
#pragma once
#include "model/controls.h"
#include "pages/live/live_image.h"

#include <functional>

namespace gluray::panel {

/// What `pick` and `highlight` take.
nlohmann::json argumentsOf(const ImagePoint& at);

/// Asks the shown program what is there. `then` gets its number, 0: nothing, and a line about it for the
/// user. If the program cannot say it, `failed` gets the reason.
void pickObject(Controls& controls, const ImagePoint& at, QObject* receiver,
                std::function<void(int program, uint32_t object, const QString& line)> then,
                std::function<void(const QString& why)> failed);

/// Makes what is there the surface in focus: camera.focus = 0, camera.focus-x and camera.focus-y, which are
/// shares of the view at that place. Nothing changes where the program cannot say what is there. `said` gets
/// a line for the user.
void focusOn(Controls& controls, const ImagePoint& at, QObject* receiver,
             std::function<void(const QString& line)> said);

}  // namespace gluray::panel

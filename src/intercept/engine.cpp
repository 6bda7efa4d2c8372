// The engine's entry point, called by doors.
#include "intercept/capture/capture.h"
#include "intercept/contexts/contexts.h"
#include "intercept/control/link.h"
#include "intercept/frames/frames.h"
#include "intercept/hooks/hooks.h"
#include "intercept/reports/explanation.h"
#include "intercept/reports/report.h"
#include "intercept/session/session.h"
#include "intercept/stubs/stub_proc.h"

#include <pthread.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <string>

namespace gluray::intercept {
namespace {

bool startsWith(const char* text, const char* start) {
  return std::strncmp(text, start, std::strlen(start)) == 0;
}

void* proc(const GlurayDoor* door, const char* name) {
  const auto kind = static_cast<Door>(door->kind);
  if (startsWith(name, "glX")) return glxHook(kind, name);
  if (startsWith(name, "egl")) return eglHook(kind, name);
  if (startsWith(name, "OSMesa")) return osmesaHook(name);
  // With --off the program calls the real OpenGL directly, and only frames are counted.
  if (session().off) return nullptr;
  void* stub = stubProc(name);
  if (!stub && session().explainFrames) noteUnknownFunction(name);
  return stub;
}

const GlurayEngine g_engine = {GLURAY_DOOR_ABI, sizeof(GlurayEngine), proc};

void startChild() {
  passThroughAfterFork();
  leaveHubToParent();
}

void start() {
  session();
  if (mayBeSeenByHubs()) {
    allowControl(liveSettings());
    whenFramesBegin(lookForHub);
  }
  planCapture();
  followContexts();
  pthread_atfork(nullptr, nullptr, startChild);
  if (!session().reportFile.empty()) std::atexit(writeReport);
}

}  // namespace
}  // namespace gluray::intercept

extern "C" __attribute__((visibility("default"))) const GlurayEngine* glurayEngine(const GlurayDoor* door,
                                                                                   const char** why) {
  using namespace gluray::intercept;
  if (door->version != GLURAY_DOOR_ABI || door->size != sizeof(GlurayDoor)) {
    *why = "door and engine are of different versions";
    return nullptr;
  }
  try {
    static std::once_flag once;
    std::call_once(once, start);
    openDoor(door);
    return &g_engine;
  } catch (const std::exception& e) {
    static std::string reason;
    reason = e.what();
    *why = reason.c_str();
  }
  return nullptr;
}

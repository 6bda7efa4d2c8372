#include "osmesa/display.h"

#include <EGL/eglext.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { kMaxDevices = 32 };

static EGLDisplay g_display = EGL_NO_DISPLAY;

static int lists(const char* names, const char* name) {
  const size_t length = strlen(name);
  for (const char* at = names; at && (at = strstr(at, name)) != NULL; at += length)
    if ((at == names || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0)) return 1;
  return 0;
}

/* Null: EGL lists no device that renders in software. */
static EGLDeviceEXT softwareDevice(void) {
  const PFNEGLQUERYDEVICESEXTPROC queryDevices =
      (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
  const PFNEGLQUERYDEVICESTRINGEXTPROC queryString =
      (PFNEGLQUERYDEVICESTRINGEXTPROC)eglGetProcAddress("eglQueryDeviceStringEXT");
  EGLDeviceEXT devices[kMaxDevices];
  EGLint count = 0;
  if (!queryDevices || !queryString || !queryDevices(kMaxDevices, devices, &count)) return NULL;
  for (EGLint i = 0; i < count; ++i)
    if (lists(queryString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) return devices[i];
  return NULL;
}

static EGLDisplay initialised(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL) ? display : EGL_NO_DISPLAY;
}

static void find(void) {
  const char* const known = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const PFNEGLGETPLATFORMDISPLAYEXTPROC getDisplay =
      (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  const EGLDeviceEXT device = lists(known, "EGL_EXT_platform_device") ? softwareDevice() : NULL;
  if (getDisplay && device) g_display = initialised(getDisplay(EGL_PLATFORM_DEVICE_EXT, device, NULL));
  if (getDisplay && g_display == EGL_NO_DISPLAY && lists(known, "EGL_MESA_platform_surfaceless"))
    g_display = initialised(getDisplay(EGL_PLATFORM_SURFACELESS_MESA, (void*)EGL_DEFAULT_DISPLAY, NULL));
  if (g_display == EGL_NO_DISPLAY)
    fprintf(stderr,
            "gluray-osmesa: EGL has no display without a screen; install Mesa's EGL (libegl-mesa0)\n");
}

EGLDisplay osmesaDisplay(void) {
  static pthread_once_t once = PTHREAD_ONCE_INIT;
  pthread_once(&once, find);
  return g_display;
}

int osmesaConfig(EGLDisplay display, int depthBits, int stencilBits, EGLConfig* config) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           depthBits,
                           EGL_STENCIL_SIZE,
                           stencilBits,
                           EGL_NONE};
  EGLint count = 0;
  return eglChooseConfig(display, wanted, config, 1, &count) && count > 0;
}

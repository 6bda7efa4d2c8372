/* A stand-in for Open Image Denoise in tests: it writes the mean of the colours to all pixels. With
   FAKE_OLDER its functions have the names of version 1.4; with FAKE_LACKS one is missing; with FAKE_FAILS
   filters fail. */
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#pragma GCC visibility push(default)

struct Image {
  float* pixels;
  size_t count;
};
static struct Image images[4];
static bool hdr, clean, committed;
static int threads, affinity = 1;
static const char* error;
static int device, filter;

static int numberOf(const char* name) {
  return !strcmp(name, "color") ? 0 : !strcmp(name, "albedo") ? 1 : !strcmp(name, "normal") ? 2 : 3;
}

void* oidnNewDevice(int type) { return type == 1 ? &device : NULL; }
static void setInt(const char* name, int value) {
  if (!strcmp(name, "numThreads")) threads = value;
}
static void setBool(const char* name, bool value) {
  if (!strcmp(name, "setAffinity")) affinity = value;
}
static void setFilter(const char* name, bool value) {
  if (!strcmp(name, "hdr")) hdr = value;
  if (!strcmp(name, "cleanAux")) clean = value;
}
#ifdef FAKE_OLDER
void oidnSetDevice1i(void* of, const char* name, int value) { (void)of, setInt(name, value); }
void oidnSetDevice1b(void* of, const char* name, bool value) { (void)of, setBool(name, value); }
void oidnSetFilter1b(void* of, const char* name, bool value) { (void)of, setFilter(name, value); }
#else
void oidnSetDeviceInt(void* of, const char* name, int value) { (void)of, setInt(name, value); }
void oidnSetDeviceBool(void* of, const char* name, bool value) { (void)of, setBool(name, value); }
void oidnSetFilterBool(void* of, const char* name, bool value) { (void)of, setFilter(name, value); }
#endif
void oidnCommitDevice(void* of) { committed = of == &device; }
void oidnReleaseDevice(void* of) { (void)of, committed = false; }
int oidnGetDeviceError(void* of, const char** message) {
  (void)of;
  if (!error) return 0;
  *message = error, error = NULL;
  return 1;
}
void* oidnNewFilter(void* of, const char* type) {
  return of == &device && committed && !strcmp(type, "RT") ? &filter : NULL;
}
void oidnSetSharedFilterImage(void* of, const char* name, void* pixels, int format, size_t width,
                              size_t height, size_t offset, size_t pixelStride, size_t rowStride) {
  (void)of;
  if (format != 3 || offset || pixelStride || rowStride) error = "wrong format";
  images[numberOf(name)] = (struct Image){pixels, 3 * width * height};
}
void oidnCommitFilter(void* of) { (void)of; }
void oidnExecuteFilter(void* of) {
  (void)of;
#ifdef FAKE_FAILS
  error = "out of order";
#endif
  if (!hdr || !clean || affinity || threads != 3) error = "wrong parameters";
  double sum[3] = {0, 0, 0};
  for (size_t i = 0; i < images[0].count; ++i) sum[i % 3] += images[0].pixels[i];
  for (size_t i = 0; i < images[3].count; ++i)
    images[3].pixels[i] = (float)(sum[i % 3] / (double)(images[0].count / 3));
}
#ifndef FAKE_LACKS
void oidnReleaseFilter(void* of) { (void)of; }
#endif

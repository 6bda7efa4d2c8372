/* The preload door's dlopen. A program that opens an OpenGL library gets this door's handle, so that dlsym on
   it finds our functions. For any other file the door jumps to libc's dlopen, so that libc still sees the
   program as the caller and applies its RPATH. For files that the door opens in the program's place, this
   file reads the caller's RPATH or RUNPATH. */
#define _GNU_SOURCE
#include "intercept/doors/door.h"
#include "intercept/doors/real_libraries.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <limits.h>
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef void* (*Dlopen)(const char*, int);

/* Set while the door opens a library itself: dlopen calls of that library's constructors go to libc. */
static __thread int opening __attribute__((tls_model("initial-exec")));

static Dlopen realDlopen(void) {
  static Dlopen real;
  Dlopen function = __atomic_load_n(&real, __ATOMIC_RELAXED);
  if (!function) {
    function = (Dlopen)gluraySymbol(RTLD_NEXT, "dlopen");
    __atomic_store_n(&real, function, __ATOMIC_RELAXED);
  }
  return function;
}

void* gluraySelf(void) {
  Dl_info info;
  if (!dladdr((const void*)&glurayDoor, &info) || !info.dli_fname) return NULL;
  return realDlopen()(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

/* The directory that $ORIGIN stands for in a loaded object. */
static void originOf(const struct link_map* map, char* origin, size_t size) {
  char self[PATH_MAX] = "";
  const char* name = map->l_name;
  if (!name || !*name) {
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length > 0 ? length : 0] = 0;
    name = self;
  }
  const char* slash = strrchr(name, '/');
  snprintf(origin, size, "%.*s", slash ? (int)(slash - name) : 0, name);
}

/* Writes one directory of a search list, with $ORIGIN expanded, and "/file". Returns 0 if it does not fit. */
static int expand(const char* entry, size_t length, const char* origin, const char* file, char* path,
                  size_t size) {
  const char* const words[] = {"$ORIGIN", "${ORIGIN}"};
  for (int i = 0; i < 2; ++i) {
    const size_t word = strlen(words[i]);
    if (length >= word && !strncmp(entry, words[i], word)) {
      const int written = snprintf(path, size, "%s%.*s/%s", origin, (int)(length - word), entry + word, file);
      return written > 0 && (size_t)written < size;
    }
  }
  const int written = snprintf(path, size, "%.*s/%s", (int)length, entry, file);
  return written > 0 && (size_t)written < size;
}

/* Looks for `file` in a colon-separated list of directories. */
static int searchList(const char* list, const char* origin, const char* file, char* path, size_t size) {
  while (list && *list) {
    const size_t length = strcspn(list, ":");
    if (length && expand(list, length, origin, file, path, size) && access(path, R_OK) == 0) return 1;
    list += length + (list[length] == ':');
  }
  return 0;
}

/* The string of a dynamic entry (DT_RPATH or DT_RUNPATH) of a loaded object, or null. */
static const char* dynamicString(const struct link_map* map, ElfW(Sxword) tag) {
  const char* strings = NULL;
  ElfW(Xword) offset = 0;
  int found = 0;
  for (const ElfW(Dyn)* entry = map->l_ld; entry && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_STRTAB) strings = (const char*)entry->d_un.d_ptr;
    if (entry->d_tag == tag) offset = entry->d_un.d_val, found = 1;
  }
  return found && strings ? strings + offset : NULL;
}

/* Finds a bare file name in the caller's own search path, in the order of ld.so(8). Returns 0 if it is not
   found. */
static int searchAsCaller(const char* file, const void* caller, char* path, size_t size) {
  Dl_info info;
  struct link_map* map = NULL;
  char origin[PATH_MAX];
  if (!dladdr1(caller, &info, (void**)&map, RTLD_DL_LINKMAP) || !map) return 0;
  originOf(map, origin, sizeof origin);
  const char* runPath = dynamicString(map, DT_RUNPATH);
  if (!runPath) return searchList(dynamicString(map, DT_RPATH), origin, file, path, size);
  return searchList(getenv("LD_LIBRARY_PATH"), origin, file, path, size) ||
         searchList(runPath, origin, file, path, size);
}

/* Opens the real library in the program's place, and returns this door's handle. */
static void* openForProgram(const char* file, int mode, const void* caller) {
  char path[PATH_MAX];
  const int bare = !strchr(file, '/');
  const char* wanted = bare && searchAsCaller(file, caller, path, sizeof path) ? path : file;
  opening = 1;
  void* handle = realDlopen()(wanted, mode & ~RTLD_DEEPBIND);
  opening = 0;
  if (!handle) return NULL;
  glurayRemember(glurayLibraryOf(file), handle);
  void* self = gluraySelf();
  return self ? self : handle;
}

__attribute__((visibility("default"))) void* dlopen(const char* file, int mode) {
  const Dlopen real = realDlopen();
  if (opening || !file || glurayLibraryOf(file) < 0) return real(file, mode);
  return openForProgram(file, mode, __builtin_return_address(0));
}

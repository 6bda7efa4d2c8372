/* A frame rate overlay, as programs have them in LD_PRELOAD: it exports dlsym, glXSwapBuffers,
   eglSwapBuffers and every GetProcAddress, and counts frames. The variable OVERLAY_FINDS says how it finds
   the real functions: "version" (dlvsym) or "walk" (the C library's symbol table). It prints its count when
   the process ends. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))

typedef void* (*Dlsym)(void*, const char*);
typedef void* (*Lookup)(const unsigned char*);

static int frames;

/* Finds dlsym in the symbol table of the C library. */
static int inLibc(struct dl_phdr_info* info, size_t size, void* out) {
  (void)size;
  if (!strstr(info->dlpi_name, "libc.so")) return 0;
  const ElfW(Sym)* symbols = NULL;
  const char* strings = NULL;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    const ElfW(Dyn)* entry = (const ElfW(Dyn)*)(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    for (; entry->d_tag != DT_NULL; ++entry) {
      if (entry->d_tag == DT_SYMTAB) symbols = (const ElfW(Sym)*)entry->d_un.d_ptr;
      if (entry->d_tag == DT_STRTAB) strings = (const char*)entry->d_un.d_ptr;
    }
  }
  for (int i = 1; symbols && strings && i < 5000; ++i)
    if (symbols[i].st_value && !strcmp(strings + symbols[i].st_name, "dlsym")) {
      *(void**)out = (void*)(info->dlpi_addr + symbols[i].st_value);
      return 1;
    }
  return 0;
}

static Dlsym realDlsym(void) {
  static Dlsym found;
  const char* way = getenv("OVERLAY_FINDS");
  if (found) return found;
  if (way && !strcmp(way, "walk")) {
    dl_iterate_phdr(inLibc, &found);
  } else {
    found = (Dlsym)dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34");
    if (!found) found = (Dlsym)dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
  }
  if (!found) _exit(99);
  return found;
}

EXPORT void glXSwapBuffers(void* display, unsigned long drawable);
EXPORT unsigned eglSwapBuffers(void* display, void* surface);
EXPORT void* glXGetProcAddress(const unsigned char* name);
EXPORT void* glXGetProcAddressARB(const unsigned char* name);
EXPORT void* eglGetProcAddress(const char* name);
EXPORT void* dlsym(void* restrict handle, const char* restrict name);

/* Ours for a name; null: it has none. */
static void* own(const char* name) {
  if (!strcmp(name, "glXSwapBuffers")) return (void*)glXSwapBuffers;
  if (!strcmp(name, "eglSwapBuffers")) return (void*)eglSwapBuffers;
  if (!strcmp(name, "glXGetProcAddress")) return (void*)glXGetProcAddress;
  if (!strcmp(name, "glXGetProcAddressARB")) return (void*)glXGetProcAddressARB;
  if (!strcmp(name, "eglGetProcAddress")) return (void*)eglGetProcAddress;
  return NULL;
}

/* As MangoHud does: from the library that it opens itself, or the next in the search order. */
static void* real(const char* library, const char* name) {
  void* handle = dlopen(library, RTLD_LAZY);
  void* function = handle ? realDlsym()(handle, name) : NULL;
  return function ? function : realDlsym()(RTLD_NEXT, name);
}

void* dlsym(void* restrict handle, const char* restrict name) {
  void* ours = own(name);
  return ours ? ours : realDlsym()(handle, name);
}

void* glXGetProcAddress(const unsigned char* name) {
  void* ours = own((const char*)name);
  return ours ? ours : ((Lookup)real("libGL.so.1", "glXGetProcAddress"))(name);
}

void* glXGetProcAddressARB(const unsigned char* name) {
  void* ours = own((const char*)name);
  return ours ? ours : ((Lookup)real("libGL.so.1", "glXGetProcAddressARB"))(name);
}

void* eglGetProcAddress(const char* name) {
  void* ours = own(name);
  return ours ? ours : ((Lookup)real("libEGL.so.1", "eglGetProcAddress"))((const unsigned char*)name);
}

void glXSwapBuffers(void* display, unsigned long drawable) {
  ++frames;
  ((void (*)(void*, unsigned long))real("libGL.so.1", "glXSwapBuffers"))(display, drawable);
}

unsigned eglSwapBuffers(void* display, void* surface) {
  ++frames;
  return ((unsigned (*)(void*, void*))real("libEGL.so.1", "eglSwapBuffers"))(display, surface);
}

__attribute__((destructor)) static void end(void) {
  if (frames) printf("overlay: %d frames\n", frames), fflush(stdout);
}

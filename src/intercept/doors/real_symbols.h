/* The C library's own symbol lookup. Overlays in LD_PRELOAD wrap dlsym and return their own glXSwapBuffers,
   which calls ours: a door that used their dlsym would call itself for ever. libc only, any thread. */
#pragma once

/* dlsym(3) of the C library, with this library as the caller. */
void* gluraySymbol(void* handle, const char* name);

/* The function `name` of the libraries after this one in the search order; null if there is none. Skips
   overlays, which are libraries that export their own dlsym: they reach the real OpenGL through GLuRay. */
void* glurayNextSymbol(const char* name);

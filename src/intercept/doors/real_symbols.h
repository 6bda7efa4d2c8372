/* The C library's own symbol lookup. Overlays in LD_PRELOAD wrap dlsym and answer with their own
   glXSwapBuffers, which calls ours: a door that asked them would call itself for ever. libc only, any thread.
 */
#pragma once

/* dlsym(3) of the C library, with this library as the caller. */
void* gluraySymbol(void* handle, const char* name);

/* The function `name` of the libraries after this one in the search order; null: none. Passes over overlays,
   which are libraries that export a dlsym of their own: they reach the real OpenGL through us. */
void* glurayNextSymbol(const char* name);

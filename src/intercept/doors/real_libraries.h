/* Finds the real OpenGL libraries for the preload door: first those after us in the search order, then those
   that the program opens itself, then the system's. libc only, any thread. */
#pragma once

enum GlurayLibrary { GLURAY_LIB_GL, GLURAY_LIB_EGL, GLURAY_LIB_OSMESA, GLURAY_LIB_COUNT };

/* The OpenGL library that a file name means, by exactly its last component; -1: none. */
int glurayLibraryOf(const char* file);

/* The program opened a real library: uses its functions from now on, unless a library after us has them. */
void glurayRemember(int library, void* handle);

/* The real function `name`, as exported by a library; null if there is none. */
void* glurayExported(int library, const char* name);

/* The same, from any OpenGL library that the program itself uses; null if there is none. */
void* glurayOfProgram(const char* name);

/* Finds the real OpenGL libraries for the preload door: first those after this door in the search order, then
   those that the program opens itself, then the system's. libc only, any thread. */
#pragma once

enum GlurayLibrary { GLURAY_LIB_GL, GLURAY_LIB_EGL, GLURAY_LIB_OSMESA, GLURAY_LIB_COUNT };

/* The OpenGL library that a file name refers to, by exactly its last component; -1 if none. */
int glurayLibraryOf(const char* file);

/* Reports that the program opened a real library: its functions are used from now on, unless a library after
   this door has them. */
void glurayRemember(int library, void* handle);

/* The real function `name` that a library exports; null if there is none. */
void* glurayExported(int library, const char* name);

/* The real function `name` of any OpenGL library that the program itself uses; null if there is none. */
void* glurayOfProgram(const char* name);

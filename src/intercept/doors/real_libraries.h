/* The preload door's view of the real OpenGL libraries: those that come after us in the search order, those
   that the program opens itself, and, failing both, those of the system. libc only, any thread. */
#pragma once

enum GlurayLibrary { GLURAY_LIB_GL, GLURAY_LIB_EGL, GLURAY_LIB_OSMESA, GLURAY_LIB_COUNT };

/* Which OpenGL library the file name (exactly its last part) stands for, or -1. */
int glurayLibraryOf(const char* file);

/* The program opened a real library: its functions are the real ones from now on, unless some come after us.
 */
void glurayRemember(int library, void* handle);

/* The real function `name`, as exported by a library; null where there is none. */
void* glurayExported(int library, const char* name);

/* The same, from whichever OpenGL library the program itself has; null where it has none. */
void* glurayOfProgram(const char* name);

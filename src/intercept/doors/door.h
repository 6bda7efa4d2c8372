/* Code that all doors share: loads the engine, resolves entry points. libc only, any thread. */
#pragma once
#include "intercept/doors/door_abi.h"

/* This library's door; each door defines it. */
extern const GlurayDoor glurayDoor;

/* The engine, loaded by the first call. Null if that fails, which is reported once in one line on stderr. */
const GlurayEngine* glurayLoadEngine(void);

/* The engine if it is already loaded, else null. */
const GlurayEngine* glurayEngineIfLoaded(void);

/* 1 after loading has failed: the door then passes all calls to the real functions. */
int glurayEngineFailed(void);

/* Index of `name` in the jump table, or -1. */
int glurayFind(const char* name);

/* Call as soon as the door runs: identifies standard error before the program can reuse its number. */
void glurayNoteStreams(void);

/* Writes one line "gluray: ..." to stderr, as the log does (base/guarded_write.h). Writes nothing in
   processes that the launched program starts. */
void gluraySay(const char* line, const char* detail);

/* Whether `function` is in this library, so that it cannot be the real one. */
int glurayIsOurs(const void* function);

/* Whether the process has more privileges than its user (set-uid, file capabilities). If so, the doors leave
   the process to the real OpenGL: settings that the user chooses must not act with those privileges. */
int glurayIsPrivileged(void);

/* Preload door: a handle of this library, like one from dlopen. */
void* gluraySelf(void);

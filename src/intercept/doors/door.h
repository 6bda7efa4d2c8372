/* Shared code of all doors: loads the engine, resolves entry points. libc only, any thread. */
#pragma once
#include "intercept/doors/door_abi.h"

/* This library's door; each door defines it. */
extern const GlurayDoor glurayDoor;

/* The engine, loaded at the first call. Null if that fails, which is reported in one line on stderr. */
const GlurayEngine* glurayLoadEngine(void);

/* The engine if it is loaded already, else null. */
const GlurayEngine* glurayEngineIfLoaded(void);

/* 1 once loading was tried and failed: the door then passes all calls to the real functions. */
int glurayEngineFailed(void);

/* Index of `name` in the jump table, or -1. */
int glurayFind(const char* name);

/* Call this as early as the door runs: identifies standard error before the program may reuse its number. */
void glurayNoteStreams(void);

/* Writes one line "gluray: ..." to stderr, as the log does (base/guarded_write.h): not in processes that the
   launched program starts. */
void gluraySay(const char* line, const char* detail);

/* Whether `function` lies in this library: then it cannot be the real one. */
int glurayIsOurs(const void* function);

/* Whether the process has more privileges than its user (set-uid, file capabilities). The doors then leave it
   to the real OpenGL: settings that the user chooses must not act with those privileges. */
int glurayIsPrivileged(void);

/* Preload door: a handle of this library, as from dlopen. */
void* gluraySelf(void);

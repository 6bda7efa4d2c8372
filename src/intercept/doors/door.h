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

/* Writes one line "gluray: ..." to stderr. */
void gluraySay(const char* line, const char* detail);

/* Whether `function` lies in this library: then it cannot be the real one. */
int glurayIsOurs(const void* function);

/* Preload door: a handle of this library, as from dlopen. */
void* gluraySelf(void);

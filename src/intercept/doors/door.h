/* What all doors share: finding and loading the engine, resolving entry points. libc only, any thread. */
#pragma once
#include "intercept/doors/door_abi.h"

/* The door that this library is; defined by each. */
extern const GlurayDoor glurayDoor;

/* The engine, loaded at the first call. Null if it cannot be loaded: one line on stderr has said so. */
const GlurayEngine* glurayLoadEngine(void);

/* The engine if it is loaded already, else null. */
const GlurayEngine* glurayEngineIfLoaded(void);

/* 1 once loading was tried and failed: the door then stands open to the real functions. */
int glurayEngineFailed(void);

/* Index of `name` in the jump table, or -1. */
int glurayFind(const char* name);

/* Writes one line "gluray: ..." to stderr. */
void gluraySay(const char* line, const char* detail);

/* Whether `function` lies in this library: then it cannot be the real one. */
int glurayIsOurs(const void* function);

/* Preload door: a handle of this library, as dlopen gives it. */
void* gluraySelf(void);

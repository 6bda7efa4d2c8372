// Requests of the program to the engine in its own process: settings, and a report. The functions are
// exported in C, for Python (python/gluray/inside.py) and others that find them by dlsym in
// libgluray-engine.so.
#pragma once

extern "C" {

/// Answers a request of the control protocol (docs/control-protocol.md): one object, as text. Types: set,
/// undo, redo, get, describe, and report, whose result is that of --report. Returns the result or {"why": one
/// line} as text, to be given to glurayForget(); null if there is no memory. Changes count from the next
/// frame: unlike a hub's client, the caller does not wait for it. Any thread. Never throws.
char* glurayAsk(const char* request);

/// Frees an answer. Null is allowed.
void glurayForget(char* answer);
}

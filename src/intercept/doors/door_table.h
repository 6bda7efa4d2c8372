/* The generated jump table of a door, and its resolver. */
#pragma once

extern const int glurayCount;
extern const char glurayNames[];           /* all names, sorted, each with its terminating zero */
extern const unsigned glurayNameOffsets[]; /* start of name i */
extern void* glurayTable[];                /* target of entry point i; initially a resolver */
extern void* const glurayJumps[];          /* the entry points themselves (vendor doors only) */

/* Finds the function for entry i, and stores it in the table when it is final. Never null. */
void* glurayResolve(int i);

/* The jump table of a door (generated) and what the door's own code does with it. */
#pragma once

extern const int glurayCount;
extern const char glurayNames[];           /* all names, sorted, each with its terminating zero */
extern const unsigned glurayNameOffsets[]; /* where name i starts */
extern void* glurayTable[];                /* where entry point i jumps to; starts at a resolver */
extern void* const glurayJumps[];          /* the entry points themselves (vendor doors only) */

/* Finds the function behind entry i and stores it in the table once it cannot change any more. Never null. */
void* glurayResolve(int i);

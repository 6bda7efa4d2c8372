/* The command line of gluray-worker. */
#pragma once
#include "worker_program.h"

/* Reads the options. Returns 1: they are read; 0: `*exitCode` says how to end, after help, the version or one
 * line about a mistake. */
int readOptions(int argc, char** argv, GlurayWorkerOptions* options, int* exitCode);

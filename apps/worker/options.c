#define _GNU_SOURCE
#include "options.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kUsageError = 2, kMostThreads = 1024 };

static const char kHelp[] =
    "Traces images for programs started with gluray --workers JOB.\n"
    "As a job of many ranks: mpirun -n 16 gluray-worker --job JOB\n"
    "Usage: gluray-worker [OPTIONS]\n"
    "\n"
    "Options:\n"
    "  -h,--help            print this help and exit\n"
    "  --job NAME [job]     name of the job; programs use it as --workers NAME\n"
    "  --threads N [0]      threads of each rank; 0: the cores of the machine, shared by its ranks\n"
    "  --memory SIZE [0]    memory limit of each rank, such as 4GB; larger geometry is paged; 0: most of the "
    "free memory\n"
    "  --mpi NAME [auto]    openmpi, mpich, none, or a library; auto: the launcher's MPI\n"
    "  --quiet              print errors only\n"
    "  --version            print the version and exit\n";

/* A size such as 4GB, 512 MiB or 1000000: the units are powers of 1024. Returns whether it is one. */
static int readSize(const char* text, uint64_t* bytes) {
  static const char kUnits[] = "bkmgtpe";
  char* end = NULL;
  errno = 0;
  const double number = strtod(text, &end);
  if (end == text || errno || !(number >= 0)) return 0;
  while (isspace((unsigned char)*end)) ++end;
  const char* const unit = *end ? strchr(kUnits, tolower((unsigned char)*end)) : kUnits;
  if (!unit) return 0;
  if (*end && unit != kUnits && !strcasecmp(end + 1, "ib"))
    end += 3;
  else if (*end && unit != kUnits && !strcasecmp(end + 1, "b"))
    end += 2;
  else if (*end)
    ++end;
  double factor = 1;
  for (long i = unit - kUnits; i > 0; --i) factor *= 1024;
  if (*end || number * factor >= 1e19) return 0;
  *bytes = (uint64_t)(number * factor);
  return 1;
}

static int readThreads(const char* text, int* threads) {
  char* end = NULL;
  const long number = strtol(text, &end, 10);
  if (end == text || *end || number < 0 || number > kMostThreads) return 0;
  *threads = (int)number;
  return 1;
}

static int mistaken(const char* what, const char* more, int* exitCode) {
  fprintf(stderr, "gluray-worker: %s%s; see gluray-worker --help\n", what, more);
  *exitCode = kUsageError;
  return 0;
}

int readOptions(int argc, char** argv, GlurayWorkerOptions* options, int* exitCode) {
  static const struct option known[] = {
      {"help", no_argument, NULL, 'h'},          {"job", required_argument, NULL, 'j'},
      {"threads", required_argument, NULL, 't'}, {"memory", required_argument, NULL, 'm'},
      {"mpi", required_argument, NULL, 'i'},     {"quiet", no_argument, NULL, 'q'},
      {"version", no_argument, NULL, 'v'},       {NULL, 0, NULL, 0}};
  *options = (GlurayWorkerOptions){"job", "auto", 0, 0, 0};
  *exitCode = 0;
  opterr = 0;
  for (int one = 0; (one = getopt_long(argc, argv, ":h", known, NULL)) != -1;) switch (one) {
      case 'h': return fputs(kHelp, stdout), 0;
      case 'v': return puts("gluray-worker " GLURAY_VERSION), 0;
      case 'j': options->job = optarg; break;
      case 'i': options->mpi = optarg; break;
      case 'q': options->quiet = 1; break;
      case 't':
        if (!readThreads(optarg, &options->threads))
          return mistaken("--threads takes a number from 0 to 1024, not ", optarg, exitCode);
        break;
      case 'm':
        if (!readSize(optarg, &options->memory))
          return mistaken("--memory takes a size such as 4GB, not ", optarg, exitCode);
        break;
      case ':': return mistaken("a value is missing after ", argv[optind - 1], exitCode);
      default: return mistaken("unknown option ", argv[optind - 1], exitCode);
    }
  return optind < argc ? mistaken("it takes no argument such as ", argv[optind], exitCode) : 1;
}

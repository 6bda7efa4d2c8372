// gluray-bench-micro: costs of single steps of the library, by Google Benchmark.
#include <benchmark/benchmark.h>

BENCHMARK_MAIN();

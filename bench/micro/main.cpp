// gluray-bench-micro: what single steps of the library cost, by Google Benchmark.
#include <benchmark/benchmark.h>

BENCHMARK_MAIN();

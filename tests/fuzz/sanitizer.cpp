// What the address sanitizer is told, wherever the fuzzer is started from: it plays in children that end at
// once, and what Mesa does inside memcpy and its like is not ours (it reads beyond its own blocks here and
// there).
extern "C" {
__attribute__((visibility("default"))) const char* __asan_default_options() { return "detect_leaks=0"; }
__attribute__((visibility("default"))) const char* __asan_default_suppressions() {
  return "interceptor_via_lib:libOSMesa";
}
__attribute__((visibility("default"))) const char* __ubsan_default_options() { return "print_stacktrace=1"; }
}

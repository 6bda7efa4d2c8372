// Options of the address sanitizer for the fuzzer, however it is started: no leak check, because its child
// processes end at once, and no checks of OSMesa's memcpy and the like, because it reads beyond its blocks.
extern "C" {
__attribute__((visibility("default"))) const char* __asan_default_options() { return "detect_leaks=0"; }
__attribute__((visibility("default"))) const char* __asan_default_suppressions() {
  return "interceptor_via_lib:libOSMesa";
}
__attribute__((visibility("default"))) const char* __ubsan_default_options() { return "print_stacktrace=1"; }
}

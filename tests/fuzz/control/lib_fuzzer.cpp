// libFuzzer's door: control_lib_fuzzer [CORPUS].
#include "tests/fuzz/control/messages.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  gluray::fuzz::playBytes({reinterpret_cast<const char*>(data), size});
  return 0;
}

// For tests: skips statistical tests with many samples under sanitizers, which make code ten times slower.
// Other tests run the same code under sanitizers.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
namespace gluray {
inline constexpr bool kSanitized = true;
}
#define GLURAY_RELEASE_ONLY() GTEST_SKIP() << "counts many samples: the release suite runs it"
#else
namespace gluray {
inline constexpr bool kSanitized = false;
}
#define GLURAY_RELEASE_ONLY() static_cast<void>(0)
#endif

/* A library that a program needs and the test does not install. */
__attribute__((visibility("default"))) int gone(void);
int gone(void) { return 0; }

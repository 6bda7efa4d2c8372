/* A library that the test takes away from the program that needs it. */
__attribute__((visibility("default"))) int gone(void);
int gone(void) { return 0; }

/* Needs a library that is missing. */
int gone(void);
int main(void) { return gone(); }

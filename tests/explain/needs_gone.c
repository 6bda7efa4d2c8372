/* Needs a library that is not there. */
int gone(void);
int main(void) { return gone(); }

/* A statically linked program: gluray doctor must say so. */
int main(void) { return 0; }

/* A program that no library comes between: the doctor must say so. */
int main(void) { return 0; }

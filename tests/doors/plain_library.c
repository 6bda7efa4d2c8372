/* A library of the program's own that has nothing to do with OpenGL but its name: libGLabelPlot.so. */
int plot(void);
int plot(void) { return 1; }

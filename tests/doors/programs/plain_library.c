/* A library that has nothing to do with OpenGL, except that its name begins alike: libGLabelPlot.so. */
int plot(void);
int plot(void) { return 1; }

/* Stands for a program's bundled OpenGL library. */
const unsigned char* glGetString(unsigned name);
void* glXGetProcAddressARB(const unsigned char* name);

const unsigned char* glGetString(unsigned name) {
  return (const unsigned char*)(name == 0x1F02 ? "bundled" : 0);
}
void* glXGetProcAddressARB(const unsigned char* name) { return (void)name, (void*)0; }

/* OSMesa's interface. Mesa 25.1 removed it, so programs ship libOSMesa themselves. Plain C, for the engine,
   the tests' clients, and tools/c_headers.py, which reads the prototypes. Values and types follow Mesa's ABI.
   */
#pragma once
#include <GL/gl.h>

#define OSMESA_RGBA GL_RGBA

/* Attributes of OSMesaCreateContextAttribs. */
#define OSMESA_FORMAT 0x22
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

#ifdef __cplusplus
extern "C" {
#endif

typedef struct osmesa_context* OSMesaContext;
typedef void (*OSMESAproc)(void);

GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext share);
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                                      GLint accumBits, OSMesaContext share);
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int* attributes, OSMesaContext share);
GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext context);
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                                             GLsizei height);
GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);
GLAPI void GLAPIENTRY OSMesaPixelStore(GLint name, GLint value);
GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint name, GLint* value);
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext context, GLint* width, GLint* height,
                                                GLint* bytesPerValue, void** buffer);
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext context, GLint* width, GLint* height,
                                                GLint* format, void** buffer);
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char* name);
GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);
GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext context, const char* filter, unsigned enableValue);

#ifdef __cplusplus
}
#endif

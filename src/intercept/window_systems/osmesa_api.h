/* OSMesa's interface. Mesa 25.1 removed it, so programs ship libOSMesa themselves. Plain C, for the engine,
   the tests' clients, and tools/c_headers.py, which reads the prototypes. Values and types follow Mesa's ABI.
   */
#pragma once
#include <GL/gl.h>

/* Formats. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* Names of OSMesaPixelStore. */
#define OSMESA_ROW_LENGTH 0x10
#define OSMESA_Y_UP 0x11

/* Further names of OSMesaGetIntegerv. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

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

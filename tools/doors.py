"""Writes the jump tables of the doors, in C, so that doors need only libc.

Each entry point jumps through a table whose slots start as lazy resolvers. Types are reduced to what the calling
convention sees, so that no OpenGL or X11 header is needed.
"""
from __future__ import annotations

import c_headers
import glxml

C_TYPES = {
    "void": "void",
    "float": "GLfloat GLclampf float",
    "double": "GLdouble GLclampd",
    "signed char": "GLbyte",
    "unsigned char": "GLubyte GLboolean GLchar",
    "short": "GLshort",
    "unsigned short": "GLushort GLhalfNV GLhalf",
    "int": "GLint GLsizei GLfixed GLclampx Bool Status int EGLint EGLNativeFileDescriptorKHR",
    "unsigned": "GLenum GLuint GLbitfield GLhandleARB EGLenum EGLBoolean unsigned unsigned-int",
    "long": "GLintptr GLsizeiptr GLintptrARB GLsizeiptrARB GLvdpauSurfaceNV EGLAttrib EGLAttribKHR EGLAttribNV",
    "unsigned long": "unsigned-long XID Window Pixmap Colormap Font GLXDrawable GLXPixmap GLXWindow GLXPbuffer "
                     "GLXPbufferSGIX GLXContextID GLXVideoSourceSGIX GLXVideoCaptureDeviceNV EGLNativeWindowType "
                     "EGLNativePixmapType NativeWindowType NativePixmapType",
    "long long": "GLint64 GLint64EXT int64_t EGLTimeKHR EGLnsecsANDROID",
    "unsigned long long": "GLuint64 GLuint64EXT EGLTime EGLTimeNV EGLuint64KHR EGLuint64NV EGLTimeKHR",
    "unsigned int": "GLXVideoDeviceNV",
    "void *": "GLsync GLDEBUGPROC GLDEBUGPROCARB GLDEBUGPROCAMD GLVULKANPROCNV GLeglImageOES GLeglClientBufferEXT GLXContext GLXFBConfig "
              "GLXFBConfigSGIX __GLXextFuncPtr EGLDisplay EGLConfig EGLSurface EGLContext EGLSync EGLSyncKHR "
              "EGLSyncNV EGLImage EGLImageKHR EGLClientBuffer EGLNativeDisplayType EGLStreamKHR EGLDeviceEXT "
              "EGLOutputLayerEXT EGLOutputPortEXT EGLLabelKHR EGLObjectKHR EGLDEBUGPROCKHR EGLSetBlobFuncANDROID "
              "EGLGetBlobFuncANDROID __eglMustCastToProperFunctionPointerType OSMesaContext OSMESAproc",
}
BY_NAME = {name: c_type for c_type, names in C_TYPES.items() for name in names.split()}
UNKNOWN_TO_ANY_HEADER = {"DMbuffer", "VLServer", "VLPath", "VLNode"}  # SGI types: commands with them are left out


def _c_type(text: str) -> str:
    if "*" in text or text.startswith("struct "):
        return "void *"
    plain = text.replace("const ", "").strip().replace("unsigned int", "unsigned-int").replace("unsigned long", "unsigned-long")
    return BY_NAME[plain]


def _is_known(c: glxml.Command) -> bool:
    """Whether the calling convention of all its types is known. A newer header may have commands with unknown types: doors
    leave them out, so the program gets the real ones."""
    kinds = [c.ret, *(p.type for p in c.params)]
    try:
        return not UNKNOWN_TO_ANY_HEADER.intersection(kinds) and all(_c_type(kind) for kind in kinds)
    except KeyError:
        return False


def _entry(c: glxml.Command, index: int) -> str:
    types = [_c_type(p.type) for p in c.params]
    declared = ", ".join(f"{t} {chr(97 + i)}" if i < 26 else f"{t} a{i}" for i, t in enumerate(types)) or "void"
    passed = ", ".join(chr(97 + i) if i < 26 else f"a{i}" for i in range(len(types)))
    ret = _c_type(c.ret)
    run = "" if ret == "void" else "return "
    cast = f"({ret} (*)({', '.join(types) or 'void'}))"
    return (f"static {ret} lazy{index}({declared}) {{ {run}({cast}glurayResolve({index}))({passed}); }}\n"
            f'EXPORT {ret} jump{index}({declared}) __asm__("{c.name}");\n'
            f"{ret} jump{index}({declared}) {{ {run}({cast}SLOT({index}))({passed}); }}\n")


def _file(commands: list[glxml.Command], exported: bool) -> str:
    known = [c for c in commands if _is_known(c)]
    known.sort(key=lambda c: c.name)
    offsets, names, position = [], [], 0
    for c in known:
        offsets.append(position)
        names.append(f'"{c.name}\\0"')
        position += len(c.name) + 1
    n = len(known)
    export = '__attribute__((visibility("default")))' if exported else ""
    jumps = "" if exported else (f"void *const glurayJumps[{n}] = {{{', '.join(f'(void *)jump{i}' for i in range(n))}}};\n")
    entries = "".join(_entry(c, i) for i, c in enumerate(known))
    return f"""#include "intercept/doors/door_table.h"

#define EXPORT {export}
#define SLOT(i) __atomic_load_n(&glurayTable[i], __ATOMIC_RELAXED)

const int glurayCount = {n};
const char glurayNames[] = {' '.join(names)};
const unsigned glurayNameOffsets[{n}] = {{{', '.join(map(str, offsets))}}};
void *glurayTable[{n}];

{entries}
void *glurayTable[{n}] = {{{', '.join(f'(void *)lazy{i}' for i in range(n))}}};
{jumps}"""


def files(gl: list[glxml.Command]) -> dict[str, str]:
    """File name -> text, for the preload door and the two vendor doors."""
    glx = glxml.load("glx", ("glx",))
    egl = c_headers.egl()
    # preload.c implements GetProcAddress.
    answered = {"glXGetProcAddress", "glXGetProcAddressARB", "eglGetProcAddress", "OSMesaGetProcAddress"}
    everything = [c for c in [*gl, *glx, *egl, *c_headers.osmesa()] if c.name not in answered]
    return {
        "preload_table.gen.c": _file(everything, exported=True),
        "vendor_glx_table.gen.c": _file(glx, exported=False),
        "vendor_egl_table.gen.c": _file(egl, exported=False),
    }

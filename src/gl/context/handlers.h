// Handlers of the commands that spec/policy.toml gives class "own" or a handler: glFooBar -> fooBar(Context&,
// ...). Called by generated stubs on the thread where the context is current.
#pragma once
#include "gl/context/context.h"

#include <functional>

namespace gluray::gl {

// immediate mode (draw_handlers.cpp)
void begin(Context& c, GLenum mode);
void end(Context& c);
void materialf(Context& c, GLenum face, GLenum pname, GLfloat param);
void materiali(Context& c, GLenum face, GLenum pname, GLint param);
void materialfv(Context& c, GLenum face, GLenum pname, const GLfloat* params);
void materialiv(Context& c, GLenum face, GLenum pname, const GLint* params);
void arrayElement(Context& c, GLint i);
void rectf(Context& c, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2);
void rectd(Context& c, GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2);
void recti(Context& c, GLint x1, GLint y1, GLint x2, GLint y2);
void rects(Context& c, GLshort x1, GLshort y1, GLshort x2, GLshort y2);
void rectfv(Context& c, const GLfloat* v1, const GLfloat* v2);
void rectdv(Context& c, const GLdouble* v1, const GLdouble* v2);
void rectiv(Context& c, const GLint* v1, const GLint* v2);
void rectsv(Context& c, const GLshort* v1, const GLshort* v2);

// vertex arrays (array_draws.cpp)
void drawArrays(Context& c, GLenum mode, GLint first, GLsizei count);
void drawElements(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices);
void drawRangeElements(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices);
void drawElementsBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                            GLint base);
void drawRangeElementsBaseVertex(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                 GLenum type, const void* indices, GLint base);
void drawArraysInstanced(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances);
void drawArraysInstancedBaseInstance(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances,
                                     GLuint baseInstance);
void drawElementsInstanced(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                           GLsizei instances);
void drawElementsInstancedBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                                     GLsizei instances, GLint base);
void drawElementsInstancedBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type,
                                       const void* indices, GLsizei instances, GLuint baseInstance);
void drawElementsInstancedBaseVertexBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type,
                                                 const void* indices, GLsizei instances, GLint base,
                                                 GLuint baseInstance);
void multiDrawArrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws);
void multiDrawElements(Context& c, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei draws);
void multiDrawElementsBaseVertex(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                                 const void* const* indices, GLsizei draws, const GLint* base);

// draws whose parameters are in buffers (indirect_draws.cpp)
void drawArraysIndirect(Context& c, GLenum mode, const void* indirect);
void drawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect);
void multiDrawArraysIndirect(Context& c, GLenum mode, const void* indirect, GLsizei draws, GLsizei stride);
void multiDrawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect, GLsizei draws,
                               GLsizei stride);

// framebuffers (blits.cpp)
void blitFramebuffer(Context& c, GLint fromX0, GLint fromY0, GLint fromX1, GLint fromY1, GLint toX0,
                     GLint toY0, GLint toX1, GLint toY1, GLbitfield mask, GLenum filter);

// display lists (list_handlers.cpp)
void newList(Context& c, GLuint name, GLenum mode);
void endList(Context& c);
void callList(Context& c, GLuint name);
void callLists(Context& c, GLsizei n, GLenum type, const void* names);
GLuint genLists(Context& c, GLsizei range);
void deleteLists(Context& c, GLuint first, GLsizei range);
GLboolean isList(Context& c, GLuint name);
void listBase(Context& c, GLuint base);
// Labels of display lists are ours (list_labels.cpp).
void objectLabel(Context& c, GLenum identifier, GLuint name, GLsizei length, const GLchar* label);
void getObjectLabel(Context& c, GLenum identifier, GLuint name, GLsizei size, GLsizei* length, GLchar* label);
/// glXUseXFont: `make` calls the real one with a list base in the real OpenGL; our lists call those lists.
void useXFont(Context& c, int first, int count, int base, const std::function<void(int realBase)>& make);

// buffer objects (buffer_handlers.cpp, buffer_questions.cpp)
void bindBuffer(Context& c, GLenum target, GLuint name);
void deleteBuffers(Context& c, GLsizei n, const GLuint* names);
void bufferData(Context& c, GLenum target, GLsizeiptr size, const void* data, GLenum usage);
void bufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
void bufferStorage(Context& c, GLenum target, GLsizeiptr size, const void* data, GLbitfield flags);
void* mapBuffer(Context& c, GLenum target, GLenum access);
void* mapBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access);
GLboolean unmapBuffer(Context& c, GLenum target);
void flushMappedBufferRange(Context& c, GLenum target, GLintptr offset, GLsizeiptr length);
void getBufferSubData(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, void* data);
void getBufferParameteriv(Context& c, GLenum target, GLenum pname, GLint* params);
void getBufferParameteri64v(Context& c, GLenum target, GLenum pname, GLint64* params);
void getBufferPointerv(Context& c, GLenum target, GLenum pname, void** params);
/// Answers glGetBufferParameter for a buffer that is mapped, or whose contents the real OpenGL does not have.
/// False: ask the real OpenGL.
bool answers(const Buffer& buffer, GLenum pname, GLint64* value);
void copyBufferSubData(Context& c, GLenum readTarget, GLenum writeTarget, GLintptr readOffset,
                       GLintptr writeOffset, GLsizeiptr size);
// For commands by which the real OpenGL writes to buffers: send it our contents first; its own are read back
// later. Return the groups to touch.
uint32_t buffersChangedBelow(Context& c);                 // any buffer
uint32_t boundBufferChanged(Context& c, GLenum target);   // the one bound to `target`
uint32_t packBufferChanged(Context& c);                   // the pixel pack buffer: pixels were read into it
uint32_t queryBufferChanged(Context& c);                  // the query buffer: results were written into it
uint32_t boundStorageForeign(Context& c, GLenum target);  // the bound one's memory is shared with others

// buffer objects by name, or written where we do not see it (named_buffers.cpp)
void bindBufferBase(Context& c, GLenum target, GLuint index, GLuint name);
void bindBufferRange(Context& c, GLenum target, GLuint index, GLuint name, GLintptr offset, GLsizeiptr size);
void* mapNamedBuffer(Context& c, GLuint name, GLenum access);
void* mapNamedBufferEXT(Context& c, GLuint name, GLenum access);
void* mapNamedBufferRange(Context& c, GLuint name, GLintptr offset, GLsizeiptr length, GLbitfield access);
void* mapNamedBufferRangeEXT(Context& c, GLuint name, GLintptr offset, GLsizeiptr length, GLbitfield access);
GLboolean unmapNamedBuffer(Context& c, GLuint name);
GLboolean unmapNamedBufferEXT(Context& c, GLuint name);
void flushMappedNamedBufferRange(Context& c, GLuint name, GLintptr offset, GLsizeiptr length);
void flushMappedNamedBufferRangeEXT(Context& c, GLuint name, GLintptr offset, GLsizeiptr length);
void getNamedBufferPointerv(Context& c, GLuint name, GLenum pname, void** params);
void getNamedBufferPointervEXT(Context& c, GLuint name, GLenum pname, void** params);
void getNamedBufferParameteriv(Context& c, GLuint name, GLenum pname, GLint* params);
void getNamedBufferParameterivEXT(Context& c, GLuint name, GLenum pname, GLint* params);
void getNamedBufferParameteri64v(Context& c, GLuint name, GLenum pname, GLint64* params);
// Called before and after a real command that does the following; return the groups to touch.
uint32_t namedBufferRead(Context& c, GLuint name);                 // reads the buffer
uint32_t namedBufferChanged(Context& c, GLuint name);              // writes into it
uint32_t namedBufferReplaced(Context& c, GLuint name);             // gives it new memory
uint32_t namedBufferCopied(Context& c, GLuint from, GLuint to);    // copies `from` into `to`
uint32_t namedStorage(Context& c, GLuint name, GLbitfield flags);  // gives it immutable storage
uint32_t bufferForeign(Context& c, GLuint name);                   // may write it at any time from now on
uint32_t buffersForeign(Context& c, GLsizei count, const GLuint* names);
uint32_t readAsTexture(Context& c, GLuint name);  // reads it as a buffer texture

// Vertex array objects and their contents; return the groups to touch (attachments.cpp)
uint32_t vertexArrayBound(Context& c, GLuint array);
uint32_t vertexArraysDeleted(Context& c, GLsizei n, const GLuint* arrays);
uint32_t arraysPopped(Context& c);
uint32_t attributeSet(Context& c, GLuint binding);
uint32_t bindingsSet(Context& c, GLuint first, GLsizei count);
uint32_t bindingsOfArraySet(Context& c, GLuint array, GLuint first, GLsizei count);
uint32_t elementsOfArraySet(Context& c, GLuint array);
uint32_t fixedArraySet(Context& c, GLenum array);
uint32_t interleavedArraysSet(Context& c, GLenum format);

// framebuffer, attributes, queries (state_handlers.cpp)
void clear(Context& c, GLbitfield mask);
void flush(Context& c);
void finish(Context& c);
void fenceSync(Context& c, GLenum condition, GLbitfield flags);
void pushAttrib(Context& c, GLbitfield mask);
void popAttrib(Context& c);
GLenum getError(Context& c);
const GLubyte* getString(Context& c, GLenum name);
const GLubyte* getStringi(Context& c, GLenum name, GLuint index);
/// Images of `type`, GL_TEXTURE or GL_RENDERBUFFER, are attached to framebuffer objects, or deleted: unbound
/// framebuffer objects may still hold them. Return groups to touch (attached_images.cpp).
uint32_t imageAttached(Context& c, GLenum target, GLenum attachment, GLenum type, GLuint name);
uint32_t imageAttachedTo(Context& c, GLuint framebuffer, GLenum attachment, GLenum type, GLuint name);
uint32_t imagesDeleted(Context& c, GLenum type, GLsizei n, const GLuint* names);
uint32_t framebuffersDeleted(Context& c, GLsizei n, const GLuint* names);
void getIntegerv(Context& c, GLenum pname, GLint* data);
void getFloatv(Context& c, GLenum pname, GLfloat* data);
void getDoublev(Context& c, GLenum pname, GLdouble* data);
void getBooleanv(Context& c, GLenum pname, GLboolean* data);
void getInteger64v(Context& c, GLenum pname, GLint64* data);
void beginQuery(Context& c, GLenum target, GLuint id);
void beginQueryIndexed(Context& c, GLenum target, GLuint index, GLuint id);
void endQuery(Context& c, GLenum target);
void endQueryIndexed(Context& c, GLenum target, GLuint index);
void beginConditionalRender(Context& c, GLuint id, GLenum mode);
void endConditionalRender(Context& c);
void matrixMode(Context& c, GLenum mode);
// The following return the groups to touch.
/// For commands on the current matrix.
uint32_t matrixGroups(Context& c);
/// A shader program gets a binary, is deleted, or is linked again.
uint32_t programChanged(Context& c, GLuint program);
uint32_t programDeleted(Context& c, GLuint program);
uint32_t programLinked(Context& c, GLuint program);
/// The flush that glBindFramebuffer needs: none if `framebuffer` is already bound to `target`, as in toolkits
/// that bind it before every swap.
Context::Flush flushToBind(Context& c, GLenum target, GLuint framebuffer);
/// The flush that a command needs that reads pixels of this format.
Context::Flush flushToRead(GLenum format);
/// The bound read framebuffer is copied into a texture, or textures are read: the pictures in them are
/// finished.
void pictureCopied(Context& c);
/// The same for a texture image of this internal format, or for the bound one: depths are no picture.
void pictureCopied(Context& c, GLenum internalFormat);
void pictureCopied(Context& c, GLenum target, GLint level);
void imagesRead(Context& c);
/// A texture is attached to a framebuffer; another framebuffer is bound.
uint32_t textureAttached(Context& c, GLuint texture);
uint32_t framebufferBound(Context& c);
/// Any texture image may have changed.
uint32_t imagesChanged(Context& c);
// Commands that set stencil values, or let later draws set them.
uint32_t capabilityEnabled(Context& c, GLenum capability);
uint32_t stencilSent(Context& c, GLenum format, const void* pixels);  // only if `format` has stencil values
uint32_t capabilityDisabled(Context& c, GLenum capability);
// Commands that make the real OpenGL store held-back current values (CurrentValues), or may do so.
uint32_t colorMaterialSet(Context& c, GLenum face, GLenum mode);
uint32_t materialAsked(Context& c);
/// Reports that the real OpenGL has answered glGet of `pname`. It stores all values for a query of one.
void noteCurrentValueQuery(Context& c, GLenum pname);
uint32_t stencilSet(Context& c);
/// As imagesChanged(), for the texture bound to `target` alone, and for deleted textures.
uint32_t imageChanged(Context& c, GLenum target);
uint32_t imageCopied(Context& c, GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);
uint32_t texturesDeleted(Context& c, GLsizei n, const GLuint* names);

}  // namespace gluray::gl

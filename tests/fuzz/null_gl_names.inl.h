// The table from names to the functions of NullGl. Part of null_gl.cpp, after null_gl_functions.inl.h.

void addState(NullFunctions& functions) {
  using F = GLfloat;
  using D = GLdouble;
  using E = GLenum;
  IS(GetString, getString);
  IS(GetError, []() -> E { return std::exchange(now().error, GLenum{GL_NO_ERROR}); });
  IS(GetIntegerv, get<GLint>);
  IS(GetFloatv, get<F>);
  IS(GetDoublev, get<D>);
  IS(GetBooleanv, get<GLboolean>);
  IS(GetPointerv, getPointerv);
  IS(IsEnabled, isEnabled);
  IS(Enable, [](E c) { now().enabled.insert(switchOf(c)); });
  IS(Disable, [](E c) { now().enabled.erase(switchOf(c)); });
  IS(MatrixMode, [](E m) {
    if (m == GL_MODELVIEW || m == GL_PROJECTION || m == GL_TEXTURE) put(GL_MATRIX_MODE, {double(m)});
  });
  IS(LoadIdentity, []() { matrix() = glm::dmat4(1); });
  IS(LoadMatrixf, [](const F* m) { matrix() = glm::dmat4(glm::make_mat4(m)); });
  IS(LoadMatrixd, [](const D* m) { matrix() = glm::make_mat4(m); });
  IS(MultMatrixf, [](const F* m) { matrix() *= glm::dmat4(glm::make_mat4(m)); });
  IS(MultMatrixd, [](const D* m) { matrix() *= glm::make_mat4(m); });
  IS(Translatef, [](F x, F y, F z) { matrix() = glm::translate(matrix(), glm::dvec3(x, y, z)); });
  IS(Translated, [](D x, D y, D z) { matrix() = glm::translate(matrix(), glm::dvec3(x, y, z)); });
  IS(Scalef, [](F x, F y, F z) { matrix() = glm::scale(matrix(), glm::dvec3(x, y, z)); });
  IS(Scaled, [](D x, D y, D z) { matrix() = glm::scale(matrix(), glm::dvec3(x, y, z)); });
  IS(Rotatef, [](F a, F x, F y, F z) {
    matrix() = glm::rotate(matrix(), glm::radians(double(a)), glm::dvec3(x, y, z));
  });
  IS(Rotated,
     [](D a, D x, D y, D z) { matrix() = glm::rotate(matrix(), glm::radians(a), glm::dvec3(x, y, z)); });
  IS(Frustum, [](D l, D r, D b, D t, D n, D e) { matrix() *= glm::frustum(l, r, b, t, n, e); });
  IS(Ortho, [](D l, D r, D b, D t, D n, D e) { matrix() *= glm::ortho(l, r, b, t, n, e); });
  IS(PushMatrix, pushMatrix);
  IS(PopMatrix, popMatrix);
  IS(Viewport, [](GLint x, GLint y, GLsizei w, GLsizei h) {
    if (w >= 0 && h >= 0) put(GL_VIEWPORT, {double(x), double(y), double(w), double(h)});
  });
  IS(Scissor, [](GLint x, GLint y, GLsizei w, GLsizei h) {
    if (w >= 0 && h >= 0) put(GL_SCISSOR_BOX, {double(x), double(y), double(w), double(h)});
  });
  IS(DepthRange, [](D n, D f) { put(GL_DEPTH_RANGE, {n, f}); });
  IS(DepthFunc, [](E v) { put(GL_DEPTH_FUNC, {double(v)}); });
  IS(DepthMask, [](GLboolean v) { put(GL_DEPTH_WRITEMASK, {double(v)}); });
  IS(ColorMask, [](GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
    put(GL_COLOR_WRITEMASK, {double(r), double(g), double(b), double(a)});
  });
  IS(BlendFunc, blendFunc);
  IS(BlendEquation,
     [](E v) { put(GL_BLEND_EQUATION_RGB, {double(v)}), put(GL_BLEND_EQUATION_ALPHA, {double(v)}); });
  IS(AlphaFunc, [](E v, F r) { put(GL_ALPHA_TEST_FUNC, {double(v)}), put(GL_ALPHA_TEST_REF, {double(r)}); });
  IS(ShadeModel, [](E v) { put(GL_SHADE_MODEL, {double(v)}); });
  IS(CullFace, [](E v) { put(GL_CULL_FACE_MODE, {double(v)}); });
  IS(FrontFace, [](E v) { put(GL_FRONT_FACE, {double(v)}); });
  IS(PolygonMode, [](E, E v) { put(GL_POLYGON_MODE, {double(v), double(v)}); });
  IS(PolygonOffset, [](F a, F b) { put(GL_POLYGON_OFFSET_FACTOR, {a}), put(GL_POLYGON_OFFSET_UNITS, {b}); });
  IS(DrawBuffer, [](E v) { put(GL_DRAW_BUFFER, {double(v)}); });
  IS(RenderMode, [](E v) -> GLint { return put(GL_RENDER_MODE, {double(v)}), 0; });
  IS(ActiveTexture, [](E v) {
    if (v - GL_TEXTURE0 < 16) put(GL_ACTIVE_TEXTURE, {double(v)});
  });
  IS(ClientActiveTexture, [](E v) {
    if (v - GL_TEXTURE0 < 8) put(GL_CLIENT_ACTIVE_TEXTURE, {double(v)});
  });
  IS(ColorMaterial, [](E f, E p) {
    put(GL_COLOR_MATERIAL_FACE, {double(f)}), put(GL_COLOR_MATERIAL_PARAMETER, {double(p)});
  });
  // For a name of another command they read at most one number.
  IS(LightModelfv,
     [](E n, const F* v) { now().values[n] = Values(v, v + (n == GL_LIGHT_MODEL_AMBIENT ? 4 : 1)); });
  IS(LightModelf, [](E n, F v) { put(n, {v}); });
  IS(LightModeli, [](E n, GLint v) { put(n, {double(v)}); });
  IS(Fogfv, [](E n, const F* v) { now().values[n] = Values(v, v + (n == GL_FOG_COLOR ? 4 : 1)); });
}

void addValues(NullFunctions& functions) {
  using F = GLfloat;
  using E = GLenum;
  IS(Fogf, [](E n, F v) { put(n, {v}); });
  IS(Fogi, [](E n, GLint v) { put(n, {double(v)}); });
  IS(Lightfv, [](E l, E n, const F* v) { set(now().lights, l, n, v); });
  IS(Lightf, [](E l, E n, F v) {
    if (parametersOf(n) == 1) set(now().lights, l, n, &v);
  });
  IS(GetLightfv, [](E l, E n, F* v) { read(now().lights, l, n, v); });
  IS(Materialfv, setMaterial);
  IS(Materialf, [](E face, E n, F v) {
    if (parametersOf(n) == 1) setMaterial(face, n, &v);
  });
  IS(GetMaterialfv, [](E face, E n, F* v) { read(now().materials, face, n, v); });
  IS(TexEnvfv, [](E t, E n, const F* v) { set(now().environments, t, n, v); });
  IS(TexEnvi, [](E t, E n, GLint v) {
    if (parametersOf(n) == 1) set(now().environments, t, n, &v);
  });
  IS(TexEnvf, [](E t, E n, F v) {
    if (parametersOf(n) == 1) set(now().environments, t, n, &v);
  });
  IS(GetTexEnvfv, [](E t, E n, F* v) { read(now().environments, t, n, v); });
  IS(GetTexEnviv, [](E t, E n, GLint* v) { read(now().environments, t, n, v); });
  IS(TexGenfv, [](E t, E n, const F* v) { set(now().generators, t, n, v); });
  IS(TexGeni, [](E t, E n, GLint v) {
    if (parametersOf(n) == 1) set(now().generators, t, n, &v);
  });
  IS(GetTexGenfv, [](E t, E n, F* v) { read(now().generators, t, n, v); });
  IS(GetTexGeniv, [](E t, E n, GLint* v) { read(now().generators, t, n, v); });
  IS(Color4fv, [](const F* v) { put(GL_CURRENT_COLOR, {v[0], v[1], v[2], v[3]}); });
  IS(Normal3fv, [](const F* v) { put(GL_CURRENT_NORMAL, {v[0], v[1], v[2]}); });
  IS(TexCoord4fv, [](const F* v) { put(GL_CURRENT_TEXTURE_COORDS, {v[0], v[1], v[2], v[3]}); });
  IS(FogCoordfv, [](const F* v) { put(GL_CURRENT_FOG_COORD, {v[0]}); });
  IS(EdgeFlag, [](GLboolean v) { put(GL_EDGE_FLAG, {double(v)}); });
  IS(GetVertexAttribfv, [](GLuint, E, F* v) { v[0] = v[1] = v[2] = 0, v[3] = 1; });
  IS(PushAttrib, [](GLbitfield) {
    if (now().saved.size() < 16) now().saved.push_back(now());
  });
  IS(PopAttrib, popAttrib);
  IS(GenLists, genLists);
  IS(GenBuffers, generate);
  IS(GenTextures, generate);
  IS(BindBuffer, [](E t, GLuint n) { now().bound[t] = n; });
  IS(DeleteBuffers, deleteBuffers);
  IS(BufferData, bufferData);
  IS(BufferSubData, bufferSubData);
  IS(GetBufferSubData, getBufferSubData);
  IS(GetBufferParameteriv, getBufferParameteriv);
  IS(MapBufferRange, mapBufferRange);
  IS(MapBuffer, [](E t, E) -> void* {
    auto* bytes = buffer(t);
    return bytes && !bytes->empty() ? bytes->data() : nullptr;
  });
  IS(UnmapBuffer, [](E) -> GLboolean { return GL_TRUE; });
}

void addObjects(NullFunctions& functions) {
  using F = GLfloat;
  using D = GLdouble;
  using E = GLenum;
  IS(GetBufferPointerv, [](E, E, void** out) { *out = nullptr; });
  IS(CopyBufferSubData, [](E, E, GLintptr, GLintptr, GLsizeiptr) {});
  IS(EnableClientState, [](E a) { array(a).enabled = 1; });
  IS(DisableClientState, [](E a) { array(a).enabled = 0; });
  IS(VertexPointer, pointer<GL_VERTEX_ARRAY>);
  IS(ColorPointer, pointer<GL_COLOR_ARRAY>);
  IS(TexCoordPointer, pointer<GL_TEXTURE_COORD_ARRAY>);
  IS(SecondaryColorPointer, pointer<GL_SECONDARY_COLOR_ARRAY>);
  IS(NormalPointer, pointerOf<GL_NORMAL_ARRAY, 3>);
  IS(FogCoordPointer, pointerOf<GL_FOG_COORD_ARRAY, 1>);
  IS(EnableVertexAttribArray, [](GLuint i) { now().attributes[i & 15].enabled = 1; });
  IS(DisableVertexAttribArray, [](GLuint i) { now().attributes[i & 15].enabled = 0; });
  IS(VertexAttribPointer, vertexAttribPointer);
  IS(VertexAttribDivisor,
     [](GLuint i, GLuint divisor) { now().attributes[i & 15].divisor = static_cast<GLint>(divisor); });
  IS(GenVertexArrays, generate);
  IS(BindVertexArray, bindVertexArray);
  IS(DeleteVertexArrays, deleteVertexArrays);
  IS(GetVertexAttribiv, getVertexAttribiv);
  IS(GetVertexAttribPointerv,
     [](GLuint i, E, void** out) { *out = const_cast<void*>(now().attributes[i & 15].pointer); });
  IS(BindTexture, [](E t, GLuint n) { now().images[{enumOf(GL_ACTIVE_TEXTURE), t}] = n; });
  IS(DeleteTextures, [](GLsizei n, const GLuint* names) {
    for (GLsizei i = 0; i < n; ++i) now().objects->textures.erase(names[i]);
  });
  IS(TexImage1D, [](E t, GLint l, GLint f, GLsizei w, GLint, E, E, const void*) { image(t, l, f, w, 1, 1); });
  IS(TexImage2D,
     [](E t, GLint l, GLint f, GLsizei w, GLsizei h, GLint, E, E, const void*) { image(t, l, f, w, h, 1); });
  IS(TexImage3D, [](E t, GLint l, GLint f, GLsizei w, GLsizei h, GLsizei d, GLint, E, E, const void*) {
    image(t, l, f, w, h, d);
  });
  IS(TexBuffer, [](E t, E form, GLuint name) {
    texture(t).levels[{t, 0}] = {0, 0, 0, static_cast<GLint>(form), name};
  });
  IS(GetTexImage, getTexImage);
  IS(GetTexLevelParameteriv, getTexLevelParameteriv);
  IS(TexParameteri, [](E t, E n, GLint v) {
    if (parametersOf(n) == 1) texParameterv(t, n, &v);
  });
  IS(TexParameterf, [](E t, E n, F v) {
    if (parametersOf(n) == 1) texParameterv(t, n, &v);
  });
  IS(TexParameteriv, texParameterv<GLint>);
  IS(TexParameterfv, texParameterv<F>);
  IS(GetTexParameteriv, getTexParameter<GLint>);
  IS(GetTexParameterfv, getTexParameter<F>);
  IS(BindFramebuffer, [](E, GLuint n) { put(GL_DRAW_FRAMEBUFFER_BINDING, {double(n)}); });
  IS(CheckFramebufferStatus, [](E) -> E { return GL_FRAMEBUFFER_COMPLETE; });
  IS(GetFramebufferAttachmentParameteriv, getFramebufferAttachment);
  IS(GetClipPlane, [](E, D* v) { v[0] = v[1] = v[2] = 0, v[3] = 1; });
}

NullFunctions functionsByName() {
  NullFunctions functions;
  addState(functions), addValues(functions), addObjects(functions), addPrograms(functions);
  return functions;
}

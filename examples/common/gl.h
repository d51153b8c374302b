/* gl: OpenGL 4.5 core through function pointers, so that a program need not link any libGL, and the helpers around
   shaders. Load the pointers with the address function of whatever made the context (OSMesa, GLFW, EGL). */
#ifndef EXAMPLES_GL_H
#define EXAMPLES_GL_H

#include <GL/glcorearb.h>

#include "why.h"

/* One list for declarations and loading: the type's name in <GL/glcorearb.h> and the function's, less PFNGL and gl. */
#define GL_FUNCTIONS(X) \
    X(ATTACHSHADER, AttachShader)               X(BINDBUFFERBASE, BindBufferBase) \
    X(BINDFRAMEBUFFER, BindFramebuffer)         X(BINDTEXTUREUNIT, BindTextureUnit) \
    X(BINDVERTEXARRAY, BindVertexArray)         X(CLEARBUFFERFV, ClearBufferfv) \
    X(COMPILESHADER, CompileShader) \
    X(CREATEBUFFERS, CreateBuffers)             X(CREATEFRAMEBUFFERS, CreateFramebuffers) \
    X(CREATEPROGRAM, CreateProgram)             X(CREATERENDERBUFFERS, CreateRenderbuffers) \
    X(CREATESHADER, CreateShader)               X(CREATETEXTURES, CreateTextures) \
    X(CREATEVERTEXARRAYS, CreateVertexArrays)   X(DELETEBUFFERS, DeleteBuffers) \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)   X(DELETEPROGRAM, DeleteProgram) \
    X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESHADER, DeleteShader) \
    X(DELETETEXTURES, DeleteTextures)           X(DELETEVERTEXARRAYS, DeleteVertexArrays) \
    X(DEPTHFUNC, DepthFunc)                     X(DISABLE, Disable) \
    X(DISPATCHCOMPUTE, DispatchCompute) \
    X(DRAWARRAYS, DrawArrays)                   X(ENABLE, Enable) \
    X(FINISH, Finish)                           X(GETERROR, GetError) \
    X(GETINTEGER64V, GetInteger64v)             X(GETINTEGERV, GetIntegerv) \
    X(GETNAMEDBUFFERSUBDATA, GetNamedBufferSubData) \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)     X(GETPROGRAMIV, GetProgramiv) \
    X(GETSHADERINFOLOG, GetShaderInfoLog)       X(GETSHADERIV, GetShaderiv) \
    X(GETUNIFORMLOCATION, GetUniformLocation) \
    X(LINKPROGRAM, LinkProgram)                 X(MEMORYBARRIER, MemoryBarrier) \
    X(NAMEDBUFFERDATA, NamedBufferData) \
    X(NAMEDBUFFERSUBDATA, NamedBufferSubData) \
    X(NAMEDFRAMEBUFFERRENDERBUFFER, NamedFramebufferRenderbuffer) \
    X(NAMEDRENDERBUFFERSTORAGE, NamedRenderbufferStorage) \
    X(READPIXELS, ReadPixels)                   X(SHADERSOURCE, ShaderSource) \
    X(TEXTUREBUFFER, TextureBuffer) \
    X(TEXTUREPARAMETERI, TextureParameteri)     X(TEXTURESTORAGE2D, TextureStorage2D) \
    X(TEXTURESUBIMAGE2D, TextureSubImage2D)     X(UNIFORM3FV, Uniform3fv) \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)       X(USEPROGRAM, UseProgram) \
    X(VIEWPORT, Viewport)

typedef struct gl_functions {
#define GL_DECLARE(type, name) PFNGL##type##PROC name;
    GL_FUNCTIONS(GL_DECLARE)
#undef GL_DECLARE
} gl_functions;

extern gl_functions gl;                /* filled by gl_load: call gl.DrawArrays(...) with a context current */

typedef void (*gl_pointer)(void);
typedef gl_pointer (*gl_address)(const char *name);

/* Fills `gl`. 0, or -1 with the first function that is missing in w. */
int gl_load(gl_address address, why *w);

/* Compiles and links; `defines` (may be "") is put behind the #version line of both. 0 with the reason in w. */
GLuint gl_program(const char *name, const char *defines, const char *vertex, const char *fragment, why *w);

/* The first OpenGL error since the last call, as -1 and a line; 0: none. */
int gl_check(const char *doing, why *w);

#endif

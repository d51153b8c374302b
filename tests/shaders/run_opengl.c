#include "runner.h"

#include <stddef.h>
#include "gl.h"

static GLuint compile(GLenum stage, const char *text, why *w) {
    GLuint shader = gl.CreateShader(stage);
    GLint ok = 0;
    gl.ShaderSource(shader, 1, &text, NULL);
    gl.CompileShader(shader);
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[600] = "";
        gl.GetShaderInfoLog(shader, sizeof log, NULL, log);
        why_set(w, "GLSL: %s", log);
        return 0;
    }
    return shader;
}

static GLuint link_program(GLuint a, GLuint b, why *w) {
    GLuint program;
    GLint ok = 0;
    if (!a) return 0;
    program = gl.CreateProgram();
    gl.AttachShader(program, a);
    if (b) gl.AttachShader(program, b);
    gl.LinkProgram(program);
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    gl.DeleteShader(a);
    if (b) gl.DeleteShader(b);
    if (!ok) why_set(w, "GLSL: the program does not link");
    return ok ? program : 0;
}

static GLuint buffer_of(const void *data, size_t bytes) {
    GLuint buffer;
    gl.CreateBuffers(1, &buffer);
    gl.NamedBufferData(buffer, (GLsizeiptr)(bytes ? bytes : 4), data, GL_STATIC_DRAW);
    return buffer;
}

static size_t bytes_of(const work *job, int each) { return (size_t)job->items * (size_t)each * sizeof(float); }

int run_opengl_compute(const char *text, const work *job, why *w) {
    GLuint program = link_program(compile(GL_COMPUTE_SHADER, text, w), 0, w), buffers[2];
    if (!program) return -1;
    buffers[0] = buffer_of(job->in, bytes_of(job, job->ins));
    buffers[1] = buffer_of(NULL, bytes_of(job, job->outs));
    gl.UseProgram(program);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers[1]);
    gl.DispatchCompute((GLuint)job->items / 64, 1, 1);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl.GetNamedBufferSubData(buffers[1], 0, (GLsizeiptr)bytes_of(job, job->outs), job->out);
    gl.DeleteBuffers(2, buffers);
    gl.DeleteProgram(program);
    return gl_check("running a compute shader", w);
}

int run_opengl_fragment(const char *text, const work *job, why *w) {
    static const char triangle[] =
        "#version 330\n"
        "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n";
    GLuint shader = compile(GL_FRAGMENT_SHADER, text, w), program, buffer, texture, frame, target, array;
    program = shader ? link_program(shader, compile(GL_VERTEX_SHADER, triangle, w), w) : 0;
    if (!program) return -1;
    buffer = buffer_of(job->in, bytes_of(job, job->ins));
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    gl.TextureBuffer(texture, GL_R32F, buffer);
    gl.CreateFramebuffers(1, &frame);
    gl.CreateRenderbuffers(1, &target);
    gl.NamedRenderbufferStorage(target, GL_RGBA32F, job->outs, job->items);
    gl.NamedFramebufferRenderbuffer(frame, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
    gl.CreateVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl.Viewport(0, 0, job->outs, job->items);
    gl.UseProgram(program);
    gl.BindTextureUnit(0, texture);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ReadPixels(0, 0, job->outs, job->items, GL_RED, GL_FLOAT, job->out);
    gl.DeleteVertexArrays(1, &array);
    gl.DeleteRenderbuffers(1, &target);
    gl.DeleteFramebuffers(1, &frame);
    gl.DeleteTextures(1, &texture);
    gl.DeleteBuffers(1, &buffer);
    gl.DeleteProgram(program);
    return gl_check("running a fragment shader", w);
}

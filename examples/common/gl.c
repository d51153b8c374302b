#include "gl.h"

#include <stdio.h>
#include <string.h>

gl_functions gl;

int gl_load(gl_address address, why *w) {
    gl_pointer found;
#define GL_LOAD(type, name) \
    found = address("gl" #name); \
    if (!found) return why_set(w, "OpenGL: gl%s is missing: a driver with OpenGL 4.5 is needed", #name); \
    memcpy(&gl.name, &found, sizeof found);
    GL_FUNCTIONS(GL_LOAD)
#undef GL_LOAD
    return 0;
}

int gl_check(const char *doing, why *w) {
    GLenum error = gl.GetError();
    return error == GL_NO_ERROR ? 0 : why_set(w, "OpenGL error 0x%04x while %s", error, doing);
}

static void one_line(char *text) {
    for (; *text; text++) if (*text == '\n' || *text == '\r') *text = ' ';
}

static GLuint compile(const char *name, GLenum stage, const char *defines, const char *source, why *w) {
    const char *parts[3];
    GLuint shader = gl.CreateShader(stage);
    GLint compiled = 0;
    parts[0] = "#version 450 core\n";
    parts[1] = defines;
    parts[2] = source;
    gl.ShaderSource(shader, 3, parts, NULL);
    gl.CompileShader(shader);
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[400] = "";
        gl.GetShaderInfoLog(shader, sizeof log, NULL, log);
        one_line(log);
        why_set(w, "shader %s: %s", name, log);
        gl.DeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint gl_program(const char *name, const char *defines, const char *vertex, const char *fragment, why *w) {
    GLuint program = 0, vs = compile(name, GL_VERTEX_SHADER, defines, vertex, w), fs = 0;
    GLint linked = 0;
    if (vs) fs = compile(name, GL_FRAGMENT_SHADER, defines, fragment, w);
    if (fs) {
        program = gl.CreateProgram();
        gl.AttachShader(program, vs);
        gl.AttachShader(program, fs);
        gl.LinkProgram(program);
        gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
        if (!linked) {
            char log[400] = "";
            gl.GetProgramInfoLog(program, sizeof log, NULL, log);
            one_line(log);
            why_set(w, "program %s: %s", name, log);
            gl.DeleteProgram(program);
            program = 0;
        }
        gl.DeleteShader(fs);
    }
    if (vs) gl.DeleteShader(vs);
    return program;
}

// The same triangles by Mesa's software rasterizer, off screen: what people use who need no GPU.
//   LP_NUM_THREADS=0 llvmpipe FILE.tri ROUNDS [OUT.png]   prints as `texelscope bench` does
// Depth (LESS) and culling as the file asks for them; nearest, repeat, into RGBA8. It is not exact about
//   where a corner lies    rounded to 1/256 px
//   what lies far outside  cut at its guard band, the cut's corners rounded again
//   which texel            u and v are float32 planes over the screen
//   how deep               so is z; where two are nearly as deep, either may win
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/image/packed.h"
#include "core/scene/triangles_scene.h"
#include "tests/bench/peers/peer.h"

namespace texelscope::peer {
namespace {

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec4 place;
layout(location = 1) in vec2 uv;
uniform vec2 size;
uniform bool perspective;
out vec2 at;
void main() {
    vec2 on_screen = vec2(2.0 * place.x / size.x - 1.0, 2.0 * place.y / size.y - 1.0);
    gl_Position = vec4(on_screen, 2.0 * place.z - 1.0, 1.0) * (perspective ? place.w : 1.0);
    at = uv;
})";
constexpr const char* kFragment = R"(#version 330 core
in vec2 at;
uniform sampler2D image;
out vec4 colour;
void main() { colour = texture(image, at); })";

void open_context() {
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (display_of == nullptr) stop("there is no EGL platform display");
    EGLDisplay display = display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) stop("EGL does not start");
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context == EGL_NO_CONTEXT || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
        stop("there is no OpenGL 3.3 without a surface");
    const std::string_view name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    if (name.find("llvmpipe") == name.npos) stop("OpenGL is by " + std::string(name) + ", expected llvmpipe");
    const char* const threads = std::getenv("LP_NUM_THREADS");
    if (threads == nullptr || std::string_view(threads) != "0")
        stop("expected LP_NUM_THREADS=0: it draws on one thread");
}

[[nodiscard]] GLuint shader(GLenum kind, const char* text) {
    const GLuint id = glCreateShader(kind);
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint good = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    if (good == 0) stop("a shader does not compile");
    return id;
}

void make_program(const TrianglesFile& file) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader(GL_VERTEX_SHADER, kVertex));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, kFragment));
    glLinkProgram(program);
    glUseProgram(program);
    glUniform2f(glGetUniformLocation(program, "size"), static_cast<float>(file.width), static_cast<float>(file.height));
    glUniform1i(glGetUniformLocation(program, "perspective"), file.perspective ? 1 : 0);
}

void make_target(const TrianglesFile& file) {
    GLuint frame = 0;
    std::array<GLuint, 2> stores{};
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glGenRenderbuffers(2, stores.data());
    const std::array<GLenum, 2> formats{GL_RGBA8, GL_DEPTH_COMPONENT32F},
        places{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (std::size_t n = 0; n < (file.depth ? 2U : 1U); ++n) {
        glBindRenderbuffer(GL_RENDERBUFFER, stores[n]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[n], file.width, file.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[n], GL_RENDERBUFFER, stores[n]);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) stop("the framebuffer is not complete");
    glViewport(0, 0, file.width, file.height);
}

void make_input(const TrianglesFile& file) {
    GLuint array = 0, buffer = 0, texture = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(file.vertices.size() * sizeof(Vertex)), file.vertices.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(16));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    const std::vector<std::uint32_t> texels = packed(default_texels(file), file.texture_width);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, file.texture_width, file.texture_height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    for (const GLenum side : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, side, GL_NEAREST);
    if (file.depth) glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LESS);
    // The file's first row is OpenGL's lowest, so front faces are counterclockwise there.
    if (file.cull_back) glEnable(GL_CULL_FACE), glFrontFace(GL_CCW);
}

void run(const Call& call) {
    const TrianglesFile& file = call.file;
    open_context();
    make_program(file), make_target(file), make_input(file);
    const auto clear = [] {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glFinish();
    };
    race(call, "llvmpipe", clear, [&] {
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(file.vertices.size()));
        glFinish();
    });
    if (call.picture.empty()) return;
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height));
    glReadPixels(0, 0, file.width, file.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    write_picture(call, unpacked(pixels.data(), file.width, file.width, file.height));
}

}  // namespace
}  // namespace texelscope::peer

int main(int count, char** words) { texelscope::peer::run(texelscope::peer::read_call(count, words)); }

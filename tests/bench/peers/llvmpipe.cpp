// The same triangles by Mesa's software rasterizer, off screen: what people use who need no GPU.
//   LP_NUM_THREADS=0 llvmpipe FILE.tri ROUNDS [OUT.png]   prints as `texelscope bench` does
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/base/file.h"
#include "core/image/load.h"
#include "core/image/patterns.h"
#include "core/scene/triangles_file.h"

namespace texelscope {
namespace {

[[noreturn]] void stop(const char* what) {
    std::fprintf(stderr, "llvmpipe: %s\n", what);
    std::exit(2);
}

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec4 place;
layout(location = 1) in vec2 uv;
uniform vec2 size;
out vec2 at;
void main() {
    vec2 on_screen = vec2(2.0 * place.x / size.x - 1.0, 2.0 * place.y / size.y - 1.0);
    gl_Position = vec4(on_screen, 2.0 * place.z - 1.0, 1.0) * place.w;
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
    const Image image = make_pattern(Pattern::uv, file.texture_width, file.texture_height, 1);
    std::vector<std::uint8_t> texels;
    for (std::size_t n = 0; n < image.size(); ++n)
        texels.insert(texels.end(), {image.data()[n].r, image.data()[n].g, image.data()[n].b, 255});
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, file.texture_width, file.texture_height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    for (const GLenum side : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, side, GL_NEAREST);
    if (file.depth) glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LESS);
    // y runs downward in the file's rows and in those of the framebuffer as they are read: what is clockwise there is
    // counterclockwise to OpenGL once more upside down.
    if (file.cull_back) glEnable(GL_CULL_FACE), glFrontFace(GL_CCW);
}

/// @return  of drawing alone, until all is in the framebuffer [ms]
[[nodiscard]] double draw(const TrianglesFile& file) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(file.vertices.size()));
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

int run(const char* path, int rounds, const char* picture) {
    constexpr std::size_t kMostBytes = 64 + std::size_t{kMaxFileTriangles} * 72;
    const auto bytes = read_file(path, kMostBytes);
    if (!bytes) stop(bytes.error().text().c_str());
    const auto file = parse_triangles(*bytes, path);
    if (!file) stop(file.error().text().c_str());
    open_context();
    make_program(*file), make_target(*file), make_input(*file);
    static_cast<void>(draw(*file));  // the shaders are compiled at their first use
    std::vector<double> times;
    for (int n = 0; n < rounds; ++n) times.push_back(draw(*file));
    std::sort(times.begin(), times.end());
    const double median = times[times.size() / 2];
    std::printf("llvmpipe,t1,%s,%.4f,%.4f,%.2f,%.3f\n", std::filesystem::path(path).stem().c_str(), median, times[0],
                static_cast<double>(file->covered) / median / 1e3,
                static_cast<double>(file->vertices.size() / 3) / median / 1e3);
    if (picture == nullptr) return 0;
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(file->width) * static_cast<std::size_t>(file->height) * 4);
    glReadPixels(0, 0, file->width, file->height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Image image(file->width, file->height);
    for (std::size_t n = 0; n < image.size(); ++n) image.data()[n] = {rgba[4 * n], rgba[4 * n + 1], rgba[4 * n + 2]};
    const auto png = encode_png(image);
    return png && !write_file_atomically(picture, *png) ? 0 : 2;
}

}  // namespace
}  // namespace texelscope

int main(int count, char** words) {
    if (count < 3) texelscope::stop("expected FILE.tri ROUNDS [OUT.png]");
    return texelscope::run(words[1], std::max(1, std::atoi(words[2])), count > 3 ? words[3] : nullptr);
}

#include "tests/bench/llvmpipe.hpp"

#include "framework/math/error.hpp"
#include "tests/bench/llvmpipe_shaders.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <cstdlib>
#include <span>
#include <vector>

namespace glint {
namespace {

void require(bool ok, const std::string& what) {
    if (!ok) {
        throw Error("llvmpipe: " + what);
    }
}

std::string text_of(GLenum name) {
    return reinterpret_cast<const char*>(glGetString(name));
}

GLuint compile(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* start = text.c_str();
    glShaderSource(shader, 1, &start, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    char log[1024] = {};
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    require(ok == GL_TRUE, std::string("GLSL: ") + log);
    return shader;
}

GLuint link(int lights) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex_glsl));
    glAttachShader(program,
                   compile(GL_FRAGMENT_SHADER, "#version 300 es\n#define LIGHTS " +
                                                   std::to_string(lights) + fragment_glsl));
    glLinkProgram(program);
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    require(ok == GL_TRUE, "the program does not link");
    return program;
}

template <class Element>
GLuint upload(GLenum target, std::span<const Element> data) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(Element)), data.data(),
                 GL_STATIC_DRAW);
    return buffer;
}

// A picture to draw into, with its depth.
struct Canvas {
    GLuint frame = 0, colour = 0, depth = 0;

    Canvas(GLenum format, int width, int height) {
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glGenRenderbuffers(1, &colour);
        glBindRenderbuffer(GL_RENDERBUFFER, colour);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
        glGenRenderbuffers(1, &depth);
        glBindRenderbuffer(GL_RENDERBUFFER, depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
        require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                "cannot draw into such a picture");
    }
    ~Canvas() {
        glDeleteFramebuffers(1, &frame);
        glDeleteRenderbuffers(1, &colour);
        glDeleteRenderbuffers(1, &depth);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
};

}  // namespace

struct Llvmpipe::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    GLuint program = 0, vertices = 0, array = 0;
    std::vector<GLuint> buffers;
    std::unique_ptr<Canvas> canvas;
    GLsizei indices = 0;
    int width = 0, height = 0;
    Rgb<float> background{0.0F};

    void make_context();
    void set_uniforms(const Scene& scene) const;
    void free_scene();
    void draw() const;

    GLint at(const char* name) const { return glGetUniformLocation(program, name); }
    void set(const char* name, const glm::vec3& v) const {
        glUniform3fv(at(name), 1, glm::value_ptr(v));
    }
};

void Llvmpipe::Impl::make_context() {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    require(display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE,
            "there is no EGL display without a surface; on Debian, as root, run\n"
            "  apt-get install libgl1-mesa-dri");
    require(eglBindAPI(EGL_OPENGL_ES_API) == EGL_TRUE, "EGL has no OpenGL ES");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_ES3_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    require(context != EGL_NO_CONTEXT &&
                eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE,
            "EGL makes no OpenGL ES 3 context");
    require(text_of(GL_RENDERER).find("llvmpipe") != std::string::npos,
            "OpenGL draws with " + text_of(GL_RENDERER) + " instead");
}

void Llvmpipe::Impl::set_uniforms(const Scene& scene) const {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::mat4 matrix = clip_from_world(scene.camera, aspect);
    glUseProgram(program);
    glUniformMatrix4fv(at("clip_from_world"), 1, GL_FALSE, glm::value_ptr(matrix));
    set("eye", scene.camera.eye);
    set("ambient", scene.lighting.ambient);
    set("Cd", scene.materials[0].diffuse);
    set("F0", scene.materials[0].specular);
    glUniform1f(at("n"), scene.materials[0].exponent);
    std::vector<glm::vec3> directions;
    std::vector<glm::vec3> irradiances;
    for (const DirectionalLight& light : scene.lighting.directional) {
        directions.push_back(light.direction);
        irradiances.push_back(light.irradiance);
    }
    const auto count = static_cast<GLsizei>(directions.size());
    glUniform3fv(at("light_direction"), count, glm::value_ptr(directions[0]));
    glUniform3fv(at("light_irradiance"), count, glm::value_ptr(irradiances[0]));
}

void Llvmpipe::Impl::free_scene() {
    if (program == 0) {
        return;
    }
    canvas.reset();
    glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    buffers.clear();
    glDeleteVertexArrays(1, &array);
    glDeleteProgram(program);
    program = 0;
}

void Llvmpipe::Impl::draw() const {
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    glClearColor(background.r, background.g, background.b, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

Llvmpipe::Llvmpipe(int threads) : impl_(std::make_unique<Impl>()) {
    setenv("LP_NATIVE_VECTOR_WIDTH", "256", 1);
    setenv("LP_NUM_THREADS", threads == 1 ? "0" : std::to_string(threads).c_str(), 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    impl_->make_context();
}

Llvmpipe::~Llvmpipe() {
    impl_->free_scene();
    eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(impl_->display, impl_->context);
    eglTerminate(impl_->display);
}

std::string Llvmpipe::version() const {
    return text_of(GL_VERSION) + ", " + text_of(GL_RENDERER);
}

void Llvmpipe::set_scene(const BenchScene& bench) {
    const Scene& scene = bench.scene;
    impl_->free_scene();
    impl_->width = bench.width;
    impl_->height = bench.height;
    impl_->background = scene.background;
    impl_->program = link(static_cast<int>(scene.lighting.directional.size()));
    impl_->set_uniforms(scene);
    glGenVertexArrays(1, &impl_->array);
    glBindVertexArray(impl_->array);
    for (GLuint slot = 0; slot < 2; ++slot) {
        const auto& attribute = slot == 0 ? scene.mesh.positions : scene.mesh.normals;
        impl_->buffers.push_back(upload<glm::vec3>(GL_ARRAY_BUFFER, attribute));
        glEnableVertexAttribArray(slot);
        glVertexAttribPointer(slot, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    impl_->buffers.push_back(upload<glm::uvec3>(GL_ELEMENT_ARRAY_BUFFER, scene.mesh.triangles));
    impl_->indices = static_cast<GLsizei>(3 * scene.mesh.triangles.size());
    impl_->canvas = std::make_unique<Canvas>(GL_SRGB8_ALPHA8, bench.width, bench.height);
    require(glGetError() == GL_NO_ERROR, "OpenGL reports an error in the set-up");
}

void Llvmpipe::frame() {
    impl_->draw();
}

SrgbImage Llvmpipe::picture() const {
    SrgbImage bottom_up(impl_->width, impl_->height);
    SrgbImage image(impl_->width, impl_->height);
    glReadPixels(0, 0, impl_->width, impl_->height, GL_RGBA, GL_UNSIGNED_BYTE, &bottom_up(0, 0));
    for (int y = 0; y < impl_->height; ++y) {
        for (int x = 0; x < impl_->width; ++x) {
            image(x, y) = bottom_up(x, impl_->height - 1 - y);
        }
    }
    return image;
}

LinearImage Llvmpipe::linear_picture() {
    LinearImage image(impl_->width, impl_->height);
    std::vector<glm::vec4> bottom_up(image.pixels().size());
    {
        const Canvas canvas(GL_RGBA32F, impl_->width, impl_->height);
        impl_->draw();
        glReadPixels(0, 0, impl_->width, impl_->height, GL_RGBA, GL_FLOAT, bottom_up.data());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, impl_->canvas->frame);
    for (int y = 0; y < impl_->height; ++y) {
        for (int x = 0; x < impl_->width; ++x) {
            image(x, y) =
                bottom_up[static_cast<std::size_t>((impl_->height - 1 - y) * impl_->width + x)];
        }
    }
    return image;
}

}  // namespace glint

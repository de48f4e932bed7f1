// The same shader's text as double, as float and in lanes; and what covers a pixel, by both
// rasterizers, of vertices that are snapped to fractions of a pixel.
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/raster/plug.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/net.hpp"
#include "docs/charts/picture.hpp"

#include <numbers>

namespace glint::charts {
namespace {

// ---- number type --------------------------------------------------------------------------------

constexpr int fragments = 2048;
constexpr int stride = fragments + 80;  // columns begin at different places of the cache

Lit<EnginePhong> final_model() {
    Lit<EnginePhong> s{{Rgb<float>(0.5F, 0.3F, 0.2F), Rgb<float>(0.04F), 51.2F}, {}, {0, 0, 4}};
    s.lighting.directional = {{normalize(glm::vec3(-0.5F, 0.6F, 0.8F)), Rgb<float>(3.0F)},
                              {normalize(glm::vec3(0.8F, 0.3F, 0.3F)), Rgb<float>(0.5F)}};
    s.lighting.ambient = Rgb<float>(0.05F);
    return s;
}

// A unit sphere seen from its front: position and normal, by column.
template <class T>
std::vector<T> sphere_fragments() {
    std::vector<T> in(6 * stride);
    for (std::size_t i = 0; i < fragments; ++i) {
        const double radius = std::sqrt((static_cast<double>(i) + 0.5) / fragments);
        const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
        const double at[] = {radius * std::cos(angle), radius * std::sin(angle),
                             std::sqrt(1 - radius * radius)};
        for (std::size_t k = 0; k < 6; ++k) {  // rounded once, so that all types see the same
            in[k * stride + i] = static_cast<T>(static_cast<float>(at[k % 3]));
        }
    }
    return in;
}

template <class T>
Contender shade(const std::string& method, Shader::ShadeCall<T> call,
                const std::vector<double>& exact, std::vector<T>& colours) {
    static const Lit<EnginePhong> model = final_model();
    const auto in = std::make_shared<const std::vector<T>>(sphere_fragments<T>());
    const auto out = std::make_shared<std::vector<T>>(3 * stride);
    const auto work = [=] { call(&model, in->data(), stride, fragments, out->data()); };
    work();
    colours = *out;
    ErrorSum sum;
    for (std::size_t i = 0; i < fragments; ++i) {
        for (std::size_t k = 0; k < 3 && !exact.empty(); ++k) {
            sum.add(code_of(double{(*out)[k * stride + i]}) - code_of(exact[k * stride + i]));
        }
    }
    return {method, work, fragments, {{"a shader", "codes", sum.errors()}}};
}

void add_number_types(std::vector<Contender>& all) {
    const Shader shader = plug(final_model());
    std::vector<double> exact;
    std::vector<float> ignored;
    all.push_back(shade<double>("double", shader.reference, {}, exact));
    all.push_back(shade("float", shader.shade_1, exact, ignored));
    all.push_back(shade("4 lanes", shader.shade_4, exact, ignored));
    if (shader.shade_8 != nullptr) {
        all.push_back(shade("8 lanes", shader.shade_8, exact, ignored));
    }
    if (shader.shade_16 != nullptr) {
        all.push_back(shade("16 lanes", shader.shade_16, exact, ignored));
    }
}

// ---- coverage -----------------------------------------------------------------------------------

struct Grey {
    template <class T>
    struct Varyings {
        T nothing;
    };
    static Varyings<float> vertex(const Vertex&) { return {0}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return Rgb<T>(in.nothing + T(0.2F));
    }
};

// The net snapped to 2^-bits pixels, as a scene whose units are pixels.
Stage stage_of_net(const Net& net, int bits) {
    const double unit = std::exp2(-bits);
    Scene s;
    for (const glm::dvec2& p : net.knots) {
        s.mesh.positions.emplace_back(glm::round(p / unit) * unit, 0.5);
    }
    s.mesh.triangles.assign(net.triangles.begin(), net.triangles.end());
    Stage stage = stage_of(std::move(s), net_window, net_window,
                           [](const Scene&, const Material&) { return Grey(); });
    glm::mat4 clip_from_pixels(1.0F);
    clip_from_pixels[0][0] = 2.0F / net_window;
    clip_from_pixels[1][1] = -2.0F / net_window;
    clip_from_pixels[3] = {-1, 1, 0, 1};
    stage.view.clip_from_world = clip_from_pixels;
    return stage;
}

void add_coverage(std::vector<Contender>& all, double pixels, const char* name) {
    const Net net = net_of(pixels);
    const Image<std::int32_t> exact = exact_owners(net);
    for (const Rasterizer rasterizer : {Rasterizer::scanline, Rasterizer::tiles}) {
        for (const int bits : {0, 4, 8}) {
            const auto stage = std::make_shared<const Stage>(stage_of_net(net, bits));
            const Settings settings{.rasterizer = rasterizer};
            Image<std::int32_t> found;
            Renderer(settings).render(stage->scene.mesh, stage->view, stage->shading.shaders,
                                      {.triangle = &found});
            int wrong = 0;
            for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
                wrong += found.pixels()[i] != exact.pixels()[i] ? 1 : 0;
            }
            const double share = static_cast<double>(wrong) / (net_window * net_window);
            const std::string method = (rasterizer == Rasterizer::tiles ? "tiles " : "scanline ") +
                                       std::to_string(bits) + " bits";
            all.push_back(frame_contender(method, stage, settings,
                                          {{name, "share of pixels", {share, share}}}));
        }
    }
}

}  // namespace

std::vector<Contender> number_type_contenders() {
    std::vector<Contender> all;
    add_number_types(all);
    add_coverage(all, 0.7, "triangles of 0.7 pixels");
    add_coverage(all, 8, "triangles of 8 pixels");
    return all;
}

}  // namespace glint::charts

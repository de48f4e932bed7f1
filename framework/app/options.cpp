#include "framework/app/options.hpp"

#include "framework/app/values.hpp"
#include "framework/math/error.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace glint {
namespace {

using Text = const std::string&;

std::string short_number(float value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

// An option of one word that goes through read; of several, the last counts.
template <class Read>
void option(CLI::App& app, const char* flag, const char* type, const std::string& meaning,
            Read&& read) {
    app.add_option_function<std::string>(flag, std::forward<Read>(read), meaning)
        ->type_name(type)
        ->take_last();
}

template <class Read>
void repeatable(CLI::App& app, const char* flag, const char* type, const std::string& meaning,
                Read&& read) {
    app.add_option_function<std::vector<std::string>>(
           flag,
           [read](const std::vector<std::string>& all) {
               for (const std::string& each : all) {
                   read(each);
               }
           },
           meaning)
        ->type_name(type)
        ->allow_extra_args(false);
}

void add_scene(CLI::App& app, Options& o) {
    option(app, "--scene", "FILE.obj", "draw this mesh instead of the lesson's stage",
           [&](Text t) { o.scene_file = t; });
    option(app, "--kd", "R,G,B", "diffuse colour of all materials",
           [&](Text t) { o.kd = reflectance("--kd", t); });
    option(app, "--ks", "R,G,B", "specular colour of all materials",
           [&](Text t) { o.ks = reflectance("--ks", t); });
    option(app, "--ns", "N", "Phong exponent of all materials", [&](Text t) {
        o.ns = number_within("--ns", t, 0, 1e9F, "needs an exponent within 0..1e9");
    });
    repeatable(app, "--set", "NAME=VALUE", "move a parameter of the lesson", [&](Text t) {
        const auto parts = split(t, '=');
        const auto value = parts.size() == 2 ? finite_number(parts[1]) : std::nullopt;
        if (!value) {
            refuse("--set", t, "needs NAME=NUMBER");
        }
        o.parameters.set(parts[0], *value);
        o.set.push_back(parts[0]);
    });
}

void add_camera(CLI::App& app, Options& o) {
    option(app, "--size", "WxH", "picture size (960x540)",
           [&](Text t) { std::tie(o.width, o.height) = picture_size(t); });
    option(app, "--eye", "X,Y,Z", "where the eye is", [&](Text t) { o.eye = triple("--eye", t); });
    option(app, "--target", "X,Y,Z", "what it looks at",
           [&](Text t) { o.target = triple("--target", t); });
    option(app, "--up", "X,Y,Z", "what is up (0,1,0)", [&](Text t) { o.up = triple("--up", t); });
    option(app, "--fov", "DEG", "vertical field of view, degrees", [&](Text t) {
        o.fov = number_within("--fov", t, 1e-3F, 179.9F, "needs degrees within 0.001..179.9");
    });
    const std::string distance = "needs a distance above 0, near below far";
    option(app, "--near", "N", "distance of the near plane", [&o, distance](Text t) {
        o.near = number_within("--near", t, 1e-30F, 1e30F, distance);
    });
    option(app, "--far", "N", "distance of the far plane",
           [&o, distance](Text t) { o.far = number_within("--far", t, 1e-30F, 1e30F, distance); });
}

void add_lights(CLI::App& app, Options& o) {
    repeatable(app, "--light", "X,Y,Z:R,G,B",
               "directional light: towards it, irradiance; repeatable", [&](Text t) {
                   const auto [direction, irradiance] = light_at("--light", t);
                   const glm::vec3 unit = normalize_or(direction, glm::vec3(0));
                   if (unit == glm::vec3(0)) {
                       refuse("--light", t, "needs a direction that is not 0,0,0");
                   }
                   o.lights.push_back({unit, irradiance});
               });
    repeatable(app, "--point-light", "X,Y,Z:R,G,B", "point light: place, intensity; repeatable",
               [&](Text t) {
                   const auto [position, intensity] = light_at("--point-light", t);
                   o.point_lights.push_back({position, intensity});
               });
    option(app, "--ambient", "R,G,B", "radiance from all directions",
           [&](Text t) { o.ambient = light_amount("--ambient", t); });
}

void add_rasterizer(CLI::App& app, Options& o) {
    option(app, "--cull", "none|back", "leave out faces that look away (none)", [&](Text t) {
        o.settings.cull = choice<Cull>("--cull", t, {{"none", Cull::none}, {"back", Cull::back}});
    });
    option(app, "--raster", "tiles|scanline|reference",
           "rasterizer (tiles); reference is scanline in double", [&](Text t) {
               o.settings.rasterizer = choice<Rasterizer>("--raster", t,
                                                          {{"tiles", Rasterizer::tiles},
                                                           {"scanline", Rasterizer::scanline},
                                                           {"reference", Rasterizer::reference}});
           });
    option(app, "--lanes", "auto|1|4|8|16", "SIMD lanes (auto)",
           [&](Text t) { o.settings.lanes = lane_count(t); });
    option(app, "--threads", "auto|N", "threads (auto)",
           [&](Text t) { o.settings.threads = thread_count(t); });
    option(app, "--samples", "1|2|4|8|16", "samples a pixel (4)", [&](Text t) {
        o.settings.samples =
            choice<int>("--samples", t, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}});
    });
    option(app, "--tolerance", "E",
           "draw the cheapest way whose colours are within E sRGB codes of exact; 0: the full "
           "model (0)",
           [&](Text t) {
               o.tolerance = number_within("--tolerance", t, 0, 255, "needs codes within 0..255");
           });
    app.add_flag("--sample-shading", o.settings.sample_shading,
                 "shade every sample, not once a pixel and triangle");
}

void add_output(CLI::App& app, Options& o, const std::string& name) {
    repeatable(app, "--out", "FILE.png|FILE.pfm", "picture file; repeatable (out/" + name + ".png)",
               [&](Text t) {
                   if (!t.ends_with(".png") && !t.ends_with(".pfm")) {
                       refuse("--out", t, "needs a name that ends in .png or .pfm");
                   }
                   o.outs.push_back(t);
               });
    option(app, "--view", "MODE",
           "what to show: shaded, normal, depth, triangle, overdraw or tiles (shaded)",
           [&](Text t) {
               o.view = choice<ViewMode>("--view", t,
                                         {{"shaded", ViewMode::shaded},
                                          {"normal", ViewMode::normal},
                                          {"depth", ViewMode::depth},
                                          {"triangle", ViewMode::triangle},
                                          {"overdraw", ViewMode::overdraw},
                                          {"tiles", ViewMode::tiles}});
           });
    option(app, "--frames", "N", "draw so often, for --stats (1); with --window, close it then",
           [&](Text t) { o.frames = count_up_to("--frames", t, 1000000); });
    option(app, "--stats", "FILE|-", "times and counts as JSON; - for standard output",
           [&](Text t) { o.stats = t; });
    option(app, "--probe", "X,Y", "explain this pixel, in float and in double", [&](Text t) {
        const auto parts = split(t, ',');
        const auto x = parts.size() == 2 ? whole_number(parts[0]) : std::nullopt;
        const auto y = parts.size() == 2 ? whole_number(parts[1]) : std::nullopt;
        if (!x || !y) {
            refuse("--probe", t, "needs a pixel, X,Y");
        }
        o.probe = {*x, *y};
    });
    option(app, "--compare", "FILE.png", "measure the difference from this picture",
           [&](Text t) { o.compare = t; });
    app.add_flag("--window", o.window,
                 "open a live window; its key F1 says what keys and mouse do");
}

void add_files(CLI::App& app, Options& o, const std::vector<FileOption>& files) {
    for (const FileOption& f : files) {
        option(app, f.flag.c_str(), f.type.c_str(), f.meaning, [&](Text t) {
            const std::string ending = f.type.substr(f.type.find('.'));
            if (f.writes && !t.ends_with(ending)) {
                refuse(f.flag, t, "needs a name that ends in " + ending);
            }
            o.files[f.flag] = t;
        });
    }
}

std::string footer(const Parameters& parameters) {
    std::string text;
    for (const Parameter& p : parameters.all()) {
        text += "  " + p.name + "  " + p.meaning + ", " + short_number(p.low) + ".." +
                short_number(p.high) + " (" + short_number(p.value) + ")\n";
    }
    return (text.empty() ? "" : "Parameters for --set:\n" + text + "\n") +
           "Examples:\n"
           "  --size 1920x1080 --samples 8 --out big.png\n"
           "  --scene bunny.obj --kd 0.7,0.3,0.2 --ns 80\n"
           "  --view triangle --raster scanline\n"
           "  --probe 480,270\n"
           "  --tolerance 1 --stats -\n"
           "  --window";
}

void check_together(const Options& o) {
    if (o.near && o.far && *o.near >= *o.far) {
        refuse("--near", short_number(*o.near), "must be below --far " + short_number(*o.far));
    }
    if (o.probe && (o.probe->first < 0 || o.probe->second < 0 || o.probe->first >= o.width ||
                    o.probe->second >= o.height)) {
        refuse("--probe", std::to_string(o.probe->first) + "," + std::to_string(o.probe->second),
               "lies outside 0,0.." + std::to_string(o.width - 1) + "," +
                   std::to_string(o.height - 1));
    }
}

}  // namespace

float Parameters::operator[](std::string_view name) const {
    for (const Parameter& p : all_) {
        if (p.name == name) {
            return p.value;
        }
    }
    throw Error("there is no parameter " + std::string(name));
}

void Parameters::set(std::string_view name, float value) {
    std::string known;
    for (Parameter& p : all_) {
        if (p.name == name) {
            if (!(value >= p.low && value <= p.high)) {
                refuse("--set", p.name + "=" + short_number(value),
                       "lies within " + short_number(p.low) + ".." + short_number(p.high));
            }
            if (p.whole && value != std::round(value)) {
                refuse("--set", p.name + "=" + short_number(value), "takes whole numbers");
            }
            p.value = value;
            return;
        }
        known += " " + p.name;
    }
    refuse("--set", std::string(name),
           known.empty() ? "this lesson has no parameters" : "is not one of" + known);
}

Options parse_options(int argc, const char* const* argv, const std::string& name,
                      const std::string& title, const Parameters& parameters,
                      const std::vector<FileOption>& files) {
    Options o;
    o.parameters = parameters;
    o.settings.samples = 4;
    o.settings.threads = thread_count("auto");
    CLI::App app{title, name};
    app.footer(footer(parameters));
    add_scene(app, o);
    add_camera(app, o);
    add_lights(app, o);
    add_rasterizer(app, o);
    add_output(app, o, name);
    add_files(app, o, files);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ParseError& e) {
        throw Error(std::string(e.what()) + " (see " + name + " --help)");
    }
    check_together(o);
    return o;
}

}  // namespace glint

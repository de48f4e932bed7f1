// property_run: random worlds until the time is up or a fault is found.
#include "tests/stability/property_check.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <exception>
#include <iostream>
#include <optional>

namespace {

using namespace glint::stability;
using Clock = std::chrono::steady_clock;

struct Found {
    World world;
    std::string fault;
};

// The smallest faulty world from seed on; worlds 0: as many as there is time for.
std::optional<Found> search(std::uint64_t seed, double seconds, std::uint64_t worlds) {
    std::optional<Found> smallest;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    std::uint64_t done = 0;
    int faulty = 0;
    for (; worlds == 0 ? Clock::now() < end : done < worlds; ++done) {
        const World world = random_world(seed + done);
        std::string fault = picture_fault(world);
        if (fault.empty()) {
            fault = material_fault(world);
        }
        if (fault.empty()) {
            fault = fresnel_fault(world.seed);
        }
        if (fault.empty()) {
            continue;
        }
        ++faulty;
        if (!smallest || size_of(world) < size_of(smallest->world)) {
            std::cout << "seed " << world.seed << ": " << fault << '\n' << std::flush;
            smallest = Found{world, fault};
        }
    }
    std::cout << done << " worlds, " << faulty << " faulty\n";
    return smallest;
}

// Whether a fault was found.
bool run(int argc, char** argv) {
    CLI::App app{
        "Draws random scenes in every way that there is and looks for radiance that is no number,\n"
        "negative or more than the light and the material allow, and for pixels that depend on "
        "the\n"
        "rasterizer, the lanes or the threads. Exit status 1 where something is wrong.",
        "property_run"};
    double seconds = 10;
    std::uint64_t worlds = 0;
    auto seed =
        static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
    app.add_option("--seconds", seconds, "how long to look (10)")->check(CLI::Range(0.0, 1e6));
    app.add_option("--seed", seed, "of the first world (the time); the next has the next one");
    app.add_option("--worlds", worlds, "look at so many worlds, however long it takes");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return false;
    }
    std::cout << "property_run --seed " << seed << '\n' << std::flush;
    const auto found = search(seed, seconds, worlds);
    if (found) {
        std::cout << "smallest: " << words(found->world) << ": " << found->fault
                  << "\nreplay:   property_run --seed " << found->world.seed << " --worlds 1\n";
    }
    return found.has_value();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv) ? 1 : 0;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}

// grids: the lesson's meshes in the form that the program coverage reads.
#include "lessons/18_scanline_to_tiles/grids.hpp"

#include <cstdio>

int main() {
    using namespace glint;
    for (const grids::Grid& grid : grids::all()) {
        for (const auto& [a, b, c] : grid.triangles) {
            std::printf("T %s %d %d %.9g %.9g %.9g %.9g %.9g %.9g\n", grid.name.c_str(),
                        grids::width, grids::height, a.x, a.y, b.x, b.y, c.x, c.y);
        }
    }
    return std::fflush(stdout) == 0 ? 0 : 2;
}

// How the live window moves the camera.
#pragma once

#include "framework/app/options.hpp"
#include "framework/app/window_keys.hpp"
#include "framework/scene/camera.hpp"

namespace glint {

// The eye goes round the target by angles in radians, to its right and up; it stops just short of
// where up lies along the view.
Camera orbit(Camera camera, float right, float up);

// Eye and target move so that what is at the target goes right and down by x, y pixels of a picture
// so many pixels high.
Camera pan(Camera camera, float x, float y, int height);

// The distance to the target times factor, but within 1/1000..1000 of the usual distance.
Camera zoom(Camera camera, float factor, float usual);

// Near and far as the options say, else about the mesh with room for a close look; unchanged where
// the mesh has no extent.
Camera with_depth_range(Camera camera, const Mesh& mesh, const Options& options);

// The camera after a key; unchanged by actions that do not move it.
Camera steered(const Camera& camera, Action action, float usual, int height);

}  // namespace glint

// scene_registers: the parts of make_scene that turn the user's units into registers.
#pragma once
#include "tb/host/scene.hpp"

namespace relievo::tb {

// regs.displace from scale and bias.
void set_displacement(scene& sc);

// normal_map from the map's steepest differences and the texel size, which is measured on the mesh where it isn't given.
void set_normal_map(scene& sc, map_extremes const& extremes);

// The tests' registers: fills defaults into sc.options. Needs sc.triangles, sc.camera.
void set_tests(scene& sc, map_extremes const& extremes);

}  // namespace relievo::tb

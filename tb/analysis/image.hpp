// image: a picture of a displaced mesh, shaded by its interpolated normals N', or with its edges drawn over the shading.
//
//   Rays through Embree, 2 x 2 (supersampling) per pixel, with the same camera conventions as the engine's transform: eye, at,
//   up, vertical field of view, pixel (i, j) covering [i, i+1) x [j, j+1), y down. A key light from the viewer's upper left with
//   shadows, a sky and ground term, some ambient occlusion from fixed directions. Everything ends as one brightness through a ramp of
//   256 colours, so the files stay small. The same mesh and camera give the same bytes.
//
//   Wireframe: an edge is drawn where a sample lies within half a line's width of it on the screen; lines fade where triangles
//   become as small as they are wide.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "tb/analysis/png_file.hpp"
#include "tb/analysis/surface.hpp"
#include "tb/host/camera.hpp"

namespace relievo::tb {

struct image_options {
  bool wireframe = false;
  bool shadows = true;
  int supersampling = 2;
  int occlusion_rays = 12;  // per sample; 0: none
  double line_width = 1.0;  // pixels
};

// `triangles` and `view` in the same units.
picture render(surface const& triangles, camera_view const& view, image_options const& options = {});

// render, encoded and written (temporary file, renamed).
void write_image(std::string const& path, surface const& triangles, camera_view const& view, image_options const& options = {});

}  // namespace relievo::tb

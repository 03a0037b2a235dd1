// embree: owners for Embree's handles, and a scene of triangles made the same way everywhere.
//
//   The instruction set is pinned and one thread is used, so that a picture has the same bytes on every x86-64 machine.
#pragma once
#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>

#include "tb/analysis/surface.hpp"

namespace relievo::tb {

struct embree_release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using embree_device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, embree_release>;
using embree_scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, embree_release>;

embree_device make_embree_device();

// Vertex k of triangle i is vertex 3 i + k. A point query function may be null. Throws std::runtime_error when Embree fails.
embree_scene make_embree_scene(RTCDevice device, surface const& triangles, RTCPointQueryFunction query = nullptr);

}  // namespace relievo::tb

#include "tb/analysis/embree.hpp"

#include <stdexcept>

namespace relievo::tb {
namespace {

void require_no_error(RTCDevice device) {
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree could not build its scene (out of memory?)");
}

}  // namespace

embree_device make_embree_device() {
  embree_device device(rtcNewDevice("threads=1,isa=sse4.2"));
  if (!device) throw std::runtime_error("Embree gave no device: a processor with SSE4.2 is needed");
  return device;
}

embree_scene make_embree_scene(RTCDevice device, surface const& triangles, RTCPointQueryFunction query) {
  embree_scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
  const std::size_t count = triangles.size();
  auto* positions =
      static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices =
      static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  if (count > 0 && (positions == nullptr || indices == nullptr)) {
    rtcReleaseGeometry(geometry);
    throw std::runtime_error("Embree found no memory for " + std::to_string(count) + " triangles");
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      glm::dvec3 const& p = triangles[i].v[k].p;
      float* out = positions + 9 * i + 3 * k;
      out[0] = static_cast<float>(p.x);
      out[1] = static_cast<float>(p.y);
      out[2] = static_cast<float>(p.z);
      indices[3 * i + k] = static_cast<unsigned>(3 * i + k);
    }
  }
  if (query != nullptr) rtcSetGeometryPointQueryFunction(geometry, query);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  require_no_error(device);
  return scene;
}

}  // namespace relievo::tb

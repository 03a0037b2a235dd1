#include "tb/analysis/image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tb/analysis/embree.hpp"
#include "tb/analysis/progress.hpp"
#include "tb/analysis/shading.hpp"
#include "tb/host/files.hpp"

namespace relievo::tb {
namespace {

// The eye's axes and the projection to pixels.
class viewer {
 public:
  explicit viewer(camera_view const& view)
      : eye_(view.eye),
        forward_(glm::normalize(view.at - view.eye)),
        right_(glm::normalize(glm::cross(forward_, view.up))),
        up_(glm::cross(right_, forward_)),
        focal_(0.5 * view.height / std::tan(0.5 * glm::radians(view.fov_degrees))),
        centre_(0.5 * view.width, 0.5 * view.height) {}

  glm::dvec3 const& eye() const { return eye_; }
  glm::dvec3 const& right() const { return right_; }
  glm::dvec3 const& up() const { return up_; }
  glm::dvec3 const& forward() const { return forward_; }

  glm::dvec3 ray(glm::dvec2 const& pixel) const {
    return glm::normalize(forward_ * focal_ + right_ * (pixel.x - centre_.x) - up_ * (pixel.y - centre_.y));
  }
  // Meaningless behind the eye: false.
  bool project(glm::dvec3 const& p, glm::dvec2& pixel) const {
    const glm::dvec3 d = p - eye_;
    const double w = glm::dot(d, forward_);
    if (w <= 1e-9) return false;
    pixel = centre_ + glm::dvec2(glm::dot(d, right_), -glm::dot(d, up_)) * (focal_ / w);
    return true;
  }

 private:
  glm::dvec3 eye_, forward_, right_, up_;
  double focal_;
  glm::dvec2 centre_;
};

double distance_to_segment(glm::dvec2 const& p, glm::dvec2 const& a, glm::dvec2 const& b) {
  const glm::dvec2 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length > 0.0 ? std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * ab);
}

class renderer {
 public:
  renderer(surface const& triangles, camera_view const& view, image_options const& options)
      : triangles_(triangles),
        options_(options),
        viewer_(view),
        device_(make_embree_device()),
        scene_(make_embree_scene(device_.get(), triangles)),
        sky_(shading::hemisphere(options.occlusion_rays)) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(-std::numeric_limits<double>::max());
    for (auto const& t : triangles) {
      for (auto const& v : t.v) {
        low = glm::min(low, v.p);
        high = glm::max(high, v.p);
      }
    }
    extent_ = triangles.empty() ? 1.0 : glm::length(high - low);
    const double reach = glm::length(view.eye) + extent_;
    lift_ = std::max(1e-4 * extent_, 1e-6 * reach);
    // From above, the viewer's left and his side of the scene: relief reads the same from anywhere, from straight above too.
    const glm::dvec3 up = glm::normalize(view.up);
    to_light_ = glm::normalize(0.65 * up - 0.85 * viewer_.right() - 0.45 * viewer_.forward());
    up_ = up;
  }

  double sample(glm::dvec2 const& pixel) const {
    const glm::dvec3 direction = viewer_.ray(pixel);
    RTCRayHit hit{};
    fill(hit.ray, viewer_.eye(), direction, std::numeric_limits<float>::infinity());
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return shading::background;
    auto const& v = triangles_[hit.hit.primID].v;
    const double b1 = static_cast<double>(hit.hit.u);
    const double b2 = static_cast<double>(hit.hit.v);
    const double b0 = 1.0 - b1 - b2;
    const glm::dvec3 p = b0 * v[0].p + b1 * v[1].p + b2 * v[2].p;
    const double value = shade(p, face_viewer(facet(v), direction), face_viewer(b0 * v[0].n + b1 * v[1].n + b2 * v[2].n, direction));
    return options_.wireframe ? with_lines(value, v, pixel) : value;
  }

 private:
  static void fill(RTCRay& ray, glm::dvec3 const& from, glm::dvec3 const& direction, float far) {
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = 0.0f;
    ray.tfar = far;
    ray.mask = 0xffffffffu;
  }

  bool occluded(glm::dvec3 const& from, glm::dvec3 const& direction, double far) const {
    RTCRay ray{};
    fill(ray, from, direction, static_cast<float>(far));
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_.get(), &context, &ray);
    return ray.tfar < 0.0f;
  }

  static glm::dvec3 facet(std::array<surface_vertex, 3> const& v) { return glm::cross(v[1].p - v[0].p, v[2].p - v[0].p); }

  static glm::dvec3 face_viewer(glm::dvec3 n, glm::dvec3 const& direction) {
    const double length = glm::length(n);
    if (length == 0.0) return -direction;
    n /= length;
    return glm::dot(n, direction) > 0.0 ? -n : n;
  }

  double shade(glm::dvec3 const& p, glm::dvec3 const& flat, glm::dvec3 const& smooth) const {
    const glm::dvec3 n = glm::dot(flat, smooth) > 0.0 ? smooth : -smooth;
    const glm::dvec3 from = p + lift_ * flat;
    double lit = 1.0;
    if (options_.shadows && glm::dot(n, to_light_) > 0.0) {
      lit = glm::dot(flat, to_light_) > 0.0 && occluded(from, to_light_, 2.0 * extent_) ? 0.25 : 1.0;
    }
    double open = 1.0;
    if (!sky_.empty()) {
      const glm::dvec3 side = glm::normalize(std::abs(n.x) < 0.8 ? glm::cross(n, glm::dvec3(1, 0, 0)) : glm::cross(n, glm::dvec3(0, 1, 0)));
      const glm::dvec3 other = glm::cross(n, side);
      int seen = 0;
      for (auto const& d : sky_) seen += occluded(from, d.x * side + d.y * other + d.z * n, 0.15 * extent_) ? 0 : 1;
      open = static_cast<double>(seen) / static_cast<double>(sky_.size());
    }
    return shading::brightness(n, to_light_, up_, open, lit);
  }

  double with_lines(double value, std::array<surface_vertex, 3> const& v, glm::dvec2 const& pixel) const {
    std::array<glm::dvec2, 3> s;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!viewer_.project(v[k].p, s[k])) return value;
    }
    const double half = 0.5 * options_.line_width;
    double nearest = std::numeric_limits<double>::max();
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      nearest = std::min(nearest, distance_to_segment(pixel, s[k], s[(k + 1) % 3]));
      longest = std::max(longest, glm::length(s[(k + 1) % 3] - s[k]));
    }
    if (nearest > half) return value;
    const glm::dvec2 a = s[1] - s[0];
    const glm::dvec2 b = s[2] - s[0];
    const double thickness = longest > 0.0 ? std::abs(a.x * b.y - a.y * b.x) / longest : 0.0;
    const double strength = std::clamp(thickness / (4.0 * options_.line_width), 0.15, 0.85);
    return value + strength * (shading::line - value);
  }

  surface const& triangles_;
  image_options options_;
  viewer viewer_;
  embree_device device_;
  embree_scene scene_;
  std::vector<glm::dvec3> sky_;
  glm::dvec3 to_light_{0.0}, up_{0.0};
  double extent_ = 1.0;
  double lift_ = 0.0;
};

}  // namespace

picture render(surface const& triangles, camera_view const& view, image_options const& options) {
  picture image;
  image.width = view.width;
  image.height = view.height;
  image.pixels.reserve(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  const renderer scene(triangles, view, options);
  const int side = std::max(1, options.supersampling);
  progress bar("picture", static_cast<std::uint64_t>(view.height));
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      double sum = 0.0;
      for (int b = 0; b < side; ++b) {
        for (int a = 0; a < side; ++a) sum += scene.sample({i + (a + 0.5) / side, j + (b + 0.5) / side});
      }
      image.pixels.push_back(shading::ramp(sum / (side * side)));
    }
    bar.advance();
  }
  return image;
}

void write_image(std::string const& path, surface const& triangles, camera_view const& view, image_options const& options) {
  write_bytes(path, encode_png(render(triangles, view, options)));
}

}  // namespace relievo::tb

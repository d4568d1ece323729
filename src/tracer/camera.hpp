#pragma once
// From places on the screen to rays.

#include "scene/scene.hpp"

namespace lancer::tracer {

struct CameraRay {
  Vec3 origin;
  Vec3 direction;  // unit length
};

class Camera {
 public:
  /// The view, drawn with columns x rows pixels, in a space that starts at `origin`.
  Camera(const scene::View& view, int columns, int rows, Vec3 origin = {});

  /// Through the point x columns from the left and y rows from the top; (i + 1/2, j + 1/2) is the centre of
  /// the pixel in column i and row j.
  CameraRay ray(double x, double y) const;

  /// Do all rays start at the eye?
  bool has_one_origin() const { return !parallel_; }
  Vec3 eye() const { return eye_; }

 private:
  bool parallel_ = false;
  bool corners_ = false;
  double columns_, rows_;
  Vec3 eye_;
  Vec3 middle_;  // towards the screen's middle; with corners, its top-left
  Vec3 right_,
      up_;  // from the middle to the right and upper edge; with corners, along the top and left edges
};

}  // namespace lancer::tracer

#pragma once
// From places on the screen to rays.

#include "scene/scene.hpp"

namespace lancer::tracer {

struct CameraRay {
  Vec3 origin;
  Vec3 direction;  // unit length
};

/// In pixels from the view's left and top edge; a pixel's centre lies at halves.
struct ScreenPoint {
  double x = 0, y = 0;
};

/// How rays are made of places on the screen, columns x rows pixels large.
struct Aim {
  bool parallel = false;
  bool corners = false;
  double columns = 1, rows = 1;
  Vec3 eye;
  Vec3 middle;  // towards the screen's middle; with corners, its top-left
  Vec3 right,
      up;  // from the middle to the right and upper edge; with corners, along the top and left edges
};

class Camera {
 public:
  /// The view, drawn with columns x rows pixels, in a space that starts at `origin`.
  Camera(const scene::View& view, int columns, int rows, Vec3 origin = {});

  /// Through the point x columns from the left and y rows from the top; (i + 1/2, j + 1/2) is the centre of
  /// the pixel in column i and row j.
  CameraRay ray(double x, double y) const;

  /// Do all rays start at the eye?
  bool has_one_origin() const { return !aim_.parallel; }
  Vec3 eye() const { return aim_.eye; }
  const Aim& aim() const { return aim_; }

 private:
  Aim aim_;
};

}  // namespace lancer::tracer

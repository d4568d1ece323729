// From a scene, made here without a script, to a picture.

#include <cstdio>

#include "tracer/render.hpp"

int main() {
  using namespace lancer;
  scene::Scene scene;
  scene.settings.background = {0, 0, 0.25};
  scene.settings.ambient = grey(0.5);
  scene::Material orange;
  orange.ambient.color = {1, 0.5, 0};
  scene.materials.push_back(orange);
  scene.spheres.push_back({});
  scene.shapes.push_back({});

  scene::View view;
  view.eye = {0, 0, 5};
  view.fov = 90;
  view.columns = view.rows = 3;

  const tracer::Rendered picture = tracer::render(scene, view, {.samples = 1});
  // No light: the sphere in the middle is its ambient colour times the ambient light; beside it is the
  // background.
  const auto middle = picture.image.pixel(1, 1);
  const auto corner = picture.image.pixel(0, 0);
  const bool right = middle[0] == 0.5F && middle[1] == 0.25F && middle[2] == 0.0F && corner[0] == 0.0F &&
                     corner[1] == 0.0F && corner[2] == 0.25F;
  std::printf("from a scene: middle %g %g %g, corner %g %g %g\n", middle[0], middle[1], middle[2], corner[0],
              corner[1], corner[2]);
  return right ? 0 : 1;
}

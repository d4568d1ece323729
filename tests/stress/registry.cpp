#include "stress/stress.hpp"

namespace lancer::stress {

Rows all_rows() {
  Rows rows;
  add_sphere_rows(rows);
  add_ellipsoid_rows(rows);
  add_plane_rows(rows);
  add_facet_rows(rows);
  add_box_rows(rows);
  add_mesh_rows(rows);
  add_secondary_rows(rows);
  add_picture_rows(rows);
  add_media_rows(rows);
  add_exact_rows(rows);
  return rows;
}

}  // namespace lancer::stress

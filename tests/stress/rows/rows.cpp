#include "stress/rows/rows.hpp"

namespace lancer::stress {

Rows all_rows() {
  Rows rows;
  add_sphere_rows(rows);
  add_ellipsoid_rows(rows);
  add_plane_rows(rows);
  add_facet_rows(rows);
  add_facet_exact_rows(rows);
  add_box_rows(rows);
  add_mesh_leaks_rows(rows);
  add_mesh_vertices_rows(rows);
  add_secondary_rows(rows);
  add_picture_places_rows(rows);
  add_picture_cubes_rows(rows);
  add_picture_coincident_rows(rows);
  add_picture_gaps_rows(rows);
  add_picture_meshes_rows(rows);
  add_picture_light_rows(rows);
  add_picture_bits_rows(rows);
  add_media_nested_rows(rows);
  add_media_touching_rows(rows);
  add_media_walks_rows(rows);
  add_media_critical_rows(rows);
  add_media_bounces_rows(rows);
  add_media_furnace_rows(rows);
  add_media_hostile_rows(rows);
  add_plane_exact_rows(rows);
  add_box_exits_rows(rows);
  add_mesh_edges_rows(rows);
  add_mesh_lattice_rows(rows);
  add_media_sides_rows(rows);
  add_picture_patterns_rows(rows);
  add_picture_carried_rows(rows);
  add_kernels_bits_rows(rows);
  return rows;
}

}  // namespace lancer::stress

#pragma once
// The rows, one function for each file of them.

#include "stress/stress.hpp"

namespace lancer::stress {

/// Every row, in the order in which they are told.
Rows all_rows();

void add_sphere_rows(Rows& rows);
void add_ellipsoid_rows(Rows& rows);
void add_plane_rows(Rows& rows);
void add_facet_rows(Rows& rows);
void add_facet_exact_rows(Rows& rows);
void add_box_rows(Rows& rows);
void add_mesh_leaks_rows(Rows& rows);
void add_mesh_vertices_rows(Rows& rows);
void add_secondary_rows(Rows& rows);
void add_picture_places_rows(Rows& rows);
void add_picture_cubes_rows(Rows& rows);
void add_picture_coincident_rows(Rows& rows);
void add_picture_gaps_rows(Rows& rows);
void add_picture_meshes_rows(Rows& rows);
void add_picture_light_rows(Rows& rows);
void add_picture_bits_rows(Rows& rows);
void add_media_nested_rows(Rows& rows);
void add_media_touching_rows(Rows& rows);
void add_media_walks_rows(Rows& rows);
void add_media_critical_rows(Rows& rows);
void add_media_bounces_rows(Rows& rows);
void add_media_furnace_rows(Rows& rows);
void add_media_hostile_rows(Rows& rows);
void add_plane_exact_rows(Rows& rows);
void add_box_exits_rows(Rows& rows);
void add_mesh_edges_rows(Rows& rows);
void add_mesh_lattice_rows(Rows& rows);
void add_media_sides_rows(Rows& rows);
void add_picture_patterns_rows(Rows& rows);
void add_picture_carried_rows(Rows& rows);
void add_kernels_bits_rows(Rows& rows);

}  // namespace lancer::stress

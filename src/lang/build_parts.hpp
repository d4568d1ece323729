#pragma once
// What build_object is put together from, one file each. All throw ScriptError at the value at fault.

#include <optional>
#include <vector>

#include "lang/block_reader.hpp"

namespace lancer::lang {

/// The records of a sphere, plane, cube, box or facet.
Record build_shape(const BlockReader& reader, std::vector<Diagnostic>& warnings);
/// Of a mesh whose points and faces stand in the script.
Record build_mesh(const BlockReader& reader, Meter& meter);
/// Of a light, sun or spot.
scene::Light build_light(const BlockReader& reader);
scene::View build_view(const BlockReader& reader);

/// All of a block's transforms, in the order written, behind those that `first` stands for.
Affine build_transform(const BlockValues& values, const Affine& first = {});

/// The data of an object that is no group.
Record build_record(const BlockReader& reader, Meter& meter, std::vector<Diagnostic>& warnings);

/// Where something that is no material was given.
[[noreturn]] void refuse_material(const Argument& argument);
/// A colour or pattern of a material, no component negative.
MaterialData::Coefficient read_coefficient(const Argument& argument);

/// The mesh as a solid: wound outwards throughout. Throws ScriptError(bad_mesh) at `span` where it has holes
/// or mixed winding, or encloses nothing.
void make_solid(scene::Mesh& mesh, Meter& meter, Span span);

}  // namespace lancer::lang

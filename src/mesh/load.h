// Reads a mesh from a file: STL (binary and ASCII), OBJ and 3MF (units, transforms and several
// objects, all that its build section places), each also gzipped (.stl.gz …). What it is follows
// from the content where that is certain (binary or ASCII STL), else from the name's ending.
// Points of STL and OBJ files that are equal to the bit become one; points that no triangle uses
// go.
//
// Throws Error (one line: file, what, what to do) for a missing, empty, truncated, non-mesh file,
// for coordinates that are not finite or lie beyond 100 m, and for meshes of no triangles, no
// height or only degenerate triangles.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "mesh/mesh.h"

namespace bead {

// Size of one unit of the file in mm: 1 (mm), 25.4 (inch), 1000 (m). Without it, the file's own
// unit (3MF) or mm.
Mesh load_mesh(const std::filesystem::path& file, std::optional<double> unit_mm = {});

// The same from bytes already in memory; `name` says the format (by its ending) and names the file
// in errors. This is what the fuzzers call.
Mesh parse_mesh(std::string_view bytes, std::string_view name, std::optional<double> unit_mm = {});

}  // namespace bead

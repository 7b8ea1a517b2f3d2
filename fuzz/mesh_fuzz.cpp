// Any bytes end in a mesh that can be checked and sliced, or in an Error. The first byte says as
// what the rest is read; small meshes written by tests/support/mesh_files.h make good seeds.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "mesh/check.h"
#include "mesh/load.h"
#include "slice/slice.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::array<std::string_view, 3> names{"a.stl", "a.obj", "a.3mf"};
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const bead::Mesh mesh = bead::parse_mesh(bytes.substr(1), names[data[0] % names.size()]);
        bead::check(mesh);
        const double height = bead::bounds(mesh).size().z / 7;
        bead::slice(mesh, {.layer_height = height, .first_layer_height = height, .threads = 1});
    } catch (const bead::Error&) {
    }
    return 0;
}

#include "job/solid_material_file.h"

#include "core/error.h"
#include "job/data_file.h"
#include "job/material_file.h"
#include "job/toml_reader.h"

namespace bead {
namespace {

constexpr Range green_scales{.low = 0.5, .high = 2};

}  // namespace

SolidMaterial load_solid_material(const std::string& name_or_file) {
    const DataFile data = data_file("material", name_or_file);
    TomlReader file(data.text, data.place);
    if (!file.place_of("tensile_mpa"))
        throw Error(data.place +
                    ": says nothing of strength; add young_mpa, poisson, tensile_mpa and "
                    "compressive_mpa");
    SolidMaterial m;
    m.young = file.number("young_mpa", m.young, solid_mpa);
    m.poisson = file.number("poisson", m.poisson, {.low = 0, .high = 0.49});
    m.tensile = file.number("tensile_mpa", m.tensile, solid_mpa);
    m.compressive = file.number("compressive_mpa", m.tensile, solid_mpa);
    m.density = file.number("density_g_cm3", m.density, solid_density);
    m.green_plane = file.number("green_scale_plane", m.green_plane, green_scales);
    m.green_height = file.number("green_scale_height", m.green_height, green_scales);
    return m;
}

PrintHeat load_print_heat(const std::string& name_or_file) {
    const Material m = load_material(name_or_file);
    return {m.hotend, m.hotend_first, m.bed};
}

}  // namespace bead

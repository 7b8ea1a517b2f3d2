#include "job/material_file.h"

#include "job/data_file.h"
#include "job/toml_reader.h"

namespace bead {

namespace {

constexpr std::string_view kind = "material";
constexpr const char* usual = "pla";
constexpr Range celsius{.low = 0, .high = 600};

Material read_material(const DataFile& data, const Material& usually) {
    TomlReader file(data.text, data.place);
    Material m;
    m.density = file.number("density_g_cm3", usually.density, positive);
    m.hotend = file.number("hotend_c", usually.hotend, celsius);
    m.hotend_first = file.number("hotend_first_c", m.hotend, celsius);
    m.bed = file.number("bed_c", usually.bed, celsius);
    m.heat_capacity = file.number("heat_capacity_j_gk", usually.heat_capacity, not_negative);
    m.latent = file.number("latent_j_g", usually.latent, not_negative);
    // What solid_material_file.h reads.
    for (const std::string_view key : {"young_mpa", "poisson", "tensile_mpa", "compressive_mpa",
                                       "green_scale_plane", "green_scale_height"})
        file.ignore(key);
    file.finish();
    return m;
}

}  // namespace

Material load_material(const std::string& name_or_file) {
    const DataFile data = data_file(kind, name_or_file);
    return read_material(data, read_material(data_file(kind, usual), {}));
}

std::vector<std::string> material_names() { return data_names(kind); }

}  // namespace bead

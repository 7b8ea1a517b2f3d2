#include "job/calibrated_file.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "job/one_line.h"
#include "job/toml_reader.h"
#include "job/whole_text.h"

namespace bead {
namespace {

constexpr double unset = std::numeric_limits<double>::quiet_NaN();

void write_table(std::ostream& out, std::string_view table, EnergyModel model,
                 const std::vector<double>& values) {
    fmt::print(out, "\n[{}]\n", table);
    const auto columns = columns_of(model);
    for (std::size_t j = 0; j < columns.size(); ++j)
        fmt::print(out, "{} = {}\n", columns[j].name, values[j]);
}

std::vector<double> read_table(TomlReader& file, std::string_view table, EnergyModel model,
                               const std::string& name, const Range& range, double fallback) {
    std::vector<double> values;
    for (const ModelColumn& column : columns_of(model)) {
        const std::string key = fmt::format("{}.{}", table, column.name);
        values.push_back(file.number(key, fallback, range));
        if (std::isnan(values.back()))
            throw Error(
                fmt::format("{}: has no {}, which the model {} needs", name, key, name_of(model)));
    }
    return values;
}

}  // namespace

void write_calibrated(std::ostream& out, const CalibratedModel& model, const std::string& note) {
    fmt::print(out, "# {}\nmodel = \"{}\"\n", one_line(note), name_of(model.model));
    fmt::print(out, "acceleration_mm_s2 = {}\n", model.options.acceleration);
    if (model.error)
        fmt::print(out, "error = {}  # of prints it was not shown, mean\n", *model.error);
    write_table(out, "coefficients", model.model, model.coefficients);
    write_table(out, "standard_errors", model.model, model.standard_errors);
}

CalibratedModel read_calibrated(const std::string& name) {
    TomlReader file(whole_text(name), name);
    CalibratedModel model;
    if (file.text("model", "").empty())
        throw Error(name + ": has no model; write it with beadwork calibrate -o");
    model.model = static_cast<EnergyModel>(file.choice("model", 0, energy_model_names));
    model.options.acceleration =
        file.number("acceleration_mm_s2", model.options.acceleration, positive);
    if (const double error = file.number("error", -1, not_negative); error >= 0)
        model.error = error;
    model.coefficients = read_table(file, "coefficients", model.model, name, {}, unset);
    model.standard_errors = read_table(file, "standard_errors", model.model, name, not_negative, 0);
    file.finish();
    return model;
}

}  // namespace bead

#include "energy_report.h"

#include "energy/interval.h"
#include "energy_table.h"
#include "job/tariff_text.h"

namespace bead::cli {
namespace {

double grams_of(const EnergyResult& result, double joules) {
    return joules / joules_per_kwh * result.grid_co2;
}

Interval interval_of(const EnergyResult& result) {
    const Features& features = result.judged.cost.features;
    if (result.mode == EnergyMode::published) return published_interval_95(features);
    if (result.mode == EnergyMode::corrected) return standing_interval_95(features);
    return interval_95(result.judged.cost.energy.energy,
                       result.judged.choice.machine.printer.power);
}

double of_features(const EnergyResult& result, const Features& features) {
    return result.mode == EnergyMode::published ? published_energy(features)
                                                : standing_form(features);
}

std::string money(const EnergyResult& result, double price) {
    return result.bill ? fmt::format(", costs {:.3f}", price) : "";
}

void print_bill(const Console& console, const EnergyResult& result) {
    if (!result.bill || result.tariff->size() < 2) return;
    for (std::size_t i = 0; i < result.tariff->size(); ++i) {
        const Rate& rate = (*result.tariff)[i];
        if (result.bill->energy[i] <= 0) continue;
        console.say("                {} to {}: {:.1f} Wh at {:g} per kWh\n", clock_text(rate.from),
                    clock_text(rate.to), result.bill->energy[i] / 3600, rate.price);
    }
}

void print_physics(const Console& console, const EnergyResult& result) {
    const EnergyReport& report = result.judged.cost.energy;
    const Interval interval = interval_of(result);
    const double all = total(report.energy), print = all - report.heat_up;
    const Bill bill = result.bill.value_or(Bill{});
    console.say("from the wall   {}  (95 % sure: {:.1f} to {:.1f} Wh), {:.0f} g of CO2{}\n",
                console.strong(fmt::format("{:.1f} Wh", all / 3600)), interval.low / 3600,
                interval.high / 3600, grams_of(result, all),
                money(result, bill.heat_up + bill.print));
    console.say("heating up      {:.1f} Wh of it, in {}{}\n", report.heat_up / 3600,
                spoken_time(report.heat_up_duration), money(result, bill.heat_up));
    console.say("printing        {:.1f} Wh, in {}, {:.0f} W on average{}\n", print / 3600,
                spoken_time(report.duration), report.duration > 0 ? print / report.duration : 0.0,
                money(result, bill.print));
    console.say("at most         {:.0f} W, after {}\n", report.peak_power,
                spoken_time(report.peak_time));
    print_bill(console, result);
    console.say("\n");
    print_consumers(console, report.energy);
    print_features(console, report);
    if (report.energy.bed + report.energy.hotend == 0)
        console.say("The file sets no temperature: heaters are not in these figures.\n");
}

void print_motors(const Console& console, const EnergyResult& result) {
    const Interval interval = interval_of(result);
    const double joules = energy_of(result);
    const Bill bill = result.bill.value_or(Bill{});
    console.say(
        "X and Y motors  {}  (95 % sure: {:.2f} to {:.2f} kJ, near the prints of its fit), "
        "{:.2f} Wh, {:.1f} g of CO2{}\n",
        console.strong(fmt::format("{:.2f} kJ", joules / 1000)), interval.low / 1000,
        interval.high / 1000, joules / 3600, grams_of(result, joules),
        money(result, bill.heat_up + bill.print));
    print_bill(console, result);
    console.say("\n");
    const PerRole<Features> by_role = result.features.by_role();
    for (std::size_t role = 0; role < by_role.size(); ++role)
        if (const double part = of_features(result, by_role[role]); part > 0)
            console.say("{:>14} {:>9.2f} kJ {:>5.1f} %\n", role_names[role], part / 1000,
                        100 * part / joules);
}

Json consumers_json(const Energy& energy) {
    return {{"bed_j", energy.bed},
            {"hotend_j", energy.hotend},
            {"motors_j", energy.motors},
            {"fans_j", energy.fans},
            {"electronics_j", energy.electronics}};
}

Json consumers_by_role_json(const PerRole<Energy>& by_role) {
    Json json = Json::object();
    for (std::size_t role = 0; role < by_role.size(); ++role)
        if (total(by_role[role]) > 0)
            json[std::string(role_names[role])] = consumers_json(by_role[role]);
    return json;
}

Json physics_json(const EnergyResult& result) {
    const EnergyReport& report = result.judged.cost.energy;
    Json json = energy_json(result.judged.cost, result.judged.choice.machine.printer.power);
    json["co2_g"] = grams_of(result, total(report.energy));
    json["heat_up_co2_g"] = grams_of(result, report.heat_up);
    json["print_j"] = total(report.energy) - report.heat_up;
    json["print_co2_g"] = grams_of(result, total(report.energy) - report.heat_up);
    json["peak_time_s"] = report.peak_time;
    json["heat_up_consumers"] = consumers_json(report.heat_up_consumers);
    json["consumers_by_role"] = consumers_by_role_json(report.consumers_by_role);
    for (std::size_t i = 0; i < report.by_layer.size(); ++i)
        json["by_layer"][i]["consumers_by_role"] =
            consumers_by_role_json(report.by_layer[i].by_role);
    return json;
}

Json motors_json(const EnergyResult& result) {
    const double joules = energy_of(result);
    const Interval interval = interval_of(result);
    const char* const key =
        result.mode == EnergyMode::published ? "xy_motor_energy_j" : "xy_motor_energy_standing_j";
    Json json{{key, joules},
              {"interval_95", {interval.low, interval.high}},
              {"co2_g", grams_of(result, joules)}};
    const PerRole<Features> by_role = result.features.by_role();
    json["by_role"] = Json::object();
    for (std::size_t role = 0; role < by_role.size(); ++role)
        if (const double part = of_features(result, by_role[role]); part > 0)
            json["by_role"][std::string(role_names[role])] = part;
    json["by_layer"] = Json::array();
    const std::vector<LayerFeatures>& layers = result.features.layers();
    json["before_layers_j"] = of_features(result, total(layers.front().by_role));
    for (std::size_t i = 1; i < layers.size(); ++i)
        json["by_layer"].push_back({{"z_mm", layers[i].z},
                                    {"time_s", layers[i].duration},
                                    {"energy_j", of_features(result, total(layers[i].by_role))}});
    return json;
}

Json bill_json(const EnergyResult& result) {
    Json rates = Json::array();
    for (std::size_t i = 0; i < result.tariff->size(); ++i) {
        const Rate& rate = (*result.tariff)[i];
        rates.push_back({{"from", clock_text(rate.from)},
                         {"to", clock_text(rate.to)},
                         {"price_per_kwh", rate.price},
                         {"energy_j", result.bill->energy[i]}});
    }
    return {{"total", result.bill->heat_up + result.bill->print},
            {"heat_up", result.bill->heat_up},
            {"print", result.bill->print},
            {"start", clock_text(result.start)},
            {"rates", rates}};
}

// Where a parameter's value is from.
std::string source_of(const Parameter& parameter, const MachineOptions& options) {
    if (parameter.from == ParameterFrom::publication) return "Somade (2023), Table 3";
    if (parameter.from == ParameterFrom::material) return "material " + options.material;
    const std::string key = parameter.name.substr(0, parameter.name.find('['));
    for (const std::string& setting : options.set)
        if (setting.substr(0, setting.find_first_of(" =")) == key) return "--set";
    return printer_label(options);
}

}  // namespace

double energy_of(const EnergyResult& result) {
    if (result.mode == EnergyMode::physics) return total(result.judged.cost.energy.energy);
    return of_features(result, result.judged.cost.features);
}

void print_energy(const Console& console, const EnergyResult& result,
                  const MachineOptions& options) {
    const JudgedFile& judged = result.judged;
    console.say("{}: {}\n", judged.name, described(judged.file));
    console.say("mode            {}: {}\n", name_of(result.mode), about(result.mode));
    console.say("machine         {}; firmware {} (from: {})\n\n", printer_label(options),
                name_of(judged.choice.firmware.firmware), judged.choice.firmware.source);
    result.mode == EnergyMode::physics ? print_physics(console, result)
                                       : print_motors(console, result);
    if (!result.terms.empty()) print_terms(console, result, options);
    print_limits(console, judged);
    if (const std::string ignored = ignored_in(judged.file); !ignored.empty())
        console.say("without effect here: {}\n", ignored);
    for (const std::string& note : judged.choice.notes) console.say("note: {}\n", note);
}

void print_terms(const Console& console, const EnergyResult& result,
                 const MachineOptions& options) {
    console.say("\nevery term, {}\n", result.mode == EnergyMode::physics
                                          ? "before the supply; its loss comes last"
                                          : "of the X and Y motors");
    for (const ExplainedTerm& term : result.terms) {
        console.say("{:>12.1f} J  {:<28} {}\n", term.joules, term.name, term.formula);
        for (const Parameter& parameter : term.parameters)
            console.say("{:>14}  {} = {:.6g}  ({})\n", "", parameter.name, parameter.value,
                        source_of(parameter, options));
    }
    console.say("{:>12.1f} J  in all\n", total(result.terms));
}

Json energy_result_json(const EnergyResult& result) {
    Json json{{"mode", name_of(result.mode)}, {"model", name_of(result.mode)}};
    json["energy_j"] = energy_of(result);
    json.update(result.mode == EnergyMode::physics ? physics_json(result) : motors_json(result));
    json["grid_co2_g_per_kwh"] = result.grid_co2;
    if (result.bill) json["cost"] = bill_json(result);
    return json;
}

Json terms_json(const EnergyResult& result, const MachineOptions& options) {
    Json terms = Json::array();
    for (const ExplainedTerm& term : result.terms) {
        Json parameters = Json::array();
        for (const Parameter& parameter : term.parameters)
            parameters.push_back({{"name", parameter.name},
                                  {"value", parameter.value},
                                  {"source", source_of(parameter, options)}});
        terms.push_back({{"consumer", term.consumer},
                         {"name", term.name},
                         {"formula", term.formula},
                         {"parameters", parameters},
                         {"energy_j", term.joules}});
    }
    return terms;
}

}  // namespace bead::cli

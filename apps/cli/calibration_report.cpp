#include "calibration_report.h"

#include <cmath>

namespace bead::cli {
namespace {

std::string percent(const std::optional<RelativeErrors>& errors) {
    return errors ? fmt::format("{:.1f} %", 100 * errors->mean_absolute) : "-";
}

// A large condition is no number to be read to the digit.
std::string shown(double condition) {
    return condition < 1000 ? fmt::format("{:.1f}", condition) : fmt::format("{:.0e}", condition);
}

void print_models(const Console& console, const Calibration& found) {
    console.say("\n{:<10} {:<13} {:>9} {:>9} {:>9} {:>9} {:>8} {:>10}\n", "model", "fit", "shown",
                "left out", "group out", "R2", "centred", "condition");
    for (const FittedModel& fit : found.fits)
        console.say("{:<10} {:<13} {:>9} {:>9} {:>9} {:>9.6f} {:>8.3f} {:>10}\n",
                    name_of(fit.model), name_of(fit.method), percent(fit.shown), percent(fit.alone),
                    percent(fit.by_group), fit.fit.r2, fit.fit.r2_centred,
                    shown(fit.fit.condition));
    console.say("{:<10} {:<13} {:>9} {:>9}   (every print called the mean of the others)\n", "mean",
                "", "", percent(found.mean));
    for (const Unfitted& model : found.unfitted)
        console.say("{}: {}\n", name_of(model.model), model.reason);
}

void print_coefficients(const Console& console, const FittedModel& fit) {
    const auto columns = columns_of(fit.model);
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const double unit = columns[j].per_joule;
        std::string range;
        if (!fit.scatter.coefficients.empty())
            range = fmt::format("  95 %: {:.4g} … {:.4g}", fit.scatter.coefficients[j].low * unit,
                                fit.scatter.coefficients[j].high * unit);
        console.say("  {:<9} {:>11.6g} ± {:<8.3g} {:<11}{}  ({})\n", columns[j].name,
                    fit.fit.coefficients[j] * unit, fit.fit.standard_errors[j] * unit,
                    columns[j].unit, range, columns[j].about);
    }
}

void print_worst(const Console& console, const char* what,
                 const std::optional<RelativeErrors>& errors,
                 const std::vector<Observation>& prints) {
    if (errors)
        console.say("  {}: {:.2f} % on average, at worst {:+.1f} % ({})\n", what,
                    100 * errors->mean_absolute, 100 * errors->worst,
                    prints[errors->worst_row].name);
}

// Paths are told apart by their ends.
std::string ending(const std::string& name) {
    constexpr std::size_t most = 34;
    return name.size() <= most ? name : "..." + name.substr(name.size() - most + 3);
}

void print_rows(const Console& console, const FittedModel& fit,
                const std::vector<Observation>& prints) {
    constexpr std::size_t most = 30;
    console.say("\n  {:<34} {:>12} {:>12} {:>8} {:>9}\n", "print", "measured J", "fitted J", "off",
                "leverage");
    for (std::size_t i = 0; i < std::min(most, prints.size()); ++i)
        console.say("  {:<34} {:>12.2f} {:>12.2f} {:>+6.1f} % {:>9.2f}\n", ending(prints[i].name),
                    prints[i].energy, fit.estimates[i],
                    100 * (fit.estimates[i] / prints[i].energy - 1), fit.fit.leverage[i]);
    if (prints.size() > most)
        console.say("  … and {} more (--json has all)\n", prints.size() - most);
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json coefficients_json(const FittedModel& fit) {
    Json list = Json::array();
    const auto columns = columns_of(fit.model);
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const double unit = columns[j].per_joule;
        Json one{{"name", columns[j].name},
                 {"value", fit.fit.coefficients[j] * unit},
                 {"standard_error", fit.fit.standard_errors[j] * unit},
                 {"unit", columns[j].unit},
                 {"of", columns[j].about}};
        if (!fit.scatter.coefficients.empty())
            one["bootstrap_95"] = {fit.scatter.coefficients[j].low * unit,
                                   fit.scatter.coefficients[j].high * unit};
        list.push_back(std::move(one));
    }
    return list;
}

void put_errors(Json& json, const std::string& name, const std::optional<RelativeErrors>& errors) {
    json[name + "_mape_percent"] = errors ? Json(100 * errors->mean_absolute) : Json();
    json[name + "_worst_percent"] = errors ? Json(100 * errors->worst) : Json();
}

Json fit_json(const FittedModel& fit) {
    Json json{{"model", name_of(fit.model)},
              {"fit", name_of(fit.method)},
              {"coefficients", coefficients_json(fit)},
              {"r2", fit.fit.r2},
              {"r2_centred", fit.fit.r2_centred},
              {"condition_number", number_or_null(fit.fit.condition)},
              {"bootstrap_draws", fit.scatter.fitted}};
    put_errors(json, "in_sample", fit.shown);
    put_errors(json, "loo", fit.alone);
    put_errors(json, "logo", fit.by_group);
    return json;
}

Json rows_json(const FittedModel& fit, const std::vector<Observation>& prints) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < prints.size(); ++i)
        rows.push_back({{"name", prints[i].name},
                        {"group", prints[i].group},
                        {"energy_j", prints[i].energy},
                        {"fitted_j", fit.estimates[i]},
                        {"residual_j", prints[i].energy - fit.estimates[i]},
                        {"off_percent", 100 * (fit.estimates[i] / prints[i].energy - 1)},
                        {"leverage", fit.fit.leverage[i]}});
    return rows;
}

const std::optional<RelativeErrors>& judged_by(const FittedModel& fit, bool grouped) {
    return grouped ? fit.by_group : fit.alone;
}

// Where leaving a group out takes away what decides a coefficient, the bound at 0 stands in for
// the missing prints; nobody should take that for evidence.
std::string held_by_the_bound(const Calibration& found, const FittedModel& best) {
    constexpr double much = 1.5;
    if (best.method != FitMethod::non_negative || !best.by_group) return "";
    for (const FittedModel& fit : found.fits)
        if (fit.model == best.model && fit.method == FitMethod::ordinary && fit.by_group &&
            fit.by_group->mean_absolute > much * best.by_group->mean_absolute)
            return fmt::format(
                " Part of that is owed to the bound at 0 (without it {:.1f} %): where a group is "
                "missing, the others do not decide every coefficient. More kinds of print would.",
                100 * fit.by_group->mean_absolute);
    return "";
}

}  // namespace

std::string verdict(const Calibration& found) {
    const auto place = best_at_new_prints(found);
    if (!place) return "No fit could be tried on prints that it was not shown: add prints.";
    const FittedModel& best = found.fits[*place];
    const bool grouped = best.by_group.has_value();
    std::string text = fmt::format(
        "{} ({}) generalises best: {} that it was not shown {} off by {:.1f} % on average",
        name_of(best.model), name_of(best.method), grouped ? "a group of prints" : "a print", "is",
        100 * judged_by(best, grouped)->mean_absolute);
    std::string others;
    for (const FittedModel& fit : found.fits)
        if (fit.method == best.method && fit.model != best.model && judged_by(fit, grouped))
            others += fmt::format("{}{} {:.1f} %", others.empty() ? "; by the same method " : ", ",
                                  name_of(fit.model), 100 * judged_by(fit, grouped)->mean_absolute);
    text += others + ".";
    text += held_by_the_bound(found, best);
    if (found.mean && judged_by(best, grouped)->mean_absolute > found.mean->mean_absolute)
        text += fmt::format(
            " The mean of the other prints is no worse a guess ({:.1f} %): do not "
            "trust any of these beyond prints like those measured.",
            100 * found.mean->mean_absolute);
    return text;
}

void print_calibration(const Console& console, const Calibration& found, std::size_t chosen,
                       const std::vector<Observation>& prints) {
    print_models(console, found);
    console.say("\n{}\n", verdict(found));
    const FittedModel& fit = found.fits[chosen];
    console.say("\n{}\n", console.strong(fmt::format("{}, {} least squares", name_of(fit.model),
                                                     name_of(fit.method))));
    print_coefficients(console, fit);
    print_worst(console, "prints it was fitted to", fit.shown, prints);
    print_worst(console, "prints left out one by one", fit.alone, prints);
    print_worst(console, "groups left out one by one", fit.by_group, prints);
    print_rows(console, fit, prints);
}

Json calibration_json(const Calibration& found, std::size_t chosen,
                      const MeasuredPrints& measured) {
    Json json{{"read_as", measured.kind},
              {"scope", measured.of_machine ? "machine" : "motors"},
              {"observations", measured.prints.size()},
              {"groups", found.groups}};
    json.update(fit_json(found.fits[chosen]));
    put_errors(json, "mean_only_loo", found.mean);
    json["rows"] = rows_json(found.fits[chosen], measured.prints);
    json["models"] = Json::array();
    for (const FittedModel& fit : found.fits) json["models"].push_back(fit_json(fit));
    json["unfitted"] = Json::array();
    for (const Unfitted& model : found.unfitted)
        json["unfitted"].push_back({{"model", name_of(model.model)}, {"reason", model.reason}});
    if (const auto best = best_at_new_prints(found))
        json["generalises_best"] = {{"model", name_of(found.fits[*best].model)},
                                    {"fit", name_of(found.fits[*best].method)}};
    json["verdict"] = verdict(found);
    if (!measured.details.is_null()) json["source"] = measured.details;
    return json;
}

}  // namespace bead::cli

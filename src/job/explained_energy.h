// Where an energy comes from, term by term: formula, the parameters by their names in a
// PRINTER.toml or MATERIAL.toml, and joules. The terms' sum is the energy.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "energy/published.h"
#include "energy/report.h"
#include "machine/material.h"
#include "machine/printer.h"

namespace bead {

enum class ParameterFrom { printer, material, publication };

struct Parameter {
    std::string name;  // with its unit, as a file has it
    double value = 0;
    ParameterFrom from = ParameterFrom::printer;
};

struct ExplainedTerm {
    std::string_view consumer;  // "motors"; "supply" for what it loses
    std::string name;
    std::string_view formula;
    std::vector<Parameter> parameters;
    double joules = 0;
};

// Of the physics model: low-voltage joules, then what the supply loses.
std::vector<ExplainedTerm> explained(const EnergyTerms& terms, const Printer& printer,
                                     const Material& material);
// Of Eq. 28 as published, and of its standing form.
std::vector<ExplainedTerm> explained_published(const Features& f, const MotorCoefficients& k = {});
std::vector<ExplainedTerm> explained_standing(const Features& f, const MotorCoefficients& k = {},
                                              double usual_speed = 80);

double total(const std::vector<ExplainedTerm>& terms);  // J

}  // namespace bead

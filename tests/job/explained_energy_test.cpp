#include "job/explained_energy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "energy/meter.h"
#include "job/material_file.h"
#include "job/printer_file.h"
#include "support/any_print.h"

namespace bead {
namespace {

using namespace test;

TEST(ExplainedEnergy, SumsToTheTotalOfEveryPrinter) {
    const Material pla = load_material("pla");
    for (const std::string& name : printer_names()) {
        const Printer printer = load_printer(name);
        EnergyMeter meter(printer, pla);
        meter.add(SetHeat{Heater::bed, 60, true});
        meter.add(SetHeat{Heater::hotend, 215, true});
        meter.add(SetFan{0.5});
        for (const double way : {30., -30.}) meter.add(trapezoid({way, way, 0, 2}, 0, 0, 60, 1000));
        meter.add(SetHeat{Heater::bed, 0, false});
        meter.add(Dwell{60});
        const EnergyReport report = meter.report();
        const auto terms = explained(report.terms, printer, pla);
        EXPECT_NEAR(total(terms), total(report.energy), 1e-9 * total(report.energy)) << name;
        for (const ExplainedTerm& term : terms) EXPECT_FALSE(term.parameters.empty()) << term.name;
    }
}

// Every name that is told can be set, and is then told with the value that was set.
TEST(ExplainedEnergy, NamesParametersAsFilesDo) {
    const Printer printer = load_printer("prusa-mk3s");
    for (const ExplainedTerm& term : explained({}, printer, load_material("pla")))
        for (const Parameter& parameter : term.parameters) {
            if (parameter.from != ParameterFrom::printer) continue;
            const std::string key = parameter.name.substr(0, parameter.name.find('['));
            const bool is_array = key != parameter.name;
            EXPECT_NO_THROW(with_setting(printer, key + (is_array ? "=[0.1,0.1,0.1,0.1]" : "=0.5")))
                << key;
        }
}

RC_GTEST_PROP(ExplainedFeatures, SumToTheMode, ()) {
    Features f;
    for (int i = 0; i < 20; ++i) f += features_of(any_block());
    RC_ASSERT(near(total(explained_published(f)), published_energy(f)));
    RC_ASSERT(near(total(explained_standing(f)), standing_form(f)));
}

}  // namespace
}  // namespace bead

#include "job/calibrated_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "core/error.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

RC_GTEST_PROP(CalibratedFile, ReadsBackToTheDigit, ()) {
    CalibratedModel model;
    model.model = EnergyModel(*rc::gen::inRange(0, int(energy_model_names.size())));
    model.options.acceleration = 1 + *rc::gen::inRange(0, 5000) / 7.0;
    if (*rc::gen::arbitrary<bool>()) model.error = *rc::gen::inRange(0, 1000) / 7e3;
    for (std::size_t j = 0; j < columns_of(model.model).size(); ++j) {
        model.coefficients.push_back(*rc::gen::inRange(-1000, 100000) / 7e6);
        model.standard_errors.push_back(*rc::gen::inRange(0, 1000) / 3e9);
    }
    std::ostringstream text;
    write_calibrated(text, model, "a note\nof two lines");
    const test::ScratchFile file("model.toml", text.str());
    const CalibratedModel read = read_calibrated(file.path());
    RC_ASSERT(read.model == model.model);
    RC_ASSERT(read.options.acceleration == model.options.acceleration);
    RC_ASSERT(read.error == model.error);
    RC_ASSERT(read.coefficients == model.coefficients);
    RC_ASSERT(read.standard_errors == model.standard_errors);
}

TEST(CalibratedFile, SaysWhatIsMissing) {
    const struct {
        const char *text, *words;
    } faults[] = {
        {"", "no model"},
        {"model = \"magic\"\n", "one of published"},
        {"model = \"physical\"\n[coefficients]\nmove = 1\n", "coefficients.hold"},
        {"model = \"physical\"\n[coefficients]\nmove = 1\nhold = 2\nAB = 3\n", "AB"},
    };
    for (const auto& fault : faults) {
        const test::ScratchFile file("model.toml", fault.text);
        try {
            read_calibrated(file.path());
            ADD_FAILURE() << fault.text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(fault.words), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace bead

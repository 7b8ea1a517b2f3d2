// Whatever is wrong with what the user gave: one clear line, the right exit status, nothing
// half-written.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/program.h"

namespace bead {
namespace {

using test::beadwork;
using test::Folder;
using test::Outcome;

const std::string box = BEAD_SOURCE_DIR "/examples/parts/square.stl";

// One line on standard error that starts with the program's name; warnings may come before it.
void expect_one_clear_line(const Outcome& outcome, const std::string& words,
                           const std::string& what) {
    std::string last = outcome.err;
    ASSERT_FALSE(last.empty()) << what;
    EXPECT_EQ(last.back(), '\n') << what;
    last.pop_back();
    last = last.substr(last.rfind('\n') == std::string::npos ? 0 : last.rfind('\n') + 1);
    EXPECT_EQ(last.rfind("beadwork: ", 0), 0U) << what << ": " << outcome.err;
    EXPECT_NE(last.find(words), std::string::npos) << what << ": " << last;
}

struct BadMesh {
    const char *name, *content, *words;
};

TEST(BadInput, MeshesThatAreNone) {
    const BadMesh meshes[] = {
        {"empty.stl", "", "empty"},
        {"text.stl", "this is a letter, not a mesh", "STL"},
        {"none.stl", "solid nothing\nendsolid nothing\n", "triangle"},
        {"nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 1\nf 1 2 3\n", "finite"},
        {"flat.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n", "height"},
        {"needle.obj", "v 0 0 0\nv 0 0 5\nv 0 0 9\nf 1 2 3\n", "without area"},
        {"index.obj", "v 0 0 0\nv 10 0 0\nv 0 10 5\nf 1 2 7\n", "7"},
        {"broken.3mf", "PK\003\004 and then nothing", "3mf"},
        {"broken.stl.gz", "\037\213\010 not really", "gz"},
    };
    for (const BadMesh& mesh : meshes)
        for (const std::string command : {"slice ", "optimize "}) {
            const Folder folder;
            const std::string file = folder.write(mesh.name, mesh.content);
            const Outcome outcome = beadwork(command + file + " -o " + (folder / "out.gcode"));
            EXPECT_EQ(outcome.status, 3) << mesh.name;
            expect_one_clear_line(outcome, mesh.words, mesh.name);
            EXPECT_EQ(folder.files(), 1U) << mesh.name << " left something behind";
        }
}

TEST(BadInput, TruncatedBinaryStl) {
    const Folder folder;
    const std::string whole = test::content(box);
    ASSERT_GT(whole.size(), 200U);
    const std::string file = folder.write("cut.stl", whole.substr(0, whole.size() - 60));
    const Outcome outcome = beadwork("slice " + file + " -o " + (folder / "out.gcode"));
    EXPECT_EQ(outcome.status, 3);
    expect_one_clear_line(outcome, "truncated", "cut.stl");
}

struct BadCall {
    const char* arguments;
    int status;
    const char* words;
};

TEST(BadInput, SettingsOutsideSense) {
    const BadCall calls[] = {
        {"--set colour=red", 2, "colour"},
        {"--set layer_heigth_mm=0.2", 2, "layer_height_mm"},
        {"--set density", 2, "name=value"},
        {"--density 1.7", 2, "density"},
        {"--density -1", 2, "density"},
        {"--density much", 2, "much"},
        {"--layer-height 0", 2, "layer_height_mm"},
        {"--layer-height nan", 2, "layer_height_mm"},
        {"--layer-height 5", 2, "bead"},
        {"--walls -3", 2, "walls"},
        {"--pattern zebra", 2, "zebra"},
        {"--printer nonesuch", 2, "nonesuch"},
        {"--printer missing.toml", 3, "missing.toml"},
        {"--material cheese", 2, "cheese"},
        {"--config missing.toml", 3, "missing.toml"},
        {"--lookahead 2", 2, "lookahead"},
        {"--lookahead many", 2, "many"},
        {"--firmware abacus", 2, "abacus"},
        {"--units furlong", 2, "furlong"},
        {"--no-such-option", 2, "no-such-option"},
        {"--units m", 4, "--units"},
    };
    for (const BadCall& call : calls) {
        const Folder folder;
        const Outcome outcome =
            beadwork("slice " + box + " -o " + (folder / "out.gcode") + " " + call.arguments);
        EXPECT_EQ(outcome.status, call.status) << call.arguments << ": " << outcome.err;
        expect_one_clear_line(outcome, call.words, call.arguments);
        EXPECT_EQ(folder.files(), 0U) << call.arguments << " left something behind";
    }
}

TEST(BadInput, PlacesThatCannotBeWritten) {
    for (const std::string place : {"/nonexistent/folder/out.gcode", "/dev/full", "/tmp"}) {
        const Outcome outcome = beadwork("slice " + box + " -o " + place);
        EXPECT_EQ(outcome.status, 1) << place << ": " << outcome.err;
        expect_one_clear_line(outcome, place, place);
    }
    const Folder folder;
    const Outcome outcome =
        beadwork("slice " + box + " --json /dev/full -o " + (folder / "out.gcode"));
    EXPECT_EQ(outcome.status, 1) << outcome.err;
}

TEST(BadInput, AnExistingFileSurvivesAFailure) {
    const Folder folder;
    const std::string old = folder.write("out.gcode", "precious\n");
    EXPECT_NE(beadwork("slice " + (folder / "missing.stl") + " -o " + old).status, 0);
    EXPECT_EQ(test::content(old), "precious\n");
}

TEST(BadInput, APartLargerThanTheBed) {
    const Folder folder;
    for (const std::string command : {"slice ", "optimize "}) {
        const Outcome outcome =
            beadwork(command + box + " --units inch -o " + (folder / "out.gcode"));
        EXPECT_EQ(outcome.status, 4) << outcome.err;
        expect_one_clear_line(outcome, "bed", command);
    }
}

TEST(BadInput, GcodeThatIsNone) {
    const BadCall files[] = {
        {"", 3, "nothing moves"},
        {"hello, this is not for a machine\n", 3, "G-code"},
        {"G28\nG1 X1e300\n", 3, ":2"},
        {"GCDE\001\002", 3, "binary"},
    };
    for (const BadCall& file : files)
        for (const std::string command : {"simulate ", "energy "}) {
            const Folder folder;
            const Outcome outcome = beadwork(command + folder.write("a.gcode", file.arguments));
            EXPECT_EQ(outcome.status, file.status) << file.arguments << ": " << outcome.err;
            expect_one_clear_line(outcome, file.words, file.arguments);
        }
    const Outcome missing = beadwork("simulate missing.gcode");
    EXPECT_EQ(missing.status, 3);
    expect_one_clear_line(missing, "missing.gcode", "missing");
}

TEST(BadInput, NumbersThatAreNone) {
    const std::string part = BEAD_SOURCE_DIR "/examples/cases/mbb.toml";
    const BadCall calls[] = {
        {"stress CASE --h nan", 2, "--h: nan is not finite"},
        {"stress CASE --h inf", 2, "--h"},
        {"strength CASE --fill nan", 2, "--fill: nan is not finite"},
        {"strength CASE --range 10 NaN", 2, "--range: NaN is not finite"},
        {"reinforce CASE -o OUT --hotend nan", 2, "--hotend: nan is not finite"},
        {"reinforce CASE -o OUT --speed -nan", 2, "--speed"},
    };
    for (const BadCall& call : calls) {
        const Folder folder;
        std::string arguments = call.arguments;
        arguments.replace(arguments.find("CASE"), 4, part);
        if (const std::size_t at = arguments.find("OUT"); at != std::string::npos)
            arguments.replace(at, 3, folder / "out.gcode");
        const Outcome outcome = beadwork(arguments);
        EXPECT_EQ(outcome.status, call.status) << call.arguments << ": " << outcome.err;
        expect_one_clear_line(outcome, call.words, call.arguments);
        EXPECT_EQ(folder.files(), 0U) << call.arguments;
    }
}

TEST(BadInput, NoCommandOrAWrongOne) {
    EXPECT_EQ(beadwork("").status, 2);
    EXPECT_EQ(beadwork("bake").status, 2);
    EXPECT_EQ(beadwork("--help").status, 0);
    for (const std::string command : {"slice", "optimize", "simulate", "energy"}) {
        const Outcome help = beadwork(command + " --help");
        EXPECT_EQ(help.status, 0);
        EXPECT_NE(help.out.find("Example"), std::string::npos) << command;
    }
}

}  // namespace
}  // namespace bead

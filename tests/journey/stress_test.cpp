// `stress` from CASE.toml to JSON, against CalculiX 2.20 (CPS6 on gmsh's meshes, two sizes).
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace bead {
namespace {

using nlohmann::json;
using test::beadwork;
using test::Folder;

std::string example(const std::string& name) {
    return std::string(BEAD_SOURCE_DIR) + "/examples/cases/" + name + ".toml";
}

json stress(const std::string& arguments) {
    const test::Outcome run = beadwork("stress " + arguments + " --json -");
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out, nullptr, false);
}

struct Probe {
    double s1, s2;  // MPa
};

void expect_probes(const json& result, const std::vector<Probe>& known, double tolerance) {
    ASSERT_EQ(result["probes"].size(), known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double size = std::max(std::abs(known[i].s1), std::abs(known[i].s2));
        EXPECT_NEAR(result["probes"][i]["s1"], known[i].s1, tolerance * size) << i;
        EXPECT_NEAR(result["probes"][i]["s2"], known[i].s2, tolerance * size) << i;
    }
}

TEST(Stress, OfTheMbbBeamIsCalculixs) {
    const json result = stress(example("mbb"));
    EXPECT_NEAR(result["work_n_mm"], 16.110075, 0.001 * 16.110075);
    expect_probes(result,
                  {{3.53388, 0.000549},
                   {0.995366, -0.124084},
                   {0.500558, -0.505902},
                   {0.0141, -1.8698},
                   {0.175668, -0.964212}},
                  0.002);
    EXPECT_NEAR(result["probes"][1]["angle_deg"], -20.827, 0.1);
    EXPECT_NEAR(result["probes"][0]["uy"], -0.146889, 1e-4);
    EXPECT_NEAR(result["reactions"][0]["y_n"], 50, 1e-6);
}

TEST(Stress, OfTheCantileverIsCalculixs) {
    const json result = stress(example("cantilever"));
    EXPECT_NEAR(result["work_n_mm"], 243.04901, 0.001 * 243.04901);
    expect_probes(result,
                  {{0.668738, -0.66861},
                   {5.390602, -0.05737},
                   {1.000451, -1.000449},
                   {0.057354, -5.390631},
                   {9.61249, -0.013983}},
                  0.005);
    EXPECT_NEAR(result["reactions"][0]["y_n"], 100, 1e-6);
    EXPECT_NEAR(result["max_displacement_mm"], 2.47, 0.01);
}

TEST(Stress, AroundAHoleIsCalculixs) {
    const json result = stress(example("plate_with_hole"));
    EXPECT_NEAR(result["work_n_mm"], 4599.6511, 0.0001 * 4599.6511);
    expect_probes(result,
                  {{30.302, 0.064},
                   {-0.089, -10.229},
                   {12.2822, 2.81425},
                   {10.4612, 0.80635},
                   {10.0012, 0.10258}},
                  0.03);
}

TEST(Stress, OnPixelsIsNearlyThatOnTriangles) {
    const json triangles = stress(example("cantilever"));
    const json pixels = stress(example("cantilever") + " --elements pixels --h 0.5");
    EXPECT_EQ(pixels["element"], "Q4");
    EXPECT_NEAR(pixels["work_n_mm"], triangles["work_n_mm"], 0.002 * 243);
    EXPECT_NEAR(pixels["probes"][1]["s1"], triangles["probes"][1]["s1"], 0.03);
    EXPECT_NEAR(pixels["reactions"][0]["y_n"], 100, 1e-4);
}

TEST(Stress, WritesFieldsAndAPicture) {
    const Folder folder;
    const std::string again = folder / "again.vtu";
    for (const std::string& vtu : {folder / "a.vtu", again}) {
        const test::Outcome run = beadwork("stress " + example("bracket") + " -o " + vtu +
                                           " --picture " + (folder / "a.svg"));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    const std::string text = test::content(again);
    EXPECT_TRUE(text.starts_with("<?xml"));
    EXPECT_NE(text.find("displacement_mm"), std::string::npos);
    EXPECT_EQ(text, test::content(folder / "a.vtu"));
    EXPECT_NE(test::content(folder / "a.svg").find("</svg>"), std::string::npos);
}

struct VtuArray {
    std::string name;
    int components = 1;
    std::vector<std::byte> bytes;
};

// The arrays of a .vtu, by what its XML says of them.
std::vector<VtuArray> arrays_of(const std::string& text) {
    const std::size_t data = text.find("<AppendedData encoding=\"raw\">\n");
    const std::string xml = text.substr(0, data);
    const std::size_t begin = text.find('_', data) + 1;
    std::vector<VtuArray> arrays;
    for (std::size_t at = xml.find("<DataArray"); at != std::string::npos;
         at = xml.find("<DataArray", at + 1)) {
        const auto value = [&](const std::string& key) {
            const std::size_t from = xml.find(key + "=\"", at) + key.size() + 2;
            return xml.substr(from, xml.find('"', from) - from);
        };
        const std::size_t place = begin + std::stoul(value("offset"));
        std::uint64_t size = 0;
        std::memcpy(&size, text.data() + place, sizeof size);
        const auto* first = reinterpret_cast<const std::byte*>(text.data() + place + sizeof size);
        arrays.push_back({value("Name"),
                          std::stoi(value("NumberOfComponents")),
                          {first, first + std::ptrdiff_t(size)}});
    }
    return arrays;
}

// Every field has a value for every point, every cell points that there are.
void expect_sound_vtu(const std::string& text, const json& result) {
    const std::size_t nodes = result["nodes"], elements = result["elements"];
    EXPECT_NE(text.find("NumberOfPoints=\"" + std::to_string(nodes) + "\""), std::string::npos);
    EXPECT_NE(text.find("NumberOfCells=\"" + std::to_string(elements) + "\""), std::string::npos);
    EXPECT_TRUE(text.ends_with("</AppendedData>\n</VTKFile>\n"));
    std::size_t corners = 0;
    for (const VtuArray& array : arrays_of(text)) {
        const std::size_t words = array.bytes.size() / 4;
        if (array.name == "connectivity") {
            corners = words;
            for (std::size_t i = 0; i < words; ++i) {
                int point = 0;
                std::memcpy(&point, array.bytes.data() + 4 * i, 4);
                ASSERT_LT(std::size_t(point), nodes);
            }
        } else if (array.name == "offsets") {
            std::int64_t last = 0;
            ASSERT_EQ(array.bytes.size(), 8 * elements);
            std::memcpy(&last, array.bytes.data() + 8 * (elements - 1), 8);
            EXPECT_EQ(std::size_t(last), corners);
        } else if (array.name == "types") {
            EXPECT_EQ(array.bytes.size(), elements);
        } else {
            EXPECT_EQ(words, nodes * std::size_t(array.components)) << array.name;
        }
        EXPECT_TRUE(array.name != "stress_mpa" || array.components == 6);
    }
}

TEST(Stress, WritesAValueForEveryPoint) {
    const Folder folder;
    for (const std::string more : {"", " --elements pixels --h 1"}) {
        const json result = stress(example("bracket") + more + " -o " + (folder / "a.vtu"));
        expect_sound_vtu(test::content(folder / "a.vtu"), result);
    }
}

// Turned by a quarter, mirrored and moved, the work stays.
TEST(Stress, DoesNotCareForThePlacing) {
    const Folder folder;
    const auto strip = [&](const std::string& name, const std::string& corners,
                           const std::string& support, const std::string& load) {
        return folder.write(name, "thickness_mm = 1\noutline = " + corners + "\n[[support]]\n" +
                                      support + "\n[[load]]\n" + load);
    };
    const double work =
        stress(strip("a.toml", "[[0,0],[20,0],[20,5],[0,5]]", "from=[0,0]\nto=[0,5]",
                     "from=[20,0]\nto=[20,5]\nforce_n=[1,2]"))["work_n_mm"];
    const double turned =
        stress(strip("b.toml", "[[100,7],[100,27],[95,27],[95,7]]", "from=[100,7]\nto=[95,7]",
                     "from=[100,27]\nto=[95,27]\nforce_n=[-2,1]"))["work_n_mm"];
    const double mirrored =
        stress(strip("c.toml", "[[0,0],[-20,0],[-20,5],[0,5]]", "from=[0,0]\nto=[0,5]",
                     "from=[-20,0]\nto=[-20,5]\nforce_n=[-1,2]"))["work_n_mm"];
    EXPECT_NEAR(turned / work, 1, 1e-4);
    EXPECT_NEAR(mirrored / work, 1, 1e-4);
}

std::string box_stl(double x, double y, double z) {
    std::string text = "solid box\n";
    const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (const auto& face : faces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int k : face)
            text += "vertex " + std::to_string(k % 2 * x) + " " + std::to_string(k / 2 % 2 * y) +
                    " " + std::to_string(k / 4 * z) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

// Timoshenko's cantilever, in space and as the section of the same mesh.
TEST(Stress, OfAMeshBendsLikeABeam) {
    const Folder folder;
    (void)folder.write("box.stl", box_stl(60, 6, 6));
    const std::string head = "model = \"box.stl\"\n[material]\nyoung_mpa = 1000\npoisson = 0\n";
    const double inertia = 6 * 6 * 6 * 6 / 12.0;
    const double known = 60.0 * 60 * 60 / (3 * 1000 * inertia) + 60 / (500 * 36 * 5.0 / 6);
    const json solid = stress(
        folder.write(
            "solid.toml",
            head + "[[support]]\nbox = [[0,0,0],[0,6,6]]\n[[load]]\nbox = [[60,0,0],[60,6,6]]\n"
                   "force_n = [0,0,-1]\n[[probe]]\nat = [30,3,6]\n") +
        " --h 0.5 -o " + (folder / "solid.vtu"));
    expect_sound_vtu(test::content(folder / "solid.vtu"), solid);
    EXPECT_EQ(solid["element"], "hex8");
    EXPECT_NEAR(solid["work_n_mm"], known, 0.01 * known);
    EXPECT_NEAR(solid["probes"][0]["s1"], 30 * 3 / inertia, 0.02 * 30 * 3 / inertia);
    EXPECT_NEAR(solid["reactions"][0]["z_n"], 1, 1e-6);
    const json plane = stress(folder.write(
        "plane.toml",
        head + "[[support]]\nfrom = [0,0]\nto = [0,6]\n[[load]]\nfrom = [60,0]\nto = [60,6]\n"
               "force_n = [0,-1]\n"));
    EXPECT_NEAR(plane["work_n_mm"], known, 0.01 * known);
}

TEST(Stress, RefusesAMeshWithoutAConstantSection) {
    const Folder folder;
    std::string wedge = box_stl(60, 6, 6);
    const std::string corner = "vertex 60.000000 6.000000 6.000000";
    for (std::size_t at = wedge.find(corner); at != std::string::npos; at = wedge.find(corner, at))
        wedge.replace(at, corner.size(), "vertex 60 4 6");
    (void)folder.write("box.stl", wedge);
    const test::Outcome run = beadwork(
        "stress " + folder.write("a.toml",
                                 "model = \"box.stl\"\n[[support]]\nfrom = [0,0]\nto = [0,6]\n"
                                 "[[load]]\nfrom = [0,0]\nto = [0,6]\nforce_n = [0,-1]\n"));
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("a.toml:1: model has no constant section"), std::string::npos)
        << run.err;
}

TEST(Stress, SaysWhatIsWrongInOneLine) {
    const Folder folder;
    const std::string head =
        "thickness_mm = 1\noutline = [[0,0],[20,0],[20,5],[0,5]]\n[[support]]\n";
    const std::string load = "\n[[load]]\nfrom=[20,0]\nto=[20,5]\nforce_n=[1,2]";
    const auto expect = [&](const std::string& text, int status, const std::string& words,
                            const std::string& more = "") {
        const test::Outcome run = beadwork("stress " + folder.write("x.toml", text) + more);
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    };
    expect(head + "from=[0,0]\nto=[0,5]", 3, "load is missing");
    expect(head + "from=[0,0]\nto=[0,0]" + load, 3, "turn about a point");
    expect(head + "from=[0,0]\nto=[0,5]" + load, 5, "after 2 iterations",
           " --elements pixels --h 0.05 --iterations 2");
    expect(head + "from=[0,0]\nto=[0,5]" + load, 4, "--h 1e-06: 1e+08 million elements",
           " --h 1e-6");
    expect(head + "from=[0,0]\nto=[0,5]" + load, 4, "GB; give larger ones",
           " --h 0.002 --elements triangles");
    (void)folder.write("box.stl", box_stl(20, 5, 5));
    const std::string solid = "model = \"box.stl\"\n[[support]]\nbox = [[0,0,0],[0,5,5]]\n";
    const std::string pull = "[[load]]\nbox = [[20,0,0],[20,5,5]]\nforce_n = [0,0,-1]\n";
    expect(solid, 3, "load is missing");
    expect("model = \"box.stl\"\n" + pull, 3, "support is missing");
    expect(solid + "fix = \"x\"\n" + pull, 3, "supports let the part move");
    expect(solid + pull + "[[probe]]\nat = [30,1,1]", 3, "probe[0].at does not touch the part");
    expect(solid + pull + "[[probe]]", 3, "probe[0] has no at = [x, y, z]");
    expect(solid + pull, 5, "after 1 iterations", " --iterations 1");
    expect(solid + pull, 4, "million elements", " --h 0.001");
    expect(solid + pull, 2, "--elements: is for cases of the plane", " --elements triangles");
    expect(solid + pull, 2, "--buckling: is for cases of the plane", " --buckling");
    expect(solid + pull, 2, "--picture", " --picture a.svg");
    EXPECT_EQ(beadwork("stress " + (folder / "none.toml")).status, 3);
    EXPECT_EQ(beadwork("stress").status, 2);
}

}  // namespace
}  // namespace bead

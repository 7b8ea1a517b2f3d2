#include "mesh/three_mf.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "mesh/text.h"
#include "mesh/transform.h"
#include "mesh/unzip.h"

namespace bead {
namespace {

constexpr std::size_t most_xml_bytes = std::size_t{1} << 30U;  // of XML
constexpr std::size_t most_triangles = 50'000'000;             // after all copies are placed
constexpr int most_copies = 100'000;                           // placed objects, empty ones too
constexpr int most_levels = 32;                                // components within components

constexpr std::pair<std::string_view, double> units[] = {
    {"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
    {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000},
};

double unit_of(const pugi::xml_node& model, std::string_view name) {
    const std::string_view unit = model.attribute("unit").as_string("millimeter");
    const auto* const row =
        std::ranges::find(units, unit, &std::pair<std::string_view, double>::first);
    if (row == std::end(units))
        throw Error(fmt::format("{}: unknown unit '{:.20}' of the model", name, unit));
    return row->second;
}

// Attributes of extensions have a prefix that the file may choose: "p:path".
std::string_view extension_value(const pugi::xml_node& node, std::string_view key) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        const std::size_t colon = name.find(':');
        if (colon != std::string_view::npos && name.substr(colon + 1) == key)
            return attribute.value();
    }
    return {};
}

// Where an object is defined.
struct Address {
    std::string part;  // path of the model in the archive
    std::string id;
    bool operator<(const Address& other) const {
        return std::tie(part, id) < std::tie(other.part, other.id);
    }
};

class Package {
  public:
    Package(std::string_view bytes, std::string_view name);
    ParsedMesh build();

  private:
    [[noreturn]] void fail(std::string_view what) const {
        throw Error(fmt::format("{}: {}", name_, what));
    }
    [[nodiscard]] std::string root_part() const;
    void index_objects(const std::string& part);
    [[nodiscard]] Address target(const pugi::xml_node& reference, const std::string& part) const;
    [[nodiscard]] Transform transform_of(const pugi::xml_node& reference) const;
    void place(const Address& address, const Transform& transform, int level);
    void place_mesh(const pugi::xml_node& node, const Transform& transform);
    [[nodiscard]] double coordinate(const pugi::xml_node& vertex, const char* key) const;
    [[nodiscard]] int corner(const pugi::xml_node& triangle, const char* key,
                             std::size_t points) const;

    std::string name_;
    std::map<std::string, std::string> files_;
    std::map<std::string, pugi::xml_document> models_;
    std::map<Address, pugi::xml_node> objects_;
    Mesh mesh_;
    int copies_ = 0;
};

Package::Package(std::string_view bytes, std::string_view name)
    : name_(name), files_(unzipped(bytes, name, most_xml_bytes, [](std::string_view path) {
          return path.ends_with(".model") || path == "_rels/.rels";
      })) {
    for (auto& [part, text] : files_) {
        if (!part.ends_with(".model")) continue;
        const auto result = models_[part].load_buffer_inplace(
            text.data(), text.size(), pugi::parse_minimal | pugi::parse_escapes);
        if (!result)
            fail(fmt::format("{}: broken XML at byte {}: {}", part, result.offset,
                             result.description()));
        index_objects(part);
    }
}

void Package::index_objects(const std::string& part) {
    const pugi::xml_node resources = models_[part].child("model").child("resources");
    for (const pugi::xml_node& object : resources.children("object"))
        objects_.emplace(Address{part, object.attribute("id").value()}, object);
}

// The archive's relations name the model to start from.
std::string Package::root_part() const {
    pugi::xml_document relations;
    if (const auto file = files_.find("_rels/.rels"); file != files_.end())
        relations.load_buffer(file->second.data(), file->second.size());
    std::string part = "3D/3dmodel.model";
    for (const pugi::xml_node& relation : relations.child("Relationships").children())
        if (std::string_view(relation.attribute("Type").value()).ends_with("/3dmodel"))
            part = relation.attribute("Target").value();
    return part.substr(std::min(part.find_first_not_of('/'), part.size()));
}

Address Package::target(const pugi::xml_node& reference, const std::string& part) const {
    std::string_view path = extension_value(reference, "path");
    if (path.starts_with('/')) path.remove_prefix(1);
    return {path.empty() ? part : std::string(path), reference.attribute("objectid").value()};
}

Transform Package::transform_of(const pugi::xml_node& reference) const {
    const std::string_view text = reference.attribute("transform").value();
    if (text.empty()) return {};
    std::array<double, 12> m{};
    Words words(text);
    for (double& value : m) {
        const auto parsed = number(words.next());
        if (!parsed) fail(fmt::format("a transform needs twelve numbers, got '{:.60}'", text));
        value = *parsed;
    }
    return {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
}

double Package::coordinate(const pugi::xml_node& vertex, const char* key) const {
    const std::string_view word = vertex.attribute(key).value();
    const auto value = number(word);
    if (!value) fail(fmt::format("expected a coordinate {}, got '{:.20}'", key, word));
    return *value;
}

int Package::corner(const pugi::xml_node& triangle, const char* key, std::size_t points) const {
    const std::string_view word = triangle.attribute(key).value();
    std::size_t index = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (fault != std::errc{} || end != word.data() + word.size() || index >= points)
        fail(fmt::format("a triangle refers to point '{:.20}', but there are only {}", word,
                         points));
    return static_cast<int>(index);
}

void Package::place_mesh(const pugi::xml_node& node, const Transform& transform) {
    const int first = static_cast<int>(mesh_.points.size());
    for (const pugi::xml_node& vertex : node.child("vertices").children("vertex"))
        mesh_.points.push_back(transform.of(
            {coordinate(vertex, "x"), coordinate(vertex, "y"), coordinate(vertex, "z")}));
    const std::size_t points = mesh_.points.size() - static_cast<std::size_t>(first);
    const bool mirrored = transform.determinant() < 0;
    for (const pugi::xml_node& triangle : node.child("triangles").children("triangle")) {
        const int a = first + corner(triangle, "v1", points);
        const int b = first + corner(triangle, "v2", points);
        const int c = first + corner(triangle, "v3", points);
        mesh_.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    }
    if (std::max(mesh_.points.size(), mesh_.triangles.size()) > most_triangles)
        fail(fmt::format("more than {} triangles once all copies are placed", most_triangles));
}

void Package::place(const Address& address, const Transform& transform, int level) {
    if (level > most_levels)
        fail(fmt::format("object {:.20}: components refer to each other in a circle", address.id));
    if (++copies_ > most_copies) fail(fmt::format("places more than {} objects", most_copies));
    const auto found = objects_.find(address);
    if (found == objects_.end())
        fail(fmt::format("object '{:.20}' is placed but not defined", address.id));
    const pugi::xml_node& object = found->second;
    if (std::string_view(object.attribute("type").value()) == "other") return;
    place_mesh(object.child("mesh"), transform);
    for (const pugi::xml_node& component : object.child("components").children("component"))
        place(target(component, address.part), transform.after(transform_of(component)), level + 1);
}

ParsedMesh Package::build() {
    const std::string part = root_part();
    const auto document = models_.find(part);
    if (document == models_.end()) fail("holds no 3D model; is it a 3MF file?");
    const pugi::xml_node model = document->second.child("model");
    const pugi::xml_node items = model.child("build");
    if (items.child("item").empty()) fail("its build section places no object");
    for (const pugi::xml_node& item : items.children("item"))
        if (std::string_view(item.attribute("printable").value()) != "0")
            place(target(item, part), transform_of(item), 0);
    return {std::move(mesh_), unit_of(model, name_)};
}

}  // namespace

ParsedMesh parse_three_mf(std::string_view bytes, std::string_view name) {
    return Package(bytes, name).build();
}

}  // namespace bead

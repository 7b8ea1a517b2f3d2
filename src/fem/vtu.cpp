#include "fem/vtu.h"

#include <bit>
#include <cstdint>
#include <ostream>

namespace bead {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

// Arrays follow the XML as they are in memory, each after its length in bytes.
class Appended {
  public:
    explicit Appended(std::ostream& out) : out_(out) {}

    void announce(const std::string& type, const std::string& name, int components,
                  std::size_t bytes) {
        out_ << "        <DataArray type=\"" << type << "\" Name=\"" << name
             << "\" NumberOfComponents=\"" << components << "\" format=\"appended\" offset=\""
             << offset_ << "\"/>\n";
        offset_ += sizeof(std::uint64_t) + bytes;
    }
    template <class T>
    void append(const std::vector<T>& values) {
        const std::uint64_t bytes = values.size() * sizeof(T);
        out_.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);
        out_.write(reinterpret_cast<const char*>(values.data()), std::streamsize(bytes));
    }

  private:
    std::ostream& out_;
    std::uint64_t offset_ = 0;
};

}  // namespace

VtuMesh vtu_mesh(const PlaneMesh& mesh) {
    VtuMesh result;
    for (const Vec2 p : mesh.nodes) {
        result.points.push_back(float(p.x));
        result.points.push_back(float(p.y));
        result.points.push_back(0);
    }
    result.cells = mesh.elements;
    result.points_per_cell = nodes_of(mesh.kind);
    result.type = mesh.kind == PlaneElement::t6 ? 22 : mesh.kind == PlaneElement::q8 ? 23 : 9;
    return result;
}

void write_vtu(std::ostream& out, const VtuMesh& mesh, const std::vector<VtuField>& fields) {
    const std::size_t count = mesh.cells.size() / std::size_t(mesh.points_per_cell);
    std::vector<std::int64_t> ends;
    for (std::size_t c = 1; c <= count; ++c) ends.push_back(std::int64_t(c) * mesh.points_per_cell);
    const std::vector<std::uint8_t> types(count, std::uint8_t(mesh.type));
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n"
        << "    <Piece NumberOfPoints=\"" << mesh.points.size() / 3 << "\" NumberOfCells=\""
        << count << "\">\n      <PointData>\n";
    Appended data(out);
    for (const VtuField& field : fields)
        data.announce("Float32", field.name, field.components, field.values.size() * sizeof(float));
    out << "      </PointData>\n      <Points>\n";
    data.announce("Float32", "Points", 3, mesh.points.size() * sizeof(float));
    out << "      </Points>\n      <Cells>\n";
    data.announce("Int32", "connectivity", 1, mesh.cells.size() * sizeof(int));
    data.announce("Int64", "offsets", 1, ends.size() * sizeof(std::int64_t));
    data.announce("UInt8", "types", 1, types.size());
    out << "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData "
           "encoding=\"raw\">\n_";
    for (const VtuField& field : fields) data.append(field.values);
    data.append(mesh.points);
    data.append(mesh.cells);
    data.append(ends);
    data.append(types);
    out << "\n  </AppendedData>\n</VTKFile>\n";
}

}  // namespace bead

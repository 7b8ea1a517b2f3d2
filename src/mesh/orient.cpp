#include "mesh/orient.h"

#include <algorithm>
#include <utility>

#include "mesh/facet.h"

namespace bead {
namespace {

// Per side of each triangle: the triangle beyond it (-1: none or several) and whether the two
// agree.
struct Beyond {
    int triangle = -1;
    bool agrees = true;
};

std::vector<Beyond> neighbours(const Mesh& mesh, std::span<const Side> sides) {
    std::vector<Beyond> beyond(3 * mesh.triangles.size());
    for_each_edge(sides, [&](std::span<const Side> edge) {
        if (edge.size() != 2) return;
        const bool agree = edge[0].rising != edge[1].rising;
        beyond[static_cast<std::size_t>(edge[0].index)] = {edge[1].index / 3, agree};
        beyond[static_cast<std::size_t>(edge[1].index)] = {edge[0].index / 3, agree};
    });
    return beyond;
}

enum class Turn : char { unknown, kept, flipped };

Turn other(Turn turn) { return turn == Turn::kept ? Turn::flipped : Turn::kept; }

// Goes through the piece that `seed` belongs to and gives every triangle its turn.
void settle(const Mesh& mesh, const std::vector<Beyond>& beyond, std::size_t seed,
            std::vector<Turn>& turns) {
    std::vector<std::size_t> piece{seed};
    turns[seed] = Turn::kept;
    double kept_area = 0;
    double flipped_area = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const std::size_t t = piece[i];
        (turns[t] == Turn::kept ? kept_area : flipped_area) +=
            length(facet_normal(mesh, mesh.triangles[t]));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [triangle, agrees] = beyond[3 * t + k];
            if (triangle < 0 || turns[static_cast<std::size_t>(triangle)] != Turn::unknown)
                continue;
            turns[static_cast<std::size_t>(triangle)] = agrees ? turns[t] : other(turns[t]);
            piece.push_back(static_cast<std::size_t>(triangle));
        }
    }
    if (flipped_area > kept_area)
        for (const std::size_t t : piece) turns[t] = other(turns[t]);
}

bool all_agree(std::span<const Side> sides) {
    bool agree = true;
    for_each_edge(sides, [&](std::span<const Side> edge) {
        if (edge.size() == 2 && edge[0].rising == edge[1].rising) agree = false;
    });
    return agree;
}

}  // namespace

std::optional<Mesh> reoriented(const Mesh& mesh, std::span<const Side> sides) {
    if (all_agree(sides)) return std::nullopt;
    const std::vector<Beyond> beyond = neighbours(mesh, sides);
    std::vector<Turn> turns(mesh.triangles.size(), Turn::unknown);
    for (std::size_t t = 0; t < turns.size(); ++t)
        if (turns[t] == Turn::unknown) settle(mesh, beyond, t, turns);

    Mesh result = mesh;
    for (std::size_t t = 0; t < turns.size(); ++t)
        if (turns[t] == Turn::flipped) std::swap(result.triangles[t][1], result.triangles[t][2]);
    return result;
}

}  // namespace bead

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fabrication/fabricate.h"

#include "core/error.h"
#include "core/parallel.h"
#include "fabrication/add_solid.h"
#include "fabrication/level_surface.h"
#include "fabrication/shells.h"
#include "fabrication/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <numeric>

namespace scree {

namespace {

// The distances must be exact within this many cells of the surface: a cell's diagonal and a bit.
constexpr float margin = 1.75F;
// About 8 KiB per block for its values and its share of the surface and the mesh.
constexpr std::size_t bytes_per_block = 8192;
// In cells. With larger coordinates, vertices a fiftieth of a cell apart could become equal when
// rounded to 32 bits in metres or millimetres.
constexpr double farthest_cell = 30'000;
// In cells. The time grows with its cube.
constexpr double widest_bridge = 16;

std::size_t available_memory() {
    std::ifstream in("/proc/meminfo");
    for (std::string word; in >> word;)
        if (std::size_t kib = 0; word == "MemAvailable:" && in >> kib)
            return kib << 10;
    return std::size_t{4} << 30;
}

std::string length_text(double metres) { return fmt::format("{:.4g} mm", metres * 1000); }

class Fabricator {
  public:
    Fabricator(std::vector<Solid> solids, const FabricationOptions& options, const Context& context)
        : solids_(std::move(solids)), options_(options), context_(context),
          memory_(options.memory > 0 ? options.memory : available_memory()) {
        choose_resolution();
    }

    Fabrication run() {
        const double reach = options_.bridge / cell_;
        LevelSurface surface = unite(reach);
        if (reach > 0)
            surface = erode(surface, reach);
        context_.check_cancel();
        if (surface.triangles.empty())
            throw Error(fmt::format("nothing is left at a resolution of {}: the components are "
                                    "thinner",
                                    length_text(cell_)));
        return select(surface);
    }

  private:
    void choose_resolution() {
        if (solids_.empty())
            throw Error("there is no closed component to make a solid of");
        const double thin = thinnest(solids_);
        cell_ = options_.resolution > 0 ? options_.resolution : thin / 10;
        if (!(cell_ > 0))
            throw Error("a component has no thickness, so no resolution follows from it");
        if (farthest(solids_) > farthest_cell * cell_)
            throw Error(fmt::format("a resolution of {} is too fine for a scene that reaches {} "
                                    "from its origin; expected at least {}",
                                    length_text(cell_), length_text(farthest(solids_)),
                                    length_text(farthest(solids_) / farthest_cell)));
        if (options_.bridge > widest_bridge * cell_)
            throw Error(fmt::format("a bridge of {} is too wide for a resolution of {}; expected "
                                    "at most {} times it",
                                    length_text(options_.bridge), length_text(cell_),
                                    widest_bridge));
    }

    [[noreturn]] void out_of_memory() const {
        throw Error(Fault::resource,
                    {Diagnostic{{},
                                "",
                                fmt::format("a solid at a resolution of {} needs more than the "
                                            "{:.1f} GiB of memory that are available",
                                            length_text(cell_), double(memory_) / 0x1p30),
                                fmt::format("expected a coarser one, such as {}",
                                            length_text(2 * cell_))}});
    }

    // The surface at a distance of `reach` cells from the union.
    LevelSurface unite(double reach) {
        DistanceField field(margin, float(reach) + margin, memory_ / bytes_per_block);
        std::atomic<bool> room = true;
        std::atomic<std::size_t> done = 0;
        std::mutex reporting;
        parallel_for(solids_.size(), 1, [&](std::size_t s) {
            context_.check_cancel();
            if (room && !add(field, solids_[s]))
                room = false;
            ++done;
            if (const std::unique_lock lock(reporting, std::try_to_lock); lock.owns_lock())
                context_.report("unite", double(done) / double(solids_.size()));
        });
        if (!room)
            out_of_memory();
        return level_surface(field, reach);
    }

    bool add(DistanceField& field, const Solid& solid) const {
        std::vector<Imath::V3d> positions;
        positions.reserve(solid.mesh->positions.size());
        for (const Vec3& p : solid.mesh->positions)
            positions.push_back(Imath::V3d(p) * solid.world_from_object / cell_);
        return add_solid(field, positions, solid.mesh->triangles);
    }

    LevelSurface erode(const LevelSurface& dilated, double reach) const {
        context_.check_cancel();
        context_.report("bridge", 0.5);
        DistanceField field(float(reach) + margin, margin, memory_ / bytes_per_block);
        if (!add_solid(field, dilated.positions, dilated.triangles))
            out_of_memory();
        return level_surface(field, -reach);
    }

    double in_metres(double cells) const { return cells * cell_ * cell_ * cell_; }

    // A body inside a void disappears when the void is filled.
    bool is_part(const Shell& shell) const {
        return !shell.is_void() && (options_.keep_voids || shell.parent == Shell::none);
    }

    Fabrication select(const LevelSurface& surface) const {
        const Shells shells = find_shells(surface);
        std::vector<FabricationPart> of_shell(shells.list.size());
        std::vector<std::uint32_t> order;
        for (std::uint32_t s = 0; s < shells.list.size(); ++s) {
            const Shell& shell = shells.list[s];
            if (is_part(shell))
                order.push_back(s);
            const bool kept_void = shell.is_void() && options_.keep_voids;
            if (!is_part(shell) && !kept_void)
                continue;
            FabricationPart& part = of_shell[kept_void ? shell.parent : s];
            part.volume += in_metres(shell.volume);
            part.triangles += shell.triangles;
        }
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return of_shell[a].volume > of_shell[b].volume;
        });

        Fabrication out;
        out.resolution = cell_;
        out.solids = solids_.size();
        out.voids_kept = options_.keep_voids;
        std::vector<bool> keep(shells.list.size());
        for (const std::uint32_t s : order) {
            keep[s] = options_.keep_parts || s == order.front();
            (keep[s] ? out.parts : out.removed).push_back(of_shell[s]);
        }
        for (std::size_t s = 0; s < shells.list.size(); ++s) {
            const Shell& shell = shells.list[s];
            if (!shell.is_void() || !keep[shell.parent])
                continue;
            keep[s] = options_.keep_voids;
            ++out.voids;
            out.void_volume -= in_metres(shell.volume);
        }
        out.mesh = kept_mesh(surface, shells, keep);
        return out;
    }

    Mesh kept_mesh(const LevelSurface& surface, const Shells& shells,
                   const std::vector<bool>& keep) const {
        Mesh mesh;
        std::vector<std::uint32_t> index(surface.positions.size());
        for (std::size_t v = 0; v < index.size(); ++v)
            if (keep[shells.of_vertex[v]]) {
                index[v] = std::uint32_t(mesh.positions.size());
                mesh.positions.emplace_back(surface.positions[v] * cell_);
            }
        for (const Mesh::Triangle& t : surface.triangles)
            if (keep[shells.of_vertex[t[0]]])
                mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
        return mesh;
    }

    std::vector<Solid> solids_;
    const FabricationOptions& options_;
    const Context& context_;
    std::size_t memory_;
    double cell_ = 0; // [m]
};

} // namespace

Fabrication fabricate(std::span<const Aggregate> aggregates, const FabricationOptions& options,
                      const Context& context) {
    return Fabricator(closed_solids(aggregates), options, context).run();
}

} // namespace scree

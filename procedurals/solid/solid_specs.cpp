// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/solid_specs.h"

#include "core/random.h"
#include "model/procedural.h"

#include <cmath>

namespace scree {

namespace {

// The paper's lattice has 64 cells along an edge (R = 6), the unit of its k.
constexpr double paper_cells = 64;

using Rows = std::array<Vec3, 3>;

/// A uniformly distributed rotation, by a unit quaternion (Shoemake 1992; Arvo 1992).
Rows any_turn(Random& random) {
    const double u = random.uniform(), a = random.uniform(0, 2 * std::numbers::pi),
                 b = random.uniform(0, 2 * std::numbers::pi);
    const double x = std::sqrt(1 - u) * std::sin(a), y = std::sqrt(1 - u) * std::cos(a),
                 z = std::sqrt(u) * std::sin(b), w = std::sqrt(u) * std::cos(b);
    const auto row = [](double p, double q, double r) {
        return Vec3(static_cast<float>(p), static_cast<float>(q), static_cast<float>(r));
    };
    return {row(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            row(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            row(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y))};
}

} // namespace

std::vector<ParamSpec> solid_specs(std::vector<ParamSpec> specs) {
    std::vector<ParamSpec> shared = {
        {.name = "size",
         .type = ParamType::number,
         .doc = "Side of the fractal lattice's cube, which scales the whole texture.",
         .unit = "m",
         .fallback = 0.1,
         .min = 1e-4,
         .max = 1e4},
        {.name = "axis",
         .type = ParamType::vector3,
         .doc =
             "Normal of the layers of stone, or direction of the trunk, along which the grain of "
             "wood runs, in the object's frame: {1, 0, 0} for boards along x.",
         .fallback = Vec3(0, 1, 0)},
        {.name = "origin",
         .type = ParamType::vector3,
         .doc = "Position of the texture's origin in the object's frame.",
         .unit = "m",
         .fallback = Vec3(0, 0, 0)},
        {.name = "decay",
         .type = ParamType::number,
         .doc =
             "beta: the amplitude of each level of the fractal is exp(-beta) times that of the one "
             "before; low values are rough.",
         .fallback = 0.8,
         .min = 0.0,
         .max = 4.0},
        {.name = "levels",
         .type = ParamType::integer,
         .doc = "R: number of stored levels of the fractal, which take (2^R + 1)^3 numbers.",
         .fallback = std::int64_t{7},
         .min = 0.0,
         .max = 8.0},
        {.name = "detail",
         .type = ParamType::integer,
         .doc = "Further levels, evaluated only where the picture resolves them.",
         .fallback = std::int64_t{4},
         .min = 0.0,
         .max = 12.0},
        {.name = "precision",
         .type = ParamType::choice,
         .doc = "Type of the stored numbers: 16 bits take half the memory, floats are exact.",
         .fallback = std::string("16 bit"),
         .choices = {"16 bit", "32 bit"}},
        {.name = "repeats",
         .type = ParamType::boolean,
         .doc = "The fractal is periodic with `size`; otherwise it never repeats, and is slower "
                "outside its first cube.",
         .fallback = true},
        {.name = "filtered",
         .type = ParamType::boolean,
         .doc = "Filters over the pixel; otherwise evaluates points, which alias, as in 1987.",
         .fallback = true},
        {.name = "vary",
         .type = ParamType::boolean,
         .doc =
             "Every instance of a generator, and every object, uses another part of the texture.",
         .fallback = false},
        scale_with_object_spec(),
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed gives another piece of the same material.",
         .fallback = std::int64_t{1},
         .min = 0.0},
    };
    for (ParamSpec& spec : shared)
        specs.push_back(std::move(spec));
    return specs;
}

std::shared_ptr<const FractalLattice> make_lattice(const Params& params) {
    LatticeSettings settings;
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    settings.levels = static_cast<int>(params.integer("levels"));
    settings.detail = static_cast<int>(params.integer("detail"));
    settings.decay = params.number("decay");
    settings.repeats = params.flag("repeats");
    settings.sixteen_bit = params.text("precision") == "16 bit";
    return std::make_shared<FractalLattice>(settings);
}

SolidFrame solid_frame(const Params& params) {
    const Vec3& given = params.vector3("axis");
    if (!(given.length() > 0))
        throw params.error("axis", "has no direction", "for example {0, 1, 0}");
    const Vec3 axis = given.normalized();
    // For the default axis y, right is z and up is x, so the frame is right-handed.
    const Vec3 helper = std::abs(axis.x) < 0.9F ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    const Vec3 right = helper.cross(axis).normalized();
    return {right, axis.cross(right), axis, params.vector3("origin")};
}

solid::Placement placement(const Params& params, const SolidFrame& frame, unsigned use,
                           double scale, double stretch) {
    const double size = params.number("size") * scale;
    Rows rows{frame.right, frame.up, frame.axis};
    Vec3 offset(0.0F);
    rows[2] /= static_cast<float>(stretch);
    if (use > 0) {
        Random random(static_cast<std::uint64_t>(params.integer("seed")), Purpose::solid_place,
                      use);
        const Rows turn = any_turn(random);
        const Rows plain = rows;
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(i);
            rows[at] = plain[0] * turn[at].x + plain[1] * turn[at].y + plain[2] * turn[at].z;
            offset[i] = static_cast<float>(random.uniform());
        }
    }
    solid::Placement placed{};
    for (std::size_t i = 0; i < 3; ++i) {
        rows[i] /= static_cast<float>(size);
        placed.rows[i] = as_triple(rows[i]);
        offset[static_cast<int>(i)] -= rows[i].dot(frame.origin);
    }
    placed.offset = as_triple(offset);
    placed.vary = params.flag("vary") ? 1.0F : 0.0F;
    return placed;
}

double cell_length(const Params& params) { return params.number("size") / paper_cells; }

ParamSpec preset_number(std::string name, std::string doc, std::string unit, double min,
                        double max) {
    return optional_number_spec(std::move(name), std::move(doc), std::move(unit), min, max);
}

ParamSpec preset_color(std::string name, std::string doc) {
    return {
        .name = std::move(name), .type = ParamType::color, .doc = std::move(doc), .optional = true};
}

} // namespace scree

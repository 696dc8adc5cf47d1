// SPDX-License-Identifier: GPL-3.0-or-later
// Vectorised computation of the lattice's nodes, row by row. Each level is computed from the
// previous one into a separate array, plane by plane. Even and odd nodes of a row are kept in
// separate arrays, so that the neighbours of consecutive nodes are contiguous, and are interleaved
// when the row is written.
#include "procedurals/solid/lattice/large_array.h"
#include "procedurals/solid/lattice/lattice_nodes.h"
#include "procedurals/solid/lattice/vector_path.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedurals/solid/lattice/lattice_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedurals/solid/lattice/normal_variates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scree::HWY_NAMESPACE {

using solid::Lattice;

#if HWY_TARGET == HWY_SCALAR // no vector instructions

void make_floats(const Lattice& header, float* nodes) { make_nodes_plainly(header, nodes); }
void make_shorts(Lattice& header, std::int16_t* nodes) { make_nodes_plainly(header, nodes); }

#else

using Reals = hn::ScalableTag<float>;
using Words = hn::RebindToUnsigned<Reals>;

/// The nodes of a row with even and with odd x.
struct Row {
    const float* even = nullptr;
    const float* odd = nullptr;
};

struct Plane {
    std::vector<float> memory;
    std::vector<Row> rows;
};

/// Computes the planes of one level from the previous level.
class LevelPlanes {
  public:
    LevelPlanes(const Lattice& lattice, int level, const float* coarse)
        : lattice_(lattice), level_(level), cells_(std::size_t(1) << (level - 1)), coarse_(coarse),
          mask_(solid::node_mask(&lattice, level)),
          pitch_((cells_ / hn::Lanes(Reals()) + 2) * hn::Lanes(Reals())) {}

    std::size_t size() const { return 2 * cells_ + 1; }
    std::size_t cells() const { return cells_; }

    Plane make_empty() const {
        return {std::vector<float>(2 * pitch_ * size()), std::vector<Row>(size())};
    }

    /// A plane with even z, which the previous level has too.
    void make_even(std::size_t z, Plane& plane) const {
        const float* coarse = coarse_ + z / 2 * (cells_ + 1) * (cells_ + 1);
        for (std::size_t y = 0; y < size(); y += 2) {
            const float* even = coarse + y / 2 * (cells_ + 1);
            float* odd = plane.memory.data() + (2 * y + 1) * pitch_;
            draw_odd(row_bits(y, z), odd);
            add_mean<2>({even, even + 1}, odd);
            plane.rows[y] = {even, odd};
        }
        for (std::size_t y = 1; y < size(); y += 2) {
            const auto [near, far] = std::pair(plane.rows[y - 1], plane.rows[y + 1]);
            const auto [even, odd] = draw(plane, y, z);
            add_mean_to_ends<2>({near.even, far.even}, even);
            add_mean<4>({even, even + 1, near.odd, far.odd}, odd);
        }
    }

    /// The plane with odd z between two of these.
    void make_odd(std::size_t z, const Plane& before, const Plane& after, Plane& plane) const {
        for (std::size_t y = 0; y < size(); y += 2) {
            const auto [low, high] = std::pair(before.rows[y], after.rows[y]);
            const auto [even, odd] = draw(plane, y, z);
            add_mean_to_ends<2>({low.even, high.even}, even);
            add_mean<4>({even, even + 1, low.odd, high.odd}, odd);
        }
        for (std::size_t y = 1; y < size(); y += 2) {
            const auto [near, far] = std::pair(plane.rows[y - 1], plane.rows[y + 1]);
            const auto [low, high] = std::pair(before.rows[y], after.rows[y]);
            const auto [even, odd] = draw(plane, y, z);
            add_mean_to_ends<4>({near.even, far.even, low.even, high.even}, even);
            add_mean<6>({even, even + 1, near.odd, far.odd, low.odd, high.odd}, odd);
        }
    }

  private:
    std::uint32_t row_bits(std::size_t y, std::size_t z) const {
        return solid::row_bits(
            lattice_.key_a, static_cast<std::uint32_t>(solid::source_level(&lattice_, level_)),
            static_cast<std::uint32_t>(y) & mask_, static_cast<std::uint32_t>(z) & mask_);
    }

    /// Writes the variates of a row to where its nodes will be stored.
    std::pair<float*, float*> draw(Plane& plane, std::size_t y, std::size_t z) const {
        float* even = plane.memory.data() + 2 * y * pitch_;
        float* odd = even + pitch_;
        const std::uint32_t row = row_bits(y, z);
        const std::uint32_t other = solid::scramble(row + lattice_.key_b);
        draw<2>(row, other, {even, odd});
        const auto last =
            static_cast<std::uint32_t>(2 * cells_); // one more than the number of cells
        even[cells_] = lattice_.repeats != 0
                           ? even[0]
                           : solid::normal_variate(solid::node_bits(row, other, last));
        plane.rows[y] = {even, odd};
        return {even, odd};
    }

    void draw_odd(std::uint32_t row, float* odd) const {
        draw<1>(row + 0x9e3779b1U, solid::scramble(row + lattice_.key_b), {odd});
    }

    /// Writes variates from x = 0: those of x = 0, 2, ... to the first place, of x = 1, 3, ... to
    /// the second.
    template <std::size_t places>
    HWY_INLINE void draw(std::uint32_t row, std::uint32_t other_bits,
                         const std::array<float*, places>& to) const {
        const Reals d;
        const Words du;
        const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
        const auto other = hn::Set(du, other_bits);
        const auto next = hn::Set(du, 0x9e3779b1U), further = hn::Set(du, 2 * lanes * 0x9e3779b1U);
        auto place =
            hn::Add(hn::Mul(hn::Iota(du, 0), hn::Set(du, 2 * 0x9e3779b1U)), hn::Set(du, row));
        for (std::size_t i = 0; i < cells_; i += lanes, place = hn::Add(place, further)) {
            hn::StoreU(normal_variate(d, node_bits(du, place, other)), d, to[0] + i);
            if constexpr (places == 2)
                hn::StoreU(normal_variate(d, node_bits(du, hn::Add(place, next), other)), d,
                           to[1] + i);
        }
    }

    template <std::size_t sources>
    using From = std::array<const float*, sources>;

    /// Replaces the variates g by the mean of the sources plus g L.
    template <std::size_t sources>
    HWY_INLINE void add_mean(const From<sources>& from, float* nodes) const {
        const Reals d;
        const auto share = hn::Set(d, 1.0F / static_cast<float>(sources));
        const auto amplitude = hn::Set(d, lattice_.amplitude[level_]);
        for (std::size_t i = 0; i < cells_; i += hn::Lanes(d)) {
            auto sum = hn::Add(hn::LoadU(d, from[0] + i), hn::LoadU(d, from[1] + i));
            for (std::size_t pair = 2; pair < sources; pair += 2)
                sum = hn::Add(
                    sum, hn::Add(hn::LoadU(d, from[pair] + i), hn::LoadU(d, from[pair + 1] + i)));
            hn::StoreU(hn::Add(hn::Mul(sum, share), hn::Mul(hn::LoadU(d, nodes + i), amplitude)), d,
                       nodes + i);
        }
    }

    /// The same for a single node.
    template <std::size_t sources>
    HWY_INLINE void add_mean_to_ends(const From<sources>& from, float* nodes) const {
        float sum = from[0][cells_] + from[1][cells_];
        for (std::size_t pair = 2; pair < sources; pair += 2)
            sum += from[pair][cells_] + from[pair + 1][cells_];
        const float last =
            sum * (1.0F / static_cast<float>(sources)) + nodes[cells_] * lattice_.amplitude[level_];
        add_mean(from, nodes);
        nodes[cells_] = last;
    }

    const Lattice& lattice_;
    int level_;
    std::size_t cells_; // of the previous level, per axis
    const float* coarse_;
    std::uint32_t mask_;
    std::size_t pitch_; // distance of the even and the odd nodes of a row
};

/// Interleaves rows unchanged.
struct WriteFloats {
    float* nodes;

    HWY_INLINE void operator()(const Row& row, std::size_t cells) {
        const Reals d;
        for (std::size_t i = 0; i < cells; i += hn::Lanes(d))
            hn::StoreInterleaved2(hn::LoadU(d, row.even + i), hn::LoadU(d, row.odd + i), d,
                                  nodes + 2 * i);
        nodes[2 * cells] = row.even[cells];
        nodes += 2 * cells + 1;
    }
};

HWY_INLINE std::int16_t rounded(float v) {
    const hn::CappedTag<float, 1> d;
    return static_cast<std::int16_t>(hn::GetLane(hn::NearestInt(hn::Set(d, v))));
}

/// Interleaves rows rounded to 16 bits: the odd node is the upper half of a 32-bit word.
struct WriteShorts {
    std::int16_t* nodes;
    float inverse; // of the step

    HWY_INLINE void operator()(const Row& row, std::size_t cells) {
        const Reals d;
        const hn::RebindToSigned<Reals> di;
        const hn::Repartition<std::int16_t, Reals> d16;
        const auto scale = hn::Set(d, inverse);
        const auto low = hn::Set(di, 0xffff);
        for (std::size_t i = 0; i < cells; i += hn::Lanes(d)) {
            const auto even = hn::NearestInt(hn::Mul(hn::LoadU(d, row.even + i), scale));
            const auto odd = hn::NearestInt(hn::Mul(hn::LoadU(d, row.odd + i), scale));
            hn::StoreU(hn::BitCast(d16, hn::Or(hn::And(even, low), hn::ShiftLeft<16>(odd))), d16,
                       nodes + 2 * i);
        }
        nodes[2 * cells] = rounded(row.even[cells] * inverse);
        nodes += 2 * cells + 1;
    }
};

/// Computes a level from the previous one and passes its rows to `write`, in order.
template <class Write>
void make_level(const Lattice& lattice, int level, const float* coarse, Write write) {
    const LevelPlanes planes(lattice, level, coarse);
    const auto write_plane = [&](const Plane& plane) {
        for (const Row& row : plane.rows)
            write(row, planes.cells());
    };
    Plane before = planes.make_empty(), between = planes.make_empty(), after = planes.make_empty();
    planes.make_even(0, before);
    write_plane(before);
    for (std::size_t z = 2; z < planes.size(); z += 2) {
        planes.make_even(z, after);
        planes.make_odd(z - 1, before, after, between);
        write_plane(between);
        write_plane(after);
        std::swap(before, after);
    }
}

/// All levels up to `last`, at least the corners, as floats.
LargeArray<float> levels_up_to(const Lattice& header, int last) {
    LargeArray<float> nodes = large_array<float>(8 + node_padding);
    for (std::uint32_t corner = 0; corner < 8; ++corner)
        nodes[corner] = corner_node(header, corner & 1, (corner >> 1) & 1, corner >> 2);
    for (int level = 1; level <= last; ++level) {
        LargeArray<float> finer = large_array<float>(node_count(level) + node_padding);
        make_level(header, level, nodes.get(), WriteFloats{finer.get()});
        nodes = std::move(finer);
    }
    return nodes;
}

void make_floats(const Lattice& header, float* nodes) {
    const auto coarse = levels_up_to(header, header.levels - 1);
    if (header.levels > 0)
        make_level(header, header.levels, coarse.get(), WriteFloats{nodes});
    else
        std::copy_n(coarse.get(), 8, nodes);
}

float largest_of(const float* nodes, std::size_t count) {
    const Reals d;
    const std::size_t lanes = hn::Lanes(d), whole = count / lanes * lanes;
    auto largest = hn::Zero(d);
    for (std::size_t i = 0; i < whole; i += lanes)
        largest = hn::Max(largest, hn::Abs(hn::LoadU(d, nodes + i)));
    float found = hn::GetLane(hn::MaxOfLanes(d, largest));
    for (std::size_t i = whole; i < count; ++i)
        found = std::fmax(found, std::fabs(nodes[i]));
    return found;
}

void make_shorts(Lattice& header, std::int16_t* nodes) {
    const int before = std::max(header.levels - 1, 0);
    const auto coarse = levels_up_to(header, before);
    header.step = step_of_nodes(header, largest_of(coarse.get(), node_count(before)));
    const float inverse = 1 / header.step;
    if (header.levels > 0)
        make_level(header, header.levels, coarse.get(), WriteShorts{nodes, inverse});
    else
        for (std::size_t i = 0; i < 8; ++i)
            nodes[i] = rounded(coarse[i] * inverse);
}

#endif

} // namespace scree::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scree {

HWY_EXPORT(make_floats);
HWY_EXPORT(make_shorts);

void make_nodes(const solid::Lattice& header, float* nodes) {
    scalar_path_in_use() ? make_nodes_plainly(header, nodes)
                         : HWY_DYNAMIC_DISPATCH(make_floats)(header, nodes);
}

void make_nodes(solid::Lattice& header, std::int16_t* nodes) {
    scalar_path_in_use() ? make_nodes_plainly(header, nodes)
                         : HWY_DYNAMIC_DISPATCH(make_shorts)(header, nodes);
}

} // namespace scree
#endif

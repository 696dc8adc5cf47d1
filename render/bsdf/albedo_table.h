// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <mutex>

namespace scree {

/// Share of light from one direction that a GGX surface reflects in a single bounce, by the cosine
/// of the direction: of a perfect mirror's facets, or of a dielectric's.
class AlbedoTable {
  public:
    AlbedoTable() = default;
    /// `ior` 0: facets that reflect everything.
    AlbedoTable(float alpha, float ior);

    float at(float cosine) const {
        const float position = cosine * (size - 1);
        const int cell = position < size - 2 ? static_cast<int>(position) : size - 2;
        const float part = position - static_cast<float>(cell);
        const auto i = static_cast<unsigned>(cell);
        return values_[i] + (values_[i + 1] - values_[i]) * part;
    }

    /// Its cosine-weighted mean over the hemisphere, exact for what `at` answers.
    float average() const { return average_; }

  private:
    // 64 nodes keep the furnace test of plastics within 0.1%.
    static constexpr int size = 64;
    std::array<float, size> values_{};
    float average_ = 0;
};

/// What a surface's roughness makes of an AlbedoTable: one, or a mean of two. The mean's average is
/// exact, too, so that a white base under a coat loses nothing for being between two tables.
class Albedo {
  public:
    Albedo(const AlbedoTable* table = nullptr) : low_(table) {} // implicit: the common case
    Albedo(const AlbedoTable* low, const AlbedoTable* high, float part)
        : low_(low), high_(high), part_(part) {}

    float at(float cosine) const {
        const float low = low_->at(cosine);
        return part_ > 0 ? low + (high_->at(cosine) - low) * part_ : low;
    }
    float average() const {
        const float low = low_->average();
        return part_ > 0 ? low + (high_->average() - low) * part_ : low;
    }

  private:
    const AlbedoTable* low_;
    const AlbedoTable* high_ = nullptr;
    float part_ = 0;
};

/// The tables of all roughnesses, for surfaces on which it goes by place.
class RoughnessTables {
  public:
    /// `ior` as in AlbedoTable.
    explicit RoughnessTables(float ior) : ior_(ior) {}

    /// `roughness` in [0, 1]; good for as long as this lives. Thread-safe: a table is made when it
    /// is first asked for, which takes milliseconds.
    Albedo at(float roughness) const;

  private:
    // Between so many tables a straight line is within 0.2% of the share reflected.
    static constexpr int steps = 32;
    struct LazyTable {
        std::once_flag made;
        AlbedoTable table;
    };
    const AlbedoTable* table(int step) const;

    float ior_;
    mutable std::array<LazyTable, steps + 1> tables_; // evenly over the roughness
};

} // namespace scree

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <utility>

namespace scree {

/// Share of light from one direction that a GGX surface reflects in a single bounce, by the cosine
/// of the direction: of a perfect mirror's facets, or of a dielectric's.
class AlbedoTable {
  public:
    static constexpr float mirror = 0; // for `ior`: facets that reflect everything

    AlbedoTable() = default;
    /// `ior` of the facets relative to the side of the light, or `mirror`.
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

/// An AlbedoTable, or a mean of two for a roughness between theirs. The mean's average is exact,
/// too, so that a white base under a coat loses no light between two tables.
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

/// The tables of all roughnesses, for surfaces whose roughness changes from place to place.
class RoughnessTables {
  public:
    /// `ior` as in AlbedoTable.
    explicit RoughnessTables(float ior) : ior_(ior) {}

    /// `roughness` in [0, 1]; the answer points into this. Thread-safe: a table is made when it
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

/// The tables of a scene's materials, which share those that are the same. Materials are prepared
/// one after the other: not thread-safe.
class AlbedoTables {
  public:
    const AlbedoTable& at(float alpha, float ior) {
        return tables_.try_emplace({alpha, ior}, alpha, ior).first->second;
    }
    const RoughnessTables& by_roughness(float ior) {
        return by_roughness_.try_emplace(ior, ior).first->second;
    }

  private:
    std::map<std::pair<float, float>, AlbedoTable> tables_; // by (alpha, ior)
    std::map<float, RoughnessTables> by_roughness_;         // by ior
};

} // namespace scree

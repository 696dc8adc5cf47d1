// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/cryptomatte.h"

#include <bit>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace scree {
namespace {

// Values of the published algorithm; the last is one that is no normal float as it is.
TEST(Cryptomatte, IdsAreThoseOfMurmurHash3) {
    EXPECT_EQ(cryptomatte_id("hello"), 0x248bfa47U);
    EXPECT_EQ(cryptomatte_id("hello, world"), 0x149bbb7fU);
    EXPECT_EQ(cryptomatte_id("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
    EXPECT_EQ(cryptomatte_id(""), 0x00800000U);
}

Aggregate two_things(const std::string& generator, const std::string& name) {
    Aggregate aggregate;
    aggregate.generator = generator;
    aggregate.name = name;
    aggregate.prototypes = {{.name = "ball"}, {.name = "box \"x\""}};
    aggregate.instances.resize(2);
    aggregate.instances[1].prototype = 1;
    return aggregate;
}

std::string value_of(const Metadata& metadata, const std::string& ending) {
    for (const auto& [name, value] : metadata)
        if (name.starts_with("cryptomatte/") && name.ends_with(ending))
            return value;
    return {};
}

class CryptomatteLayer : public testing::Test {
  protected:
    CryptomatteLayer() {
        PathSample sample;
        sample.covered = true;
        for (const auto& [instance, material] : {std::pair{3U, 1U}, {2U, 0U}, {3U, 1U}, {0U, 1U}}) {
            sample.instance = instance;
            sample.material = material;
            film.add(1, 0, sample, 1);
        }
        film.add(1, 0, PathSample(), 0);
    }

    Film film{2, 1, WideVec3(0), {.mattes = true}};
    std::vector<Aggregate> aggregates{two_things("pile", ""), two_things("pile", "")};
    std::vector<std::shared_ptr<const Material>> materials{
        std::make_shared<const Material>(Matte{}), std::make_shared<const Material>(Metal{})};
};

// One pixel: 3 of 5 samples on the second item's, 1 on the first's.
TEST_F(CryptomatteLayer, HasTheLargestCoverageFirst) {
    const Cryptomatte matte = make_cryptomatte("crypto_object", film, aggregates, materials);
    ASSERT_EQ(matte.parts.size(), 3U);
    EXPECT_EQ(matte.parts[0].name, "crypto_object00");
    EXPECT_TRUE(matte.parts[0].full_float);
    const float* pixel = matte.parts[0].image.at(1, 0);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(pixel[0]), cryptomatte_id("pile.2"));
    EXPECT_FLOAT_EQ(pixel[1], 0.6F);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(pixel[2]), cryptomatte_id("pile"));
    EXPECT_FLOAT_EQ(pixel[3], 0.2F);
    for (const float value : matte.parts[1].image.pixels)
        EXPECT_EQ(value, 0);
    EXPECT_EQ(matte.parts[0].image.at(0, 0)[0], 0);
}

TEST_F(CryptomatteLayer, NamesAreInTheManifest) {
    const Cryptomatte matte = make_cryptomatte("crypto_instance", film, aggregates, materials);
    EXPECT_EQ(value_of(matte.metadata, "/name"), "crypto_instance");
    EXPECT_EQ(value_of(matte.metadata, "/hash"), "MurmurHash3_32");
    EXPECT_EQ(value_of(matte.metadata, "/conversion"), "uint32_to_float32");
    const auto manifest = nlohmann::json::parse(value_of(matte.metadata, "/manifest"));
    EXPECT_EQ(manifest.size(), 4U);
    for (const auto& [name, id] : manifest.items())
        EXPECT_EQ(std::stoul(id.get<std::string>(), nullptr, 16), cryptomatte_id(name));
    EXPECT_TRUE(manifest.contains("pile.2/box \"x\".2"));
    const float* pixel = matte.parts[0].image.at(1, 0);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(pixel[0]), cryptomatte_id("pile.2/box \"x\".2"));
    EXPECT_FLOAT_EQ(pixel[1], 0.4F);
}

TEST_F(CryptomatteLayer, MaterialsAreNamedByTheirKinds) {
    materials.push_back(std::make_shared<const Material>(Metal{}));
    materials.push_back(materials[1]); // of another prototype
    const Cryptomatte matte = make_cryptomatte("crypto_material", film, aggregates, materials);
    const auto manifest = nlohmann::json::parse(value_of(matte.metadata, "/manifest"));
    EXPECT_EQ(manifest.size(), 3U);
    EXPECT_TRUE(manifest.contains("matte") && manifest.contains("metal") &&
                manifest.contains("metal.2"));
    const float* pixel = matte.parts[0].image.at(1, 0);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(pixel[0]), cryptomatte_id("metal"));
    EXPECT_FLOAT_EQ(pixel[1], 0.6F);
}

TEST_F(CryptomatteLayer, LeavesOutAManifestThatIsTooLong) {
    aggregates[1].instances.resize(20000);
    const Cryptomatte matte = make_cryptomatte("crypto_instance", film, aggregates, materials);
    EXPECT_EQ(value_of(matte.metadata, "/manifest"), "");
    EXPECT_EQ(value_of(matte.metadata, "/name"), "crypto_instance");
}

} // namespace
} // namespace scree

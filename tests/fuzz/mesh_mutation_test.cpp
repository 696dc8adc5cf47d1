// SPDX-License-Identifier: GPL-3.0-or-later
// Small valid mesh files, damaged in thousands of ways that are the same on every run: each must
// either read or be refused with an Error, in bounded time.
#include "tests/fuzz/mesh_seeds.h"

#include "core/error.h"
#include "core/file.h"
#include "core/mesh.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace scree {
namespace {

// One to eight small damages: bits, bytes, cuts, repeats, numbers out of all proportion.
std::string damaged(std::string bytes, Random& random) {
    static const std::vector<std::string> pieces{"nan",
                                                 "-1",
                                                 "1e999",
                                                 "99999999999999999999",
                                                 "0",
                                                 " ",
                                                 "\n",
                                                 "{",
                                                 "[",
                                                 "\"",
                                                 "list",
                                                 "-inf",
                                                 std::string(4, '\xff'),
                                                 std::string(4, '\0'),
                                                 std::string("\0\0\0\x80", 4)};
    const std::uint32_t steps = 1 + random.below(8);
    for (std::uint32_t k = 0; k < steps && !bytes.empty(); ++k) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        switch (random.below(7)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            bytes.resize(at);
            break;
        case 3:
            bytes.erase(at, 1 + random.below(16));
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, 1 + random.below(64)));
            break;
        case 5:
            bytes.insert(at, pieces[random.below(static_cast<std::uint32_t>(pieces.size()))]);
            break;
        default: {
            const std::string& piece =
                pieces[random.below(static_cast<std::uint32_t>(pieces.size()))];
            bytes.replace(at, piece.size(), piece);
        }
        }
    }
    return bytes;
}

TEST(MeshMutation, EveryDamagedFileReadsOrIsRefused) {
    constexpr std::uint64_t mutations = 20000;
    for (const MeshSeed& seed : mesh_seeds()) {
        int read = 0;
        int refused = 0;
        double slowest = 0;
        EXPECT_NO_THROW(seed.read(seed.bytes)) << seed.name;
        for (std::uint64_t i = 0; i < mutations; ++i) {
            Random random(hash_bytes(seed.name), Purpose::test, i);
            const std::string bytes = damaged(seed.bytes, random);
            const auto start = std::chrono::steady_clock::now();
            try {
                const Mesh mesh = seed.read(bytes);
                for (const Mesh::Triangle& t : mesh.triangles)
                    for (const std::uint32_t index : t)
                        ASSERT_LT(index, mesh.positions.size()) << seed.name << ' ' << i;
                ++read;
            } catch (const Error&) {
                ++refused;
            } catch (const std::exception& problem) {
                ADD_FAILURE() << seed.name << ' ' << i << ": " << problem.what();
            }
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            slowest = std::max(slowest, taken.count());
        }
        EXPECT_GT(refused, 0) << seed.name;
        EXPECT_LT(slowest, 2.0) << seed.name;
        RecordProperty(seed.name, std::to_string(read) + " read");
    }
}

// Every possible end of the file.
TEST(MeshMutation, EveryTruncationReadsOrIsRefused) {
    for (const MeshSeed& seed : mesh_seeds())
        for (std::size_t size = 0; size < seed.bytes.size(); ++size) {
            try {
                seed.read(seed.bytes.substr(0, size));
            } catch (const Error&) {
                continue;
            } catch (const std::exception& problem) {
                ADD_FAILURE() << seed.name << ' ' << size << ": " << problem.what();
            }
        }
}

} // namespace
} // namespace scree

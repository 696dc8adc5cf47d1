// SPDX-License-Identifier: GPL-3.0-or-later
// Deterministic mutations of small valid mesh files: each must either be read or be rejected with
// an Error, in bounded time.
#include "tests/fuzz/mesh_seeds.h"
#include "tests/support/damaged.h"

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "geometry/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace scree {
namespace {

// Extreme numbers, and keywords of the formats.
const std::vector<std::string> pieces{"nan",
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

TEST(MeshMutation, EveryDamagedFileReadsOrIsRefused) {
    constexpr std::uint64_t mutations = 20000;
    for (const MeshSeed& seed : mesh_seeds()) {
        int read = 0;
        int refused = 0;
        double slowest = 0;
        EXPECT_NO_THROW(seed.read(seed.bytes)) << seed.name;
        for (std::uint64_t i = 0; i < mutations; ++i) {
            Random random(hash_bytes(seed.name), Purpose::test, i);
            const std::string bytes = damaged(seed.bytes, pieces, random);
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

// Truncation at every position.
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

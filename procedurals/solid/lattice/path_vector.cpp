// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/lattice/vector_path.h"

#include <hwy/highway.h>

#include <cassert>

namespace scree {

namespace {

bool scalar = false;

} // namespace

std::vector<std::string> vector_paths() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (target != HWY_SCALAR)
            names.emplace_back(hwy::TargetName(target));
    names.emplace_back("scalar");
    return names;
}

UseVectorPath::UseVectorPath(const std::string& name) {
    scalar = name == "scalar";
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (name == hwy::TargetName(target))
            hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

UseVectorPath::~UseVectorPath() {
    scalar = false;
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

bool scalar_path_in_use() {
    static const bool no_vectors = vector_paths().size() == 1;
    return scalar || no_vectors;
}

} // namespace scree

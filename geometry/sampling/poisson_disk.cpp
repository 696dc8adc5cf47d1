// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/poisson_disk.h"

#include "core/error.h"
#include "core/random.h"
#include "geometry/sampling/disk_metric.h"
#include "geometry/sampling/elliptic_disks.h"
#include "geometry/sampling/isotropic_disks.h"
#include "geometry/sampling/relax_disks.h"

#include <fmt/format.h>

namespace scree {

void check_torus(const PoissonDiskProblem& problem) {
    const DiskMetric metric(problem);
    const Box2 box = bounds(*problem.domain);
    const double least = 4 * metric.longest() * metric.scale_over(box).high;
    const Vec2 size = box.size();
    if (std::min(size.x, size.y) < least)
        throw Error(fmt::format("the domain is {:.4g} m along {}; with these distances it must be "
                                "{:.4g} m, so that none meets itself",
                                std::min(size.x, size.y), size.x <= size.y ? "x" : "z", least));
}

namespace {

bool is_isotropic(const PoissonDiskProblem& problem) {
    const DiskClass& only = problem.classes[0];
    return problem.classes.size() == 1 && only.length == only.width && !problem.scale &&
           problem.kept.empty() && !problem.window;
}

PoissonDiskSet sample_isotropic(const PoissonDiskProblem& problem, const Context& context) {
    const DiskClass& only = problem.classes[0];
    IsotropicDisks disks =
        sample_isotropic_disks(*problem.domain, problem.torus, only.length, problem.seed, context);
    PoissonDiskSet set{.samples = {}, .trials = disks.trials, .unresolved = disks.unresolved};
    set.samples.resize(disks.points.size());
    for (std::size_t i = 0; i < disks.points.size(); ++i) {
        DiskSample& sample = set.samples[i];
        sample.position = disks.points[i];
        if (problem.direction)
            sample.angle = radians(problem.direction->at(sample.position));
        if (only.turn.high > only.turn.low)
            sample.angle +=
                Random(problem.seed, Purpose::disk_class, i).uniform(only.turn.low, only.turn.high);
        else
            sample.angle += only.turn.low;
    }
    return set;
}

PoissonDiskSet sample_relaxed(const PoissonDiskProblem& problem, const Context& context) {
    PoissonDiskProblem plain = problem;
    plain.relax = 0;
    PoissonDiskSet set = sample_poisson_disks(plain, context);
    relax_disks(plain, problem.relax, set.samples, context);
    plain.kept = set.samples; // new samples fill the room that the movements left
    PoissonDiskSet more = sample_elliptic_disks(plain, context);
    set.samples.insert(set.samples.end(), more.samples.begin(), more.samples.end());
    set.trials += more.trials;
    set.unresolved = more.unresolved;
    return set;
}

} // namespace

PoissonDiskSet sample_poisson_disks(const PoissonDiskProblem& problem, const Context& context) {
    if (problem.torus)
        check_torus(problem);
    if (problem.relax > 0 && problem.kept.empty() && !problem.window)
        return sample_relaxed(problem, context);
    return is_isotropic(problem) ? sample_isotropic(problem, context)
                                 : sample_elliptic_disks(problem, context);
}

} // namespace scree

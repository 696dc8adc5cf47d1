// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/relax_disks.h"

#include "core/parallel.h"
#include "geometry/sampling/disk_metric.h"
#include "geometry/sampling/leaf_cells.h"

#include <numeric>

namespace scree {

namespace {

// In units of the distance that a pair must keep: the width of the Gaussian, and where it is cut
// off. Found by trying 0.45 to 0.65 for one, three and four classes: narrower ones leave more power
// at low frequencies, wider ones more conflicts.
constexpr double sigma = 0.55;
constexpr double cutoff = 1.7;
constexpr double gain = 0.7;          // of a step; 1 is the most that does not oscillate
constexpr double longest_move = 0.15; // of the least distance

PoissonDiskProblem widened(const PoissonDiskProblem& problem) {
    PoissonDiskProblem wide = problem;
    for (DiskClass& c : wide.classes) {
        c.length *= cutoff;
        c.width *= cutoff;
    }
    wide.kept.clear();
    wide.window.reset();
    return wide;
}

class Relaxation {
  public:
    Relaxation(const PoissonDiskProblem& problem, std::vector<DiskSample>& samples)
        : problem_(problem), samples_(samples), metric_(problem), wide_(widened(problem)),
          wide_metric_(wide_), leaves_(wide_, wide_metric_) {
        for (const DiskSample& sample : samples_)
            turns_.push_back(sample.angle - metric_.angle_at(sample.position));
        box_ = bounds(*problem.domain);
    }

    void step();
    void remove_conflicts();

  private:
    struct Body {
        Vec2 position;
        QuadraticForm form;
        std::uint32_t disk_class = 0;
        std::uint32_t sample = 0;
    };

    void sort_bodies();
    bool is_near_border(const DiskSample& sample) const;
    void add_mirrored(std::vector<Body>& bodies) const;
    Vec2 push(const Body& body, std::uint32_t leaf) const;
    void move(std::size_t i, const Vec2& by);
    template <class Visit>
    void for_bodies_near(std::uint32_t leaf, const Visit& visit) const {
        leaves_.for_runs_near(leaf, [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t b = first_body_[first]; b < first_body_[last]; ++b)
                visit(bodies_[b]);
        });
    }

    const PoissonDiskProblem& problem_;
    std::vector<DiskSample>& samples_;
    DiskMetric metric_;
    PoissonDiskProblem wide_;
    DiskMetric wide_metric_;
    LeafCells leaves_;
    std::vector<double> turns_;
    Box2 box_;
    std::vector<Body> bodies_; // samples and their mirror images, by leaf
    std::vector<std::uint32_t> first_body_;
    std::vector<std::uint32_t> leaf_of_; // of each sample
};

void Relaxation::sort_bodies() {
    std::vector<Body> bodies(samples_.size());
    parallel_for(samples_.size(), 256, [&](std::size_t i) {
        const DiskSample& s = samples_[i];
        bodies[i] = {s.position, metric_.form(s.disk_class, s.angle, s.scale), s.disk_class,
                     static_cast<std::uint32_t>(i)};
    });
    add_mirrored(bodies);
    std::vector<std::uint32_t> leaf(bodies.size());
    parallel_for(bodies.size(), 256, [&](std::size_t i) {
        leaf[i] = leaves_.leaf_at(bodies[i].position).value_or(leaves_.count());
    });
    first_body_.assign(leaves_.count() + 2, 0);
    for (const std::uint32_t l : leaf)
        ++first_body_[l + 1];
    std::partial_sum(first_body_.begin(), first_body_.end(), first_body_.begin());
    std::vector<std::uint32_t> at(first_body_.begin(), first_body_.end() - 1);
    bodies_.resize(bodies.size());
    leaf_of_.resize(samples_.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies_[at[leaf[i]]++] = bodies[i];
        if (i < samples_.size())
            leaf_of_[i] = leaf[i];
    }
}

bool Relaxation::is_near_border(const DiskSample& sample) const {
    const double reach = wide_metric_.longest() * sample.scale;
    const Vec2& p = sample.position;
    if (p.x - box_.min.x < reach || p.y - box_.min.y < reach || box_.max.x - p.x < reach ||
        box_.max.y - p.y < reach)
        return true;
    bool all_whole = true;
    if (const auto leaf = leaves_.leaf_at(p))
        leaves_.for_runs_near(*leaf, [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t i = first; i < last; ++i)
                all_whole = all_whole && leaves_.is_whole(i);
        });
    return !all_whole;
}

// Images behind the border's edges, so that samples are pushed away from it as from each other.
void Relaxation::add_mirrored(std::vector<Body>& bodies) const {
    if (problem_.torus)
        return;
    std::vector<std::uint8_t> near(samples_.size());
    parallel_for(samples_.size(), 64,
                 [&](std::size_t i) { near[i] = is_near_border(samples_[i]) ? 1 : 0; });
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (near[i] == 0)
            continue;
        const DiskSample& s = samples_[i];
        const double reach = wide_metric_.longest() * s.scale;
        for (const Ring& ring : problem_.domain->rings)
            for (std::size_t e = 0; e < ring.size(); ++e) {
                const Vec2& a = ring[e];
                const Vec2 along = ring[(e + 1) % ring.size()] - a;
                const Vec2 to = s.position - a;
                const double share = to.dot(along) / along.length2();
                const double height = cross(along, to) / along.length(); // inside is to the left
                if (share < 0 || share > 1 || height < 0 || height > reach / 2)
                    continue;
                const Vec2 normal = Vec2(-along.y, along.x) / along.length();
                Body image = bodies[i];
                image.position -= normal * (2 * height);
                image.sample = static_cast<std::uint32_t>(samples_.size());
                bodies.push_back(image);
            }
    }
}

Vec2 Relaxation::push(const Body& body, std::uint32_t leaf) const {
    Vec2 sum(0, 0);
    const std::uint32_t k = body.disk_class;
    for_bodies_near(leaf, [&](const Body& other) {
        if (other.sample == body.sample)
            return;
        const Vec2 d = leaves_.nearest_image(body.position - other.position);
        const std::uint32_t o = other.disk_class;
        const double t2 =
            (body.form.at(d) / metric_.limit(k, o) + other.form.at(d) / metric_.limit(o, k)) / 2;
        if (t2 > cutoff * cutoff)
            return;
        sum += d * std::exp(-t2 / (2 * sigma * sigma));
    });
    return sum * gain;
}

void Relaxation::move(std::size_t i, const Vec2& by) {
    DiskSample& s = samples_[i];
    const double longest = longest_move * metric_.least_distance() * s.scale;
    const double length = by.length();
    Vec2 to = s.position + (length > longest ? by * (longest / length) : by);
    if (problem_.torus) {
        const Vec2 size = box_.size();
        to -= Vec2(std::floor((to.x - box_.min.x) / size.x) * size.x,
                   std::floor((to.y - box_.min.y) / size.y) * size.y);
    } else if (!contains(*problem_.domain, to)) {
        return;
    }
    s.position = to;
    s.angle = metric_.angle_at(to) + turns_[i];
    s.scale = metric_.scale_at(to);
}

void Relaxation::step() {
    sort_bodies();
    std::vector<Vec2> moves(samples_.size());
    parallel_for(leaves_.count(), 16, [&](std::size_t leaf) {
        for (std::uint32_t b = first_body_[leaf]; b < first_body_[leaf + 1]; ++b)
            if (bodies_[b].sample < samples_.size())
                moves[bodies_[b].sample] = push(bodies_[b], static_cast<std::uint32_t>(leaf));
    });
    parallel_for(samples_.size(), 64, [&](std::size_t i) { move(i, moves[i]); });
}

void Relaxation::remove_conflicts() {
    sort_bodies();
    std::vector<bool> out(samples_.size(), false);
    for (std::uint32_t leaf = 0; leaf < leaves_.count(); ++leaf)
        for (std::uint32_t b = first_body_[leaf]; b < first_body_[leaf + 1]; ++b) {
            const Body& body = bodies_[b];
            if (body.sample >= samples_.size())
                continue;
            for_bodies_near(leaf, [&](const Body& other) {
                if (other.sample >= body.sample || out[other.sample] || out[body.sample])
                    return;
                const Vec2 d = leaves_.nearest_image(body.position - other.position);
                const std::uint32_t k = body.disk_class;
                const std::uint32_t o = other.disk_class;
                out[body.sample] = body.form.at(d) < metric_.limit(k, o) * (1 + 1e-9) ||
                                   other.form.at(d) < metric_.limit(o, k) * (1 + 1e-9);
            });
        }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (!out[i])
            samples_[kept++] = samples_[i];
    samples_.resize(kept);
}

} // namespace

void relax_disks(const PoissonDiskProblem& problem, int steps, std::vector<DiskSample>& samples,
                 const Context& context) {
    Relaxation relaxation(problem, samples);
    for (int i = 0; i < steps; ++i) {
        context.check_cancel();
        context.report("relax", double(i) / steps);
        relaxation.step();
    }
    relaxation.remove_conflicts();
}

} // namespace scree

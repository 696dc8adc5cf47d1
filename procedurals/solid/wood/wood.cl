// SPDX-License-Identifier: GPL-3.0-or-later
// Wood: annual rings about a pith, pushed about by the fractal field (Okada et al. 1987, eqs.
// 10-12), with what the paper leaves out: years of uneven width, early and late wood, knots,
// fibres, vessels and rays. Needs solid.cl.

typedef struct {
    Placement placement; // of the rings' fluctuation
    Placement fibre_placement;
    Triple right, up; // across the trunk, drawn out where its section is an ellipse
    Triple axis;      // along it, unit
    Triple origin;    // on the pith [m]
    uint key;
    int filtered;
    int iterations;

    float push;           // k: radial displacement per unit of D [m]
    float ring;           // mean width of a year [m]
    float ring_variation; // how far a year's end may lie off, in years; below 0.5
    float tint_variation; // of late wood's share of its colour between years
    float asymmetry;      // rings are wider by so much on one side
    float wander;         // of the pith [m]
    float wander_rate;    // [rad/m]

    int sine;         // the paper's profile
    float early_end;  // late wood begins to form; in shares of a year
    float late_begin; // it is full
    float late_end;   // it ends; winter lasts to 1

    float knot_spacing; // mean distance along the trunk [m]; 0: none
    float knot_growth;  // of a branch's radius against the trunk's
    float fibre;        // contrast of streaks along the grain

    float pore_share;  // of cells that hold a vessel; 0: none
    float pore_cell;   // mean distance of vessels [m]
    float pore_radius; // in cells, at most 0.5
    float pore_length; // [m]
    float ring_porous; // 1: vessels in early wood alone

    float ray_share;  // 0: none
    float ray_cell;   // mean distance along the circumference [m]
    float ray_width;  // [m]
    float ray_height; // [m]

    float sapwood;                         // radius where sapwood begins [m]; 0: none
    float late_height;                     // late wood stands out [m]
    float pore_depth;                      // [m]
    float early_roughness, late_roughness; // below 0: the material's own

    Triple early, late, sap, knot, pore, ray;
} Wood;

// Radial growth at a point: the year's surface that passes there, as a distance from the pith.
typedef struct {
    float radius;    // [m]
    Triple gradient; // in the object's frame
    float variance;  // of what the filter leaves out [m^2]
    float knot;      // 1 inside of a branch
} Growth;

static inline uint wood_hash(uint key, uint a, uint b, uint c) {
    return node_bits(row_bits(key, a, b, c), key, a);
}

// The convolution with a Gaussian of unit deviation of a slope that begins at 0: z for large z.
static inline float soft_ramp(float z) { return z * normal_share(z) + normal_density(z); }

// Late wood's share within years: 0 in spring, rising to 1 and falling at the year's end, convolved
// with a Gaussian; `phase` and `sigma` in years. Its derivative goes to *slope.
static inline float year_profile(global const Wood* wood, float phase, float sigma, float* slope) {
    *slope = 0.0f;
    if (wood->sine) { // from [-1, 1]; a Gaussian damps a wave and leaves it where it is
        const float turn = 6.2831853f, damping = exp(-0.5f * square(turn * sigma));
        *slope = 0.5f * turn * damping * cos(turn * phase);
        return 0.5f + 0.5f * damping * sin(turn * phase);
    }
    const float a = wood->early_end, b = wood->late_begin, c = wood->late_end;
    if (sigma > 0.6f)
        return 0.5f * (b - a) + (c - b) + 0.5f * (1.0f - c);
    const float rise = 1.0f / (b - a), fall = 1.0f / (1.0f - c);
    if (sigma < 0.004f) {
        *slope = phase < a ? 0.0f : phase < b ? rise : phase < c ? 0.0f : -fall;
        return phase < a   ? 0.0f
               : phase < b ? (phase - a) * rise
               : phase < c ? 1.0f
                           : (1.0f - phase) * fall;
    }
    // A broken line is a sum of slopes that begin at its corners; the years before and after count
    // as far as the Gaussian reaches.
    float sum = 0.0f;
    const int reach = sigma > 0.2f ? 2 : 1;
    for (int year = -reach; year <= reach; ++year) {
        const float x = phase - (float)year;
        if (x < a - 5.0f * sigma || x > 1.0f + 5.0f * sigma)
            continue;
        const float za = (x - a) / sigma, zb = (x - b) / sigma;
        const float zc = (x - c) / sigma, zd = (x - 1.0f) / sigma;
        sum += sigma *
               (rise * (soft_ramp(za) - soft_ramp(zb)) - fall * (soft_ramp(zc) - soft_ramp(zd)));
        *slope += rise * (normal_share(za) - normal_share(zb)) -
                  fall * (normal_share(zc) - normal_share(zd));
    }
    return sum;
}

// How far from evenness year `year` begins, in mean years.
static inline float year_shift(global const Wood* wood, int year) {
    return wood->ring_variation * (unit_of(wood_hash(wood->key, 1U, (uint)year, 0U)) - 0.5f);
}

// What the branches do to the growth: a branch is a trunk that grows slower, from a place on the
// pith outwards; a point belongs to what reaches it first, and the rings bend round in between.
static inline void add_knots(global const Wood* wood, Triple from_pith, float height,
                             Growth* growth) {
    const int middle = whole_of(height / wood->knot_spacing);
    for (int stratum = middle - 2; stratum <= middle + 2; ++stratum) {
        const uint bits = wood_hash(wood->key, 2U, (uint)stratum, 0U);
        const uint more = wood_hash(wood->key, 3U, (uint)stratum, 0U);
        const float at = ((float)stratum + unit_of(bits)) * wood->knot_spacing;
        const float angle = 6.2831853f * unit_of(more);
        const float growth_rate = wood->knot_growth * (0.6f + 0.8f * unit_of(scramble(bits)));
        const float rise = 0.15f + 0.5f * unit_of(scramble(more)); // branches point upwards
        Triple along = plus(plus(scaled(wood->right, cos(angle)), scaled(wood->up, sin(angle))),
                            scaled(wood->axis, rise));
        along = scaled(along, 1.0f / length_of(along));
        const Triple q = plus(from_pith, scaled(wood->axis, height - at));
        const float way = inner(q, along);
        if (way <= 0.0f)
            continue;
        const Triple off = minus(q, scaled(along, way));
        const float thick = length_of(off);
        const float branch = thick / growth_rate;
        const float blend = 0.35f * way + wood->ring;
        const float share = limited(0.5f + 0.5f * (branch - growth->radius) / blend, 0.0f, 1.0f);
        if (share >= 1.0f)
            continue;
        const Triple outwards = scaled(off, 1.0f / (fmax(thick, 1e-9f) * growth_rate));
        growth->radius = mixed(branch, growth->radius, share) - blend * share * (1.0f - share);
        growth->gradient = mixed3(outwards, growth->gradient, share);
        growth->variance *= share * share;
        growth->knot = fmax(growth->knot, smooth(0.55f, 0.3f, share));
    }
}

// The paper's radial displacement about an uneven trunk.
static inline Growth growth_at(Field field, global const Wood* wood, Triple position, Triple across,
                               Triple along, float random) {
    const Placement placement = wood->placement;
    const Triple v = minus(position, wood->origin);
    const float height = inner(v, wood->axis);
    const float bend_x = wood->wander_rate * height, bend_y = 0.73f * bend_x + 1.9f;
    const float shift_x = wood->wander * sin(bend_x), shift_y = wood->wander * sin(bend_y);
    const float lean_x = wood->wander * wood->wander_rate * cos(bend_x);
    const float lean_y = 0.73f * wood->wander * wood->wander_rate * cos(bend_y);
    const float x = inner(v, wood->right) - shift_x, y = inner(v, wood->up) - shift_y;
    const float r = sqrt(x * x + y * y + 1e-14f);
    const Triple dx = minus(wood->right, scaled(wood->axis, lean_x));
    const Triple dy = minus(wood->up, scaled(wood->axis, lean_y));
    Growth growth;
    growth.knot = 0.0f;
    const Triple radial = scaled(plus(scaled(wood->right, x), scaled(wood->up, y)), 1.0f / r);
    Triple p = position;
    Fluctuation d;
    d.value = 0.0f;
    for (int i = 0; i <= wood->iterations; ++i) {
        d = fluctuation_at(field, &placement, p, filter_width(&placement, across, along), random);
        p = minus(position, scaled(radial, wood->push * d.value));
    }
    growth.radius = r + wood->asymmetry * x - wood->push * d.value;
    growth.gradient =
        plus(scaled(plus(scaled(dx, x), scaled(dy, y)), 1.0f / r), scaled(dx, wood->asymmetry));
    growth.gradient = minus(growth.gradient, scaled(d.gradient, wood->push));
    growth.variance = square(wood->push) * d.variance;
    if (wood->knot_spacing > 0.0f)
        add_knots(wood, plus(scaled(wood->right, x), scaled(wood->up, y)), height, &growth);
    growth.variance += filter_variance(growth.gradient, across, along);
    return growth;
}

// Share of a section through vessels, which are thin and long; `blur` [m] across the trunk.
// Adds the slope of their edges to *slope, per unit of depth.
static inline float pores(global const Wood* wood, Triple v, float early, float blur,
                          Triple* slope) {
    const float weight = mixed(1.0f, early, wood->ring_porous) * wood->pore_share;
    // Vessels fill 3/4 of their length, their radii's squares are 0.653 of the largest's in the
    // mean, and where several are they overlap.
    const float mean =
        1.0f - exp(-weight * 0.75f * 0.653f * 3.1415927f * square(wood->pore_radius));
    const float x = inner(v, wood->right) / wood->pore_cell;
    const float y = inner(v, wood->up) / wood->pore_cell;
    const float sigma = fmax(blur / wood->pore_cell, 0.02f);
    const float resolved = smooth(0.7f, 0.25f, sigma);
    if (resolved <= 0.0f || weight <= 0.0f)
        return mean;
    const float height = inner(v, wood->axis) / wood->pore_length;
    const int cx = whole_of(x - 0.5f), cy = whole_of(y - 0.5f);
    float clear = 1.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const int ix = cx + (corner & 1), iy = cy + (corner >> 1);
        const uint column = wood_hash(wood->key, 4U + (uint)ix, (uint)iy, 5U);
        const float at = height + unit_of(column);
        const int segment = whole_of(at);
        const uint bits = wood_hash(wood->key ^ column, 6U, (uint)segment, 7U);
        if (unit_of(bits) >= weight)
            continue;
        const uint more = scramble(bits);
        const float begin = 0.3f * unit_of(more), end = 1.0f - 0.2f * unit_of(scramble(more));
        const float f = at - (float)segment;
        if (f < begin || f > end)
            continue;
        const float px = (float)ix + unit_of(scramble(column ^ 0x68bc21ebU)) - x;
        const float py = (float)iy + unit_of(scramble(column ^ 0x02e5be93U)) - y;
        const float away = sqrt(px * px + py * py + 1e-12f);
        const float radius = wood->pore_radius * (0.6f + 0.4f * unit_of(scramble(more ^ 77U)));
        const float z = (radius - away) / sigma;
        if (z < -4.0f)
            continue;
        clear *= 1.0f - normal_share(z);
        const float steep = normal_density(z) / (sigma * wood->pore_cell * away);
        *slope = plus(
            *slope, scaled(plus(scaled(wood->right, px), scaled(wood->up, py)), resolved * steep));
    }
    return mixed(mean, 1.0f - clear, resolved);
}

// Share of a section through rays: upright lenses that run from the pith to the bark, more of them
// the farther out.
static inline float rays(global const Wood* wood, Triple v, float blur) {
    const float x = inner(v, wood->right), y = inner(v, wood->up);
    const float r = sqrt(x * x + y * y);
    // Of 2^n sectors, as wide as a cell or up to twice that.
    const float wanted = 6.2831853f * r / wood->ray_cell;
    const int octave = (int)limited(floor(log2(fmax(wanted, 1.0f))), 2.0f, 16.0f);
    const float sectors = (float)(1 << octave);
    const float sector_width = 6.2831853f * r / sectors;
    // Lenses are 0.725 of their segments high in the mean, and ellipses.
    const float mean = wood->ray_share * 0.725f * 0.785398f *
                       limited(wood->ray_width / fmax(sector_width, 1e-9f), 0.0f, 1.0f);
    const float resolved = smooth(0.9f, 0.35f, blur / wood->ray_cell);
    if (resolved <= 0.0f)
        return mean;
    const float turn = (atan2(y, x) * 0.15915494f + 0.5f) * sectors;
    const int sector = whole_of(turn) & ((1 << octave) - 1);
    const uint column = wood_hash(wood->key, 11U, (uint)sector, (uint)octave);
    const float height = inner(v, wood->axis) / wood->ray_height + unit_of(column);
    const int segment = whole_of(height);
    const uint bits = wood_hash(wood->key ^ column, 12U, (uint)segment, 13U);
    if (unit_of(bits) >= wood->ray_share)
        return mixed(mean, 0.0f, resolved);
    const uint more = scramble(bits);
    const float middle = 0.25f + 0.5f * unit_of(more);
    const float arc = (turn - floor(turn) - middle) * sector_width;
    const float tall = 0.5f + 0.45f * unit_of(scramble(more)); // of its segment
    const float f = (height - (float)segment - 0.5f) * 2.0f / tall;
    if (fabs(f) >= 1.0f)
        return mixed(mean, 0.0f, resolved);
    const float half_width = 0.5f * wood->ray_width * sqrt(1.0f - f * f);
    const float sigma = fmax(blur, 0.05f * wood->ray_width);
    const float share =
        normal_share((half_width - arc) / sigma) - normal_share((-half_width - arc) / sigma);
    return mixed(mean, share, resolved);
}

// Deviation of the filter across the trunk [m].
static inline float blur_across(global const Wood* wood, Triple across, Triple along) {
    const float variance =
        filter_variance(wood->right, across, along) + filter_variance(wood->up, across, along);
    return sqrt(0.5f * variance);
}

static inline SolidSample wood_part(Field field, global const Wood* wood, Triple position,
                                    Triple across, Triple along, float random) {
    const Growth growth = growth_at(field, wood, position, across, along, random);
    const float years = growth.radius / wood->ring;
    int year = whole_of(years);
    float passed = years - floor(years);
    // Ends are off by less than half a year, so that the year is this one or a neighbour.
    if (passed < year_shift(wood, year)) {
        --year;
        passed += 1.0f;
    } else if (passed >= 1.0f + year_shift(wood, year + 1)) {
        ++year;
        passed -= 1.0f;
    }
    const float begin = year_shift(wood, year);
    const float width = 1.0f + year_shift(wood, year + 1) - begin;
    const float phase = (passed - begin) / width;
    const float sigma = sqrt(growth.variance) / (wood->ring * width);
    float steepness = 0.0f;
    const float late = year_profile(wood, phase, sigma, &steepness);
    const float tint =
        mixed(unit_of(wood_hash(wood->key, 8U, (uint)year, 9U)),
              unit_of(wood_hash(wood->key, 8U, (uint)(year + 1), 9U)), smooth(0.0f, 1.0f, phase));
    SolidSample sample = no_sample();
    sample.value = late * (1.0f - wood->tint_variation * tint);
    sample.color = mixed3(wood->early, wood->late, sample.value);
    if (wood->sapwood > 0.0f)
        sample.color =
            mixed3(sample.color,
                   triple(wood->sap.x * sample.color.x, wood->sap.y * sample.color.y,
                          wood->sap.z * sample.color.z),
                   smooth(wood->sapwood - wood->ring, wood->sapwood + wood->ring, growth.radius));
    sample.height = wood->late_height * sample.value;
    sample.slope = scaled(growth.gradient, wood->late_height * steepness / (wood->ring * width));
    const Triple v = minus(position, wood->origin);
    if (wood->fibre > 0.0f) {
        const Placement placement = wood->fibre_placement;
        const float d = fluctuation_at(field, &placement, position,
                                       filter_width(&placement, across, along), random)
                            .value;
        sample.color = scaled(sample.color, 1.0f + wood->fibre * (0.5f - smooth(-1.6f, 1.6f, d)));
    }
    const float blur = blur_across(wood, across, along);
    if (wood->ray_share > 0.0f)
        sample.color = mixed3(sample.color, wood->ray, rays(wood, v, blur) * (1.0f - growth.knot));
    if (wood->pore_share > 0.0f) {
        Triple slope = triple(0.0f, 0.0f, 0.0f);
        const float early = (1.0f - late) * (1.0f - growth.knot);
        const float share = pores(wood, v, early, blur, &slope);
        sample.color = mixed3(sample.color, wood->pore, share);
        sample.slope = minus(sample.slope, scaled(slope, wood->pore_depth));
        sample.height -= wood->pore_depth * share;
    }
    sample.color = mixed3(sample.color,
                          triple(wood->knot.x * sample.color.x, wood->knot.y * sample.color.y,
                                 wood->knot.z * sample.color.z),
                          growth.knot);
    sample.roughness = mixed(wood->early_roughness, wood->late_roughness, sample.value);
    return sample;
}

static inline SolidSample wood_at(Field field, global const Wood* wood, SolidPoint point) {
    MEAN_OF_PARTS(wood_part, field, wood, point)
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Wood: annual rings around a pith, displaced by the fractal field (Okada et al. 1987, eqs. 10-12).
// Additions to the paper: rings of varying width, early and late wood, knots, fibres, vessels and
// rays. Needs solid.cl.

typedef struct {
    Placement placement; // of the field that displaces the rings
    Placement fibre_placement;
    Triple right, up; // across the trunk, scaled if its cross-section is an ellipse
    Triple axis;      // unit vector along the trunk
    Triple origin;    // a point of the pith [m]
    uint key;
    int filtered;
    int iterations;

    float displacement;   // k: radial displacement per unit of D [m]
    float ring;           // mean width of a year [m]
    float ring_variation; // range of the shifts of the rings' ends, in years; below 0.5
    float tint_variation; // of the late wood colour between years
    float asymmetry;      // relative increase of the radius on one side
    float wander;         // amplitude of the pith's deviation from a straight line [m]
    float wander_rate;    // its angular frequency [rad/m]

    int sine;         // 1: the paper's profile
    float early_end;  // share of a year at which late wood begins to form,
    float late_begin; // is complete,
    float late_end;   // and begins to fade, until 1

    float knot_spacing; // mean distance along the trunk [m]; 0: none
    float knot_growth;  // growth rate of a branch's radius relative to the trunk's
    float fibre;        // contrast of streaks along the grain

    float pore_share;  // of cells that hold a vessel; 0: none
    float pore_cell;   // mean distance of vessels [m]
    float pore_radius; // in cells, at most 0.5
    float pore_length; // [m]
    float ring_porous; // 1: vessels in early wood only

    float ray_share;  // 0: none
    float ray_cell;   // mean distance along the circumference [m]
    float ray_width;  // [m]
    float ray_height; // [m]

    float sapwood;                         // radius where sapwood begins [m]; 0: none
    float late_height;                     // height of late wood [m]
    float pore_depth;                      // [m]
    float early_roughness, late_roughness; // negative: that of the material

    Triple early, late, sap, knot, pore, ray;
} Wood;

// Radial growth at a point: the radius at which the growth ring through it would lie in an
// undisturbed trunk.
typedef struct {
    float radius;    // [m]
    Triple gradient; // in object space
    float variance;  // of the radius within the filter [m^2]
    float knot;      // 1 inside a branch
} Growth;

static inline uint wood_hash(uint key, uint a, uint b, uint c) {
    return node_bits(row_bits(key, a, b, c), key, a);
}

// The convolution of max(0, z) with a standard Gaussian.
static inline float soft_ramp(float z) { return z * normal_cdf(z) + normal_pdf(z); }

// The share of late wood within a year (0 in spring, rising to 1, falling at the end of the year),
// convolved with a Gaussian. `phase` and `sigma` are in years; *slope is set to the derivative.
static inline float year_profile(global const Wood* wood, float phase, float sigma, float* slope) {
    *slope = 0.0f;
    if (wood->sine) { // mapped from [-1, 1]; a Gaussian only reduces the amplitude of a sine
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
    // A piecewise linear function is a sum of ramps that begin at its corners. Adjacent years are
    // included within the reach of the Gaussian.
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
        *slope +=
            rise * (normal_cdf(za) - normal_cdf(zb)) - fall * (normal_cdf(zc) - normal_cdf(zd));
    }
    return sum;
}

// The deviation of the beginning of a year from an even spacing, in mean years.
static inline float year_shift(global const Wood* wood, int year) {
    return wood->ring_variation * (uniform_of(wood_hash(wood->key, 1U, (uint)year, 0U)) - 0.5f);
}

// Adds branches to the growth. A branch grows outwards from a point of the pith, like a slower
// growing trunk. A point belongs to whichever reaches it first; in between the rings are blended.
static inline void add_knots(global const Wood* wood, Triple from_pith, float height,
                             Growth* growth) {
    const int middle = floor_to_int(height / wood->knot_spacing);
    for (int stratum = middle - 2; stratum <= middle + 2; ++stratum) {
        const uint bits = wood_hash(wood->key, 2U, (uint)stratum, 0U);
        const uint more = wood_hash(wood->key, 3U, (uint)stratum, 0U);
        const float at = ((float)stratum + uniform_of(bits)) * wood->knot_spacing;
        const float angle = 6.2831853f * uniform_of(more);
        const float growth_rate = wood->knot_growth * (0.6f + 0.8f * uniform_of(scramble(bits)));
        const float rise = 0.15f + 0.5f * uniform_of(scramble(more)); // branches point upwards
        Triple along = plus(plus(scaled(wood->right, cos(angle)), scaled(wood->up, sin(angle))),
                            scaled(wood->axis, rise));
        along = scaled(along, 1.0f / length_of(along));
        const Triple q = plus(from_pith, scaled(wood->axis, height - at));
        const float way = dot3(q, along);
        if (way <= 0.0f)
            continue;
        const Triple off = minus(q, scaled(along, way));
        const float thick = length_of(off);
        const float branch = thick / growth_rate;
        const float blend = 0.35f * way + wood->ring;
        const float share = clamped(0.5f + 0.5f * (branch - growth->radius) / blend, 0.0f, 1.0f);
        if (share >= 1.0f)
            continue;
        const Triple outwards = scaled(off, 1.0f / (fmax(thick, 1e-9f) * growth_rate));
        growth->radius = lerp(branch, growth->radius, share) - blend * share * (1.0f - share);
        growth->gradient = lerp3(outwards, growth->gradient, share);
        growth->variance *= share * share;
        growth->knot = fmax(growth->knot, smooth(0.55f, 0.3f, share));
    }
}

// The paper's radial displacement, around a trunk that is neither straight nor symmetric.
static inline Growth growth_at(Field field, global const Wood* wood, Triple position, Triple across,
                               Triple along, float random) {
    const Placement placement = wood->placement;
    const Triple v = minus(position, wood->origin);
    const float height = dot3(v, wood->axis);
    const float bend_x = wood->wander_rate * height, bend_y = 0.73f * bend_x + 1.9f;
    const float shift_x = wood->wander * sin(bend_x), shift_y = wood->wander * sin(bend_y);
    const float lean_x = wood->wander * wood->wander_rate * cos(bend_x);
    const float lean_y = 0.73f * wood->wander * wood->wander_rate * cos(bend_y);
    const float x = dot3(v, wood->right) - shift_x, y = dot3(v, wood->up) - shift_y;
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
        p = minus(position, scaled(radial, wood->displacement * d.value));
    }
    growth.radius = r + wood->asymmetry * x - wood->displacement * d.value;
    growth.gradient =
        plus(scaled(plus(scaled(dx, x), scaled(dy, y)), 1.0f / r), scaled(dx, wood->asymmetry));
    growth.gradient = minus(growth.gradient, scaled(d.gradient, wood->displacement));
    growth.variance = square(wood->displacement) * d.variance;
    if (wood->knot_spacing > 0.0f)
        add_knots(wood, plus(scaled(wood->right, x), scaled(wood->up, y)), height, &growth);
    growth.variance += filter_variance(growth.gradient, across, along);
    return growth;
}

// The filtered share of vessels, which are thin and long; `blur` [m] is the standard deviation of
// the filter across the trunk. Adds the slope of their edges to *slope, per unit of depth.
static inline float pores(global const Wood* wood, Triple v, float early, float blur,
                          Triple* slope) {
    const float weight = lerp(1.0f, early, wood->ring_porous) * wood->pore_share;
    // The mean share: vessels fill 3/4 of their segments, their mean squared radius is 0.653 of the
    // largest one, and they overlap at random.
    const float mean =
        1.0f - exp(-weight * 0.75f * 0.653f * 3.1415927f * square(wood->pore_radius));
    const float x = dot3(v, wood->right) / wood->pore_cell;
    const float y = dot3(v, wood->up) / wood->pore_cell;
    const float sigma = fmax(blur / wood->pore_cell, 0.02f);
    const float resolved = smooth(0.7f, 0.25f, sigma);
    if (resolved <= 0.0f || weight <= 0.0f)
        return mean;
    const float height = dot3(v, wood->axis) / wood->pore_length;
    const int cx = floor_to_int(x - 0.5f), cy = floor_to_int(y - 0.5f);
    float clear = 1.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const int ix = cx + (corner & 1), iy = cy + (corner >> 1);
        const uint column = wood_hash(wood->key, 4U + (uint)ix, (uint)iy, 5U);
        const float at = height + uniform_of(column);
        const int segment = floor_to_int(at);
        const uint bits = wood_hash(wood->key ^ column, 6U, (uint)segment, 7U);
        if (uniform_of(bits) >= weight)
            continue;
        const uint more = scramble(bits);
        const float begin = 0.3f * uniform_of(more), end = 1.0f - 0.2f * uniform_of(scramble(more));
        const float f = at - (float)segment;
        if (f < begin || f > end)
            continue;
        const float px = (float)ix + uniform_of(scramble(column ^ 0x68bc21ebU)) - x;
        const float py = (float)iy + uniform_of(scramble(column ^ 0x02e5be93U)) - y;
        const float away = sqrt(px * px + py * py + 1e-12f);
        const float radius = wood->pore_radius * (0.6f + 0.4f * uniform_of(scramble(more ^ 77U)));
        const float z = (radius - away) / sigma;
        if (z < -4.0f)
            continue;
        clear *= 1.0f - normal_cdf(z);
        const float steep = normal_pdf(z) / (sigma * wood->pore_cell * away);
        *slope = plus(
            *slope, scaled(plus(scaled(wood->right, px), scaled(wood->up, py)), resolved * steep));
    }
    return lerp(mean, 1.0f - clear, resolved);
}

// How far rays are pushed aside at a place, around the trunk and along it, in [-1, 1]^2: smooth
// noise. A straight cut so enters and leaves them again and again, where rays in exact planes would
// show as straight bars.
static inline void ray_drift(global const Wood* wood, float x, float y, float z, float* around,
                             float* upwards) {
    const int ix = floor_to_int(x), iy = floor_to_int(y), iz = floor_to_int(z);
    const float sx = smooth(0.0f, 1.0f, x - (float)ix), sy = smooth(0.0f, 1.0f, y - (float)iy);
    const float sz = smooth(0.0f, 1.0f, z - (float)iz);
    float first = 0.0f, second = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const int cx = corner & 1, cy = (corner >> 1) & 1, cz = corner >> 2;
        const uint bits = wood_hash(wood->key ^ 0x51ed270bU, (uint)(ix + cx), (uint)(iy + cy),
                                    (uint)(iz + cz));
        const float weight = (cx != 0 ? sx : 1.0f - sx) * (cy != 0 ? sy : 1.0f - sy) *
                             (cz != 0 ? sz : 1.0f - sz);
        first += weight * (float)(bits & 0xffffU);
        second += weight * (float)(bits >> 16);
    }
    *around = first * (2.0f / 65535.0f) - 1.0f;
    *upwards = second * (2.0f / 65535.0f) - 1.0f;
}

// The share of rays at radius r that begin within an octave of radii, [first, 2 first), and end
// beyond it: most are there, in its middle all of them.
static inline float rays_present(float r, float first) {
    const float x = r / first;
    return clamped((x - 0.7f) / 0.6f, 0.0f, 1.0f) * clamped((2.5f - x) / 0.9f, 0.0f, 1.0f);
}

// The filtered share of the rays of one octave, of which each of 2^octave sectors holds a column.
// `turn` is in [0, 1), `height` in segments of rays.
static inline float rays_of_octave(global const Wood* wood, int octave, float first, float turn,
                                   float r, float height, float sigma) {
    const float sectors = (float)(1 << octave);
    const float at = turn * sectors;
    const int sector = floor_to_int(at) & ((1 << octave) - 1);
    const uint column = wood_hash(wood->key, 11U, (uint)sector, (uint)octave);
    const float along = height + uniform_of(column);
    const int segment = floor_to_int(along);
    const uint bits = wood_hash(wood->key ^ column, 12U, (uint)segment, 13U);
    if (uniform_of(bits) >= wood->ray_share)
        return 0.0f;
    const uint more = scramble(bits), last = scramble(more);
    if (r < first * (0.7f + 0.6f * uniform_of(scramble(last))) ||
        r > first * (1.6f + 0.9f * uniform_of(scramble(last ^ 0x2545f491U))))
        return 0.0f;
    const float middle = 0.25f + 0.5f * uniform_of(more);
    const float arc = (at - floor(at) - middle) * (6.2831853f * r / sectors);
    const float tall = 0.5f + 0.45f * uniform_of(last); // of its segment, anywhere within it
    const float centre = 0.5f + (1.0f - tall) * (uniform_of(scramble(bits ^ 0x9e3779b9U)) - 0.5f);
    const float f = (along - (float)segment - centre) * 2.0f / tall;
    if (fabs(f) >= 1.0f)
        return 0.0f;
    const float half_width = 0.5f * wood->ray_width * sqrt(1.0f - f * f);
    return normal_cdf((half_width - arc) / sigma) - normal_cdf((-half_width - arc) / sigma);
}

// The filtered share of rays: upright lenses that run outwards. Their number increases with the
// radius: each octave of radii has twice as many as the one before.
static inline float rays(global const Wood* wood, Triple v, float blur) {
    const float x = dot3(v, wood->right), y = dot3(v, wood->up), z = dot3(v, wood->axis);
    const float r = sqrt(x * x + y * y);
    // 2^octave sectors, whose width is between one and two cells.
    const float wanted = 6.2831853f * r / wood->ray_cell;
    const int octave = (int)clamped(floor(log2(fmax(wanted, 1.0f))), 2.0f, 16.0f);
    const float first = (float)(1 << octave) * wood->ray_cell / 6.2831853f;
    // The mean share: lenses are ellipses whose mean height is 0.725 of their segment.
    const float each = wood->ray_share * 0.725f * 0.785398f * wood->ray_width * (float)(1 << octave) /
                       (6.2831853f * fmax(r, 0.25f * first));
    const float mean = clamped(each * (0.5f * rays_present(r, 0.5f * first) +
                                       rays_present(r, first) +
                                       2.0f * rays_present(r, 2.0f * first)),
                               0.0f, 1.0f);
    const float resolved = smooth(0.9f, 0.35f, blur / wood->ray_cell);
    if (resolved <= 0.0f)
        return mean;
    const float rate = 1.0f / (45.0f * wood->ray_cell);
    float around = 0.0f, upwards = 0.0f;
    ray_drift(wood, x * rate, y * rate, z / (2.5f * wood->ray_height), &around, &upwards);
    const float turn = atan2(y, x) * 0.15915494f + 0.5f +
                       2.5f * wood->ray_cell * around / (6.2831853f * fmax(r, 3.0f * wood->ray_cell));
    const float height = z / wood->ray_height + 0.5f * upwards;
    const float sigma = fmax(blur, 0.05f * wood->ray_width);
    float clear = 1.0f;
    for (int k = -1; k <= 1; ++k) {
        const float begin = k < 0 ? 0.5f * first : k > 0 ? 2.0f * first : first;
        if (octave + k >= 2 && rays_present(r, begin) > 0.0f)
            clear *= 1.0f - rays_of_octave(wood, octave + k, begin, turn - floor(turn), r, height,
                                           sigma);
    }
    return lerp(mean, 1.0f - clear, resolved);
}

// Standard deviation of the filter across the trunk [m].
static inline float blur_across(global const Wood* wood, Triple across, Triple along) {
    const float variance =
        filter_variance(wood->right, across, along) + filter_variance(wood->up, across, along);
    return sqrt(0.5f * variance);
}

static inline SolidSample wood_part(Field field, global const Wood* wood, Triple position,
                                    Triple across, Triple along, float random) {
    const Growth growth = growth_at(field, wood, position, across, along, random);
    const float years = growth.radius / wood->ring;
    int year = floor_to_int(years);
    float passed = years - floor(years);
    // Ends are shifted by less than half a year, so it is this year or an adjacent one.
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
        lerp(uniform_of(wood_hash(wood->key, 8U, (uint)year, 9U)),
             uniform_of(wood_hash(wood->key, 8U, (uint)(year + 1), 9U)), smooth(0.0f, 1.0f, phase));
    SolidSample sample = no_sample();
    sample.value = late * (1.0f - wood->tint_variation * tint);
    sample.color = lerp3(wood->early, wood->late, sample.value);
    if (wood->sapwood > 0.0f)
        sample.color =
            lerp3(sample.color,
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
        sample.color = lerp3(sample.color, wood->ray, rays(wood, v, blur) * (1.0f - growth.knot));
    if (wood->pore_share > 0.0f) {
        Triple slope = triple(0.0f, 0.0f, 0.0f);
        const float early = (1.0f - late) * (1.0f - growth.knot);
        const float share = pores(wood, v, early, blur, &slope);
        sample.color = lerp3(sample.color, wood->pore, share);
        sample.slope = minus(sample.slope, scaled(slope, wood->pore_depth));
        sample.height -= wood->pore_depth * share;
    }
    sample.color = lerp3(sample.color,
                         triple(wood->knot.x * sample.color.x, wood->knot.y * sample.color.y,
                                wood->knot.z * sample.color.z),
                         growth.knot);
    sample.roughness = lerp(wood->early_roughness, wood->late_roughness, sample.value);
    return sample;
}

static inline SolidSample wood_at(Field field, global const Wood* wood, SolidPoint point) {
    MEAN_OF_PARTS(wood_part, field, wood, point)
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Granite: crystals of minerals in layers of decreasing size, whose borders are warped by the
// fractal field. Needs grains.cl and hewn.cl.

typedef struct {
    Warp warp;
    Hewn hewn;
    int filtered;
    Grains grains;
} Granite;

static inline SolidSample granite_part(Field field, global const Granite* granite, Triple position,
                                       Triple across, Triple along, float random) {
    const WarpedPoint at = warp_point(field, &granite->warp, position, across, along, random);
    Seeds seeds;
    float covered;
    SolidSample sample = all_grains(field, &granite->grains, 0, at, &seeds, &covered);
    hew(field, &granite->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample granite_at(Field field, global const Granite* granite, SolidPoint point) {
    MEAN_OF_PARTS(granite_part, field, granite, point)
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Granite: crystals of minerals, the large ones first, whose borders the fractal field pushes
// about. Needs grains.cl and hewn.cl.

typedef struct {
    Push push;
    Hewn hewn;
    int filtered;
    Grains grains;
} Granite;

static inline SolidSample granite_part(Field field, global const Granite* granite, Triple position,
                                       Triple across, Triple along, float random) {
    const Pushed at = pushed(field, &granite->push, position, across, along, random);
    Seeds seeds;
    float covered;
    SolidSample sample = all_grains(field, &granite->grains, 0, at, &seeds, &covered);
    hew(field, &granite->hewn, position, across, along, random, &sample);
    return sample;
}

static inline SolidSample granite_at(Field field, global const Granite* granite, SolidPoint point) {
    MEAN_OF_PARTS(granite_part, field, granite, point)
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid adjustment of fibres to a target, a work item for each fibre. OpenCL C 1.2 that is C++ as
// well (see core/kernel_as_cpp.h).
//
// `shapes` holds the vertices of each fibre about their centroid [m], three numbers each; `poses`
// eight numbers for each fibre: its centroid x, y, z [m], its rotation w, x, y, z, and one unused.

typedef struct {
    float x, y, z;
} Triple;

typedef struct {
    Triple centre;
    float w;
    Triple v;
} Pose;

// Distances at the points of a lattice, x fastest.
typedef struct {
    int nx, ny, nz;
    Triple first; // point of the lattice [m]
    float inverse_step;
} Lattice;

static inline Triple triple(float x, float y, float z) {
    Triple t;
    t.x = x;
    t.y = y;
    t.z = z;
    return t;
}
static inline Triple plus(Triple a, Triple b) { return triple(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline Triple minus(Triple a, Triple b) { return triple(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline Triple scaled(Triple a, float s) { return triple(a.x * s, a.y * s, a.z * s); }
static inline float dot3(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline Triple cross3(Triple a, Triple b) {
    return triple(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float mix1(float a, float b, float share) { return a + (b - a) * share; }

static inline Triple load3(global const float* at, int i) {
    return triple(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
}

static inline Pose load_pose(global const float* p) {
    Pose pose;
    pose.centre = triple(p[0], p[1], p[2]);
    pose.w = p[3];
    pose.v = triple(p[4], p[5], p[6]);
    return pose;
}

static inline void store_pose(global float* p, Pose pose) {
    p[0] = pose.centre.x;
    p[1] = pose.centre.y;
    p[2] = pose.centre.z;
    p[3] = pose.w;
    p[4] = pose.v.x;
    p[5] = pose.v.y;
    p[6] = pose.v.z;
}

static inline Triple turned(Pose pose, Triple p) {
    Triple t = scaled(cross3(pose.v, p), 2.0f);
    return plus(plus(p, scaled(t, pose.w)), cross3(pose.v, t));
}

// The pose moved by `by`, then turned about its centre by the rotation (w, v) of any length.
static inline Pose moved(Pose pose, Triple by, float w, Triple v) {
    Pose out;
    out.centre = plus(pose.centre, by);
    out.w = w * pose.w - dot3(v, pose.v);
    out.v = plus(plus(scaled(pose.v, w), scaled(v, pose.w)), cross3(v, pose.v));
    float scale = 1.0f / sqrt(out.w * out.w + dot3(out.v, out.v));
    out.w *= scale;
    out.v = scaled(out.v, scale);
    return out;
}

// The distance interpolated at p, and its gradient, of length 1. Beyond the lattice the way to it
// is added.
static inline float distance_at(global const float* samples, Lattice lattice, Triple p,
                                Triple* gradient) {
    Triple g = scaled(minus(p, lattice.first), lattice.inverse_step);
    Triple c = triple(fmin(fmax(g.x, 0.0f), (float)(lattice.nx - 1)),
                      fmin(fmax(g.y, 0.0f), (float)(lattice.ny - 1)),
                      fmin(fmax(g.z, 0.0f), (float)(lattice.nz - 1)));
    int i = (int)c.x, j = (int)c.y, k = (int)c.z;
    i = i < lattice.nx - 2 ? i : lattice.nx - 2;
    j = j < lattice.ny - 2 ? j : lattice.ny - 2;
    k = k < lattice.nz - 2 ? k : lattice.nz - 2;
    float u = c.x - (float)i, v = c.y - (float)j, w = c.z - (float)k;
    int row = lattice.nx, layer = lattice.nx * lattice.ny;
    global const float* s = samples + k * layer + j * row + i;
    // Along x on the four edges of the cell, then along y on two faces.
    float e00 = mix1(s[0], s[1], u), e10 = mix1(s[row], s[row + 1], u);
    float e01 = mix1(s[layer], s[layer + 1], u);
    float e11 = mix1(s[layer + row], s[layer + row + 1], u);
    float near = mix1(e00, e10, v), far = mix1(e01, e11, v);
    Triple slope;
    slope.x = mix1(mix1(s[1] - s[0], s[row + 1] - s[row], v),
                   mix1(s[layer + 1] - s[layer], s[layer + row + 1] - s[layer + row], v), w);
    slope.y = mix1(e10 - e00, e11 - e01, w);
    slope.z = far - near;
    float length = sqrt(dot3(slope, slope));
    *gradient = length > 0.0f ? scaled(slope, 1.0f / length) : triple(0.0f, 0.0f, 0.0f);
    Triple beyond = minus(g, c);
    return mix1(near, far, w) + sqrt(dot3(beyond, beyond)) / lattice.inverse_step;
}

// Solves A x = b for a symmetric positive definite A of which the lower triangle is given, in
// place (Cholesky's decomposition).
static inline void solve6(float a[6][6], float b[6]) {
    for (int j = 0; j < 6; ++j) {
        for (int k = 0; k < j; ++k)
            a[j][j] -= a[j][k] * a[j][k];
        a[j][j] = sqrt(fmax(a[j][j], 1e-20f));
        for (int i = j + 1; i < 6; ++i) {
            for (int k = 0; k < j; ++k)
                a[i][j] -= a[i][k] * a[j][k];
            a[i][j] /= a[j][j];
        }
    }
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < i; ++k)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (int i = 5; i >= 0; --i) {
        for (int k = i + 1; k < 6; ++k)
            b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
}

// One Gauss-Newton step with damping (Levenberg 1944, Marquardt 1963) on half the sum of
// max(0, distance + keep)^2 over the vertices. Returns a bound of how far vertices move [m].
static inline float step_to_nearest(global const float* shapes, int vertices, Pose* pose,
                                    global const float* samples, Lattice lattice, float keep) {
    const float damping = 0.3f;
    const float largest_turn = 0.5f;
    float a[6][6], b[6];
    for (int i = 0; i < 6; ++i) {
        b[i] = 0.0f;
        for (int k = 0; k < 6; ++k)
            a[i][k] = 0.0f;
    }
    float spread = 0.0f, reach2 = 0.0f;
    int outside = 0;
    for (int n = 0; n < vertices; ++n) {
        Triple arm = turned(*pose, load3(shapes, n));
        float arm2 = dot3(arm, arm);
        spread += arm2;
        reach2 = fmax(reach2, arm2);
        Triple g;
        float d = distance_at(samples, lattice, plus(pose->centre, arm), &g) + keep;
        if (d <= 0.0f)
            continue;
        ++outside;
        Triple lever = cross3(arm, g);
        float row[6] = {g.x, g.y, g.z, lever.x, lever.y, lever.z};
        for (int i = 0; i < 6; ++i) {
            b[i] -= row[i] * d;
            for (int k = 0; k <= i; ++k)
                a[i][k] += row[i] * row[k];
        }
    }
    if (outside == 0)
        return 0.0f;
    // A turn counts as the root mean square of the way of the vertices.
    float turning = damping * spread / (float)vertices;
    for (int i = 0; i < 3; ++i) {
        a[i][i] += damping;
        a[i + 3][i + 3] += turning;
    }
    solve6(a, b);
    Triple shift = triple(b[0], b[1], b[2]);
    Triple turn = triple(b[3], b[4], b[5]);
    float angle = sqrt(dot3(turn, turn));
    if (angle > largest_turn) {
        turn = scaled(turn, largest_turn / angle);
        angle = largest_turn;
    }
    // Cayley's map turns by 2 atan(angle / 2) and needs no sine, which devices round differently.
    *pose = moved(*pose, shift, 1.0f, scaled(turn, 0.5f));
    return sqrt(dot3(shift, shift)) + angle * sqrt(reach2);
}

// Moves each fibre until it moves by `still` [m] or less, at most `most` times; `iterations` is
// how many it took. Global size: fibres.
kernel void scree_adjust_nearest(global const float* shapes, int vertices, global float* poses,
                                 global const float* samples, int nx, int ny, int nz, float x,
                                 float y, float z, float inverse_step, float keep, float still,
                                 int most, global int* iterations) {
    int fibre = (int)get_global_id(0);
    Lattice lattice;
    lattice.nx = nx;
    lattice.ny = ny;
    lattice.nz = nz;
    lattice.first = triple(x, y, z);
    lattice.inverse_step = inverse_step;
    Pose pose = load_pose(poses + 8 * fibre);
    int done = 0;
    while (done < most) {
        float way = step_to_nearest(shapes + (ulong)fibre * (ulong)(3 * vertices), vertices, &pose,
                                    samples, lattice, keep);
        if (way > 0.0f)
            ++done;
        if (way <= still)
            break;
    }
    store_pose(poses + 8 * fibre, pose);
    iterations[fibre] = done;
}

// Eq. 5.1 of Sakurai 2013: the height over the nearest vertex along its normal, here with the sign
// that makes it positive inside, as eq. 5.2 wants. `surface` holds six numbers for each vertex of
// the target, its position [m] and its normal. `first` and `nearest` list for each cell of a
// cubic grid of `side` cells the vertices that can be nearest to a point in it.
typedef struct {
    global const float* surface;
    global const int* first;
    global const int* nearest;
    int side;
    Triple corner;
    float inverse_cell;
} Vertices;

static inline int cell_of(float x, int side) {
    int cell = (int)fmax(x, 0.0f);
    return cell < side ? cell : side - 1;
}

static inline float thesis_depth(Vertices target, Triple p) {
    Triple g = scaled(minus(p, target.corner), target.inverse_cell);
    int cell = (cell_of(g.z, target.side) * target.side + cell_of(g.y, target.side)) * target.side +
               cell_of(g.x, target.side);
    float least = 3.0e38f, depth = 0.0f;
    for (int n = target.first[cell]; n < target.first[cell + 1]; ++n) {
        global const float* v = target.surface + 6 * target.nearest[n];
        Triple way = minus(p, load3(v, 0));
        float d2 = dot3(way, way);
        if (d2 < least) {
            least = d2;
            depth = -dot3(way, load3(v, 1));
        }
    }
    return depth;
}

// Eq. 5.2: the sum of depths over the vertices of which `counted` has a bit.
static inline float thesis_cost(Vertices target, global const float* shapes, int vertices, Pose pose,
                                const uint* counted) {
    float sum = 0.0f;
    for (int n = 0; n < vertices; ++n)
        if ((counted[n / 32] >> (n % 32) & 1U) != 0U)
            sum += thesis_depth(target, plus(pose.centre, turned(pose, load3(shapes, n))));
    return sum;
}

// Marks the vertices of segments that are not wholly inside, in `counted`, which begins without
// marks; returns how many vertices are outside.
static inline int count_outside(Vertices target, global const float* shapes, int vertices, Pose pose,
                                uint* counted) {
    int outside = 0;
    for (int n = 0; n < vertices; ++n) {
        if (thesis_depth(target, plus(pose.centre, turned(pose, load3(shapes, n)))) >= 0.0f)
            continue;
        ++outside;
        for (int k = n > 0 ? n - 1 : 0; k <= n + 1 && k < vertices; ++k)
            counted[k / 32] |= 1U << (k % 32);
    }
    return outside;
}

// The best of 12 moves, if better than none: `shift[fibre]` [m] along each axis, to and fro, and
// twice the angle of (half_cosine, half_sine) about each. `outside` is how many vertices were
// outside before. Global size: fibres.
kernel void scree_adjust_thesis(global const float* shapes, int vertices, global float* poses,
                                global const float* surface, global const int* first,
                                global const int* nearest, int side, float x, float y, float z,
                                float inverse_cell, global const float* shift, float half_cosine,
                                float half_sine, global int* outside) {
    int fibre = (int)get_global_id(0);
    Vertices target;
    target.surface = surface;
    target.first = first;
    target.nearest = nearest;
    target.side = side;
    target.corner = triple(x, y, z);
    target.inverse_cell = inverse_cell;
    global const float* mine = shapes + (ulong)fibre * (ulong)(3 * vertices);
    Pose pose = load_pose(poses + 8 * fibre);
    uint counted[9] = {0U}; // of up to 257 vertices
    outside[fibre] = count_outside(target, mine, vertices, pose, counted);
    if (outside[fibre] == 0)
        return;
    Pose best = pose;
    float most = thesis_cost(target, mine, vertices, pose, counted);
    for (int move = 0; move < 12; ++move) {
        int axis = move % 3;
        float sign = move % 6 < 3 ? 1.0f : -1.0f;
        Triple along = triple(axis == 0 ? sign : 0.0f, axis == 1 ? sign : 0.0f,
                              axis == 2 ? sign : 0.0f);
        Pose tried = move < 6 ? moved(pose, scaled(along, shift[fibre]), 1.0f, triple(0, 0, 0))
                              : moved(pose, triple(0, 0, 0), half_cosine, scaled(along, half_sine));
        float cost = thesis_cost(target, mine, vertices, tried, counted);
        if (cost > most) {
            most = cost;
            best = tried;
        }
    }
    store_pose(poses + 8 * fibre, best);
}

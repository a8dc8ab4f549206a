/* Algorithm 1 in C: mapping with one directional lighthouse.
 *
 *     allworlds init --header > allworlds.h
 *     cc -O2 -shared -fPIC -I . -o algorithm1.so examples/c/algorithm1.c
 *     allworlds check --native ./algorithm1.so --edges 6
 *
 * The robot's S is an array of darts; those of a vertex are consecutive and clockwise, and begin with
 * the one by which the vertex was discovered.  Between two calls the explorer is in one of the
 * phases below.
 */
#include <allworlds.h>

#include <stdlib.h>
#include <string.h>

struct dart {
    int32_t vertex;
    allworlds_percept expected; /* of a robot that has arrived by it */
};

struct vertex {
    int32_t first;  /* its first dart */
    int32_t home;   /* the first of its darts that leads nearer to v0 */
    int32_t depth;  /* the length of a shortest walk to v0 */
    int32_t length; /* of one to what was measured last */
};

enum phase {
    PASSING,   /* between two passes */
    FOLLOWING, /* on the way through S */
    CROSSING,  /* on the dart that is explored */
    TESTING,   /* on a path that tests a hypothesis */
    RETRACING  /* on the way back */
};

struct robot {
    struct dart *darts;
    int32_t *sigma; /* the next dart clockwise */
    int32_t *twins; /* where a dart leads; itself: nobody knows yet */
    struct vertex *vertices;
    int32_t *open;       /* U, in the order in which its darts came into S */
    int32_t *hypotheses; /* H, in that order */
    int32_t *numbers;    /* room: a queue, a path, or costs */
    int32_t *motions;    /* of the test: to be undone */
    int32_t dart_count, vertex_count, open_count, hypothesis_count, room;

    enum phase phase;
    int32_t here;    /* the robot's dart in S */
    int32_t turned;  /* after a test: clockwise of the dart of entry */
    int32_t goal;    /* the dart that is explored: e */
    int32_t partner; /* the hypothesis that is tested: e' */
    int32_t done;    /* steps of the test */
    allworlds_percept seen; /* behind e */

    allworlds_pick pick;
    void *context;
};

static void *room_for(void *memory, int32_t count, size_t size)
{
    void *larger = realloc(memory, (size_t)count * size);
    if (!larger)
        abort();
    return larger;
}

static void make_room(struct robot *r, int32_t darts)
{
    if (darts <= r->room)
        return;
    r->room = 2 * darts;
    r->darts = room_for(r->darts, r->room, sizeof *r->darts);
    r->sigma = room_for(r->sigma, r->room, sizeof *r->sigma);
    r->twins = room_for(r->twins, r->room, sizeof *r->twins);
    r->vertices = room_for(r->vertices, r->room, sizeof *r->vertices);
    r->open = room_for(r->open, r->room, sizeof *r->open);
    r->hypotheses = room_for(r->hypotheses, r->room, sizeof *r->hypotheses);
    r->numbers = room_for(r->numbers, r->room, sizeof *r->numbers);
    r->motions = room_for(r->motions, r->room, sizeof *r->motions);
}

static int32_t choose(struct robot *r, int32_t of, int32_t options, const int32_t *cost)
{
    return r->pick ? r->pick(r->context, of, options, cost) : 0;
}

/* ---- S */

static struct vertex *vertex_of(struct robot *r, int32_t dart)
{
    return &r->vertices[r->darts[dart].vertex];
}

/* The motion from where the robot is in S to another dart of that vertex. */
static int32_t offset(const struct robot *r, int32_t dart)
{
    int32_t motion = dart - r->here;
    return motion < 0 ? motion + r->darts[dart].expected.degree : motion;
}

static void add_vertex(struct robot *r, const allworlds_percept *seen)
{
    int32_t degree = seen->degree, marks = seen->marks, bearing = seen->bearing;
    int32_t first = r->dart_count, vertex = r->vertex_count++;
    make_room(r, first + degree);
    r->vertices[vertex].first = first;
    r->vertices[vertex].depth = 0;
    for (int32_t dart = first; dart < first + degree; dart++) {
        r->darts[dart] = (struct dart){vertex, {degree, marks, bearing}};
        r->sigma[dart] = dart + 1;
        r->twins[dart] = dart;
        r->open[r->open_count++] = dart;
    }
    r->dart_count += degree;
    r->sigma[r->dart_count - 1] = first;
}

/* An edge of S, whose darts leave U. */
static void explore(struct robot *r, int32_t dart, int32_t partner)
{
    int32_t left = 0;
    r->twins[dart] = partner;
    r->twins[partner] = dart;
    for (int32_t i = 0; i < r->open_count; i++)
        if (r->open[i] != dart && r->open[i] != partner)
            r->open[left++] = r->open[i];
    r->open_count = left;
}

/* For each vertex the length of a shortest walk to one of them. */
static void measure(struct robot *r, int32_t goal)
{
    int32_t known = 1, *queue = r->numbers;
    for (int32_t v = 0; v < r->vertex_count; v++)
        r->vertices[v].length = -1;
    r->vertices[goal].length = 0;
    queue[0] = goal;
    for (int32_t taken = 0; known < r->vertex_count; taken++) { /* S is connected */
        struct vertex *v = &r->vertices[queue[taken]];
        int32_t end = v->first + r->darts[v->first].expected.degree;
        for (int32_t dart = v->first; dart < end; dart++) {
            int32_t other = r->darts[r->twins[dart]].vertex;
            if (r->vertices[other].length < 0) {
                r->vertices[other].length = v->length + 1;
                queue[known++] = other;
            }
        }
    }
}

/* The first dart of the vertex that leads one step nearer to what was measured to. */
static int32_t nearer(struct robot *r, int32_t vertex)
{
    int32_t dart = r->vertices[vertex].first;
    while (vertex_of(r, r->twins[dart])->length != r->vertices[vertex].length - 1)
        dart++;
    return dart;
}

/* An edge of S may have brought vertices nearer to v0. */
static void draw_nearer(struct robot *r, int32_t dart)
{
    int32_t twin = r->twins[dart], far, gain;
    if (vertex_of(r, dart)->depth < vertex_of(r, twin)->depth) {
        far = twin;
        twin = dart;
    } else {
        far = dart;
    }
    gain = vertex_of(r, far)->depth - vertex_of(r, twin)->depth;
    if (gain > 1) {
        measure(r, 0);
        for (int32_t v = 1; v < r->vertex_count; v++) {
            r->vertices[v].depth = r->vertices[v].length;
            r->vertices[v].home = nearer(r, v);
        }
    } else if (gain == 1 && far < vertex_of(r, far)->home) {
        vertex_of(r, far)->home = far;
    }
}

/* ---- one step */

static void leave_by(struct robot *r, int32_t dart, allworlds_action *action)
{
    action->kind = ALLWORLDS_MOVE;
    action->motion = offset(r, dart);
    r->here = r->twins[dart];
}

/* Lines 4-5: towards e, and along it. */
static void follow(struct robot *r, allworlds_action *action)
{
    int32_t vertex = r->darts[r->here].vertex;
    if (vertex == r->darts[r->goal].vertex) {
        r->phase = CROSSING;
        leave_by(r, r->goal, action);
    } else {
        r->phase = FOLLOWING;
        leave_by(r, r->darts[r->goal].vertex ? nearer(r, vertex) : r->vertices[vertex].home, action);
    }
}

/* Lines 2-4: which dart is explored next. */
static void next_pass(struct robot *r, allworlds_action *action)
{
    int32_t vertex, goal;
    if (r->open_count == 0) {
        action->kind = ALLWORLDS_ANSWER;
        return;
    }
    vertex = r->darts[r->here].vertex;
    if (r->pick && vertex)
        measure(r, vertex);
    if (r->pick)
        for (int32_t i = 0; i < r->open_count; i++) {
            const struct vertex *v = vertex_of(r, r->open[i]);
            r->numbers[i] = vertex ? v->length : v->depth;
        }
    r->goal = r->open[choose(r, ALLWORLDS_EDGE, r->open_count, r->numbers)];
    goal = r->darts[r->goal].vertex;
    if (goal && goal != vertex)
        measure(r, goal);
    follow(r, action);
}

/* Lines 10-13: the next step of the test; at v0 it is over, and case (3). */
static void test(struct robot *r, allworlds_action *action)
{
    int32_t vertex = r->darts[r->here].vertex;
    if (vertex == 0) {
        /* Lines 18-19: e and e' are one edge, and the robot stands at v0. */
        explore(r, r->goal, r->partner);
        draw_nearer(r, r->goal);
        r->phase = PASSING;
        action->kind = ALLWORLDS_CHECKPOINT;
        return;
    }
    r->phase = TESTING;
    make_room(r, r->done + 1); /* a robot that errs may walk on and on */
    r->motions[r->done++] = offset(r, r->vertices[vertex].home);
    leave_by(r, r->vertices[vertex].home, action);
    action->motion -= r->turned;
    r->turned = 0;
}

/* Lines 7-9: the next hypothesis; if none is left, lines 20-21: a new vertex. */
static void next_hypothesis(struct robot *r, allworlds_action *action)
{
    int32_t taken, entry = r->dart_count;
    if (r->hypothesis_count == 0) {
        add_vertex(r, &r->seen);
        explore(r, r->goal, entry);
        r->vertices[r->vertex_count - 1].home = entry;
        r->vertices[r->vertex_count - 1].depth = vertex_of(r, r->goal)->depth + 1;
        r->here = entry + (r->turned % r->seen.degree + r->seen.degree) % r->seen.degree;
        r->phase = PASSING;
        action->kind = ALLWORLDS_CHECKPOINT;
        return;
    }
    taken = choose(r, ALLWORLDS_HYPOTHESIS, r->hypothesis_count, NULL);
    r->partner = r->here = r->hypotheses[taken];
    r->hypothesis_count--;
    for (int32_t i = taken; i < r->hypothesis_count; i++)
        r->hypotheses[i] = r->hypotheses[i + 1];
    r->done = 0;
    test(r, action);
}

/* Line 15: the last motion that has not been undone is undone; `turned` is what a step begins with. */
static void retrace(struct robot *r, allworlds_action *action)
{
    if (r->done == 0) {
        r->turned = -r->turned;
        next_hypothesis(r, action);
        return;
    }
    r->phase = RETRACING;
    action->kind = ALLWORLDS_MOVE;
    action->motion = r->turned;
    r->turned = -r->motions[--r->done];
}

static int alike(const allworlds_percept *a, const allworlds_percept *b)
{
    return a->degree == b->degree && a->marks == b->marks && a->bearing == b->bearing;
}

/* Line 6: H, the other darts of U by which a robot would sense just this. */
static void suppose(struct robot *r)
{
    r->hypothesis_count = r->turned = 0;
    for (int32_t i = 0; i < r->open_count; i++)
        if (r->open[i] != r->goal && alike(&r->darts[r->open[i]].expected, &r->seen))
            r->hypotheses[r->hypothesis_count++] = r->open[i];
}

/* ---- the interface */

int32_t allworlds_version(void) { return ALLWORLDS_VERSION; }

void *allworlds_new(void) { return calloc(1, sizeof(struct robot)); }

void allworlds_delete(void *state)
{
    struct robot *r = state;
    free(r->darts);
    free(r->sigma);
    free(r->twins);
    free(r->vertices);
    free(r->open);
    free(r->hypotheses);
    free(r->numbers);
    free(r->motions);
    free(r);
}

void allworlds_choose(void *state, allworlds_pick pick, void *context)
{
    struct robot *r = state;
    r->pick = pick;
    r->context = context;
}

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    struct robot *r = state;
    (void)told;
    r->dart_count = r->vertex_count = r->open_count = r->here = r->turned = 0;
    add_vertex(r, percept);
    if (percept->bearing >= 0)
        for (int32_t dart = 0; dart < percept->degree; dart++)
            r->darts[dart].expected.bearing =
                (percept->bearing - dart + percept->degree) % percept->degree;
    next_pass(r, action);
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    struct robot *r = state;
    switch (r->phase) {
    case PASSING:
        next_pass(r, action);
        break;
    case FOLLOWING:
        follow(r, action);
        break;
    case CROSSING:
        r->seen = *percept;
        suppose(r);
        next_hypothesis(r, action);
        break;
    case TESTING:
        if (alike(&r->darts[r->here].expected, percept)) {
            test(r, action);
        } else { /* cases (1) and (2) */
            r->turned = -r->turned;
            retrace(r, action);
        }
        break;
    case RETRACING:
        retrace(r, action);
        break;
    }
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    const struct robot *r = state;
    if (r->dart_count > capacity)
        return r->dart_count;
    memcpy(sigma, r->sigma, (size_t)r->dart_count * sizeof *sigma);
    memcpy(alpha, r->twins, (size_t)r->dart_count * sizeof *alpha);
    *here = r->here;
    return r->dart_count;
}

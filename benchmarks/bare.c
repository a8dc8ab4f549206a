/* A native explorer that is played and nothing else: no log, no clock, no judge.
 *
 * Worlds are laid out as allworlds.engines.kernel.batches has them: for each dart the first dart of its
 * vertex, its partner, and degree, marks and bearing + 1 on arriving by it, a byte each.
 */
#include <allworlds.h>

enum { FIRST, PARTNER, DEGREE, MARKS, BEARING, WIDE };

struct explorer {
    void (*start)(void *, const allworlds_percept *, int32_t, allworlds_action *);
    void (*step)(void *, const allworlds_percept *, allworlds_action *);
    int32_t (*answer)(void *, int32_t, int32_t *, int32_t *, int32_t *);
    void (*choose)(void *, allworlds_pick, void *);
    void *state;
};

static int32_t first(void *context, int32_t of, int32_t options, const int32_t *cost)
{
    (void)context, (void)of, (void)options, (void)cost;
    return 0;
}

static allworlds_percept sensed(const uint8_t *dart)
{
    return (allworlds_percept){dart[DEGREE], dart[MARKS], dart[BEARING] - 1};
}

/* How many traversals all runs had. */
long play(const struct explorer *e, long runs, long width, const uint8_t *worlds,
          const int32_t *told, long apart, int32_t capacity, int32_t *sigma, int32_t *alpha)
{
    long traversals = 0;
    for (long run = 0; run < runs; run++) {
        const uint8_t *world = worlds + run * width;
        int32_t dart = 0, here;
        allworlds_percept percept = sensed(world);
        allworlds_action action = {0, 0};
        if (e->choose)
            e->choose(e->state, first, 0);
        e->start(e->state, &percept, told[run * apart], &action);
        for (;;) {
            if (action.kind == ALLWORLDS_MOVE) {
                const uint8_t *at = world + WIDE * dart;
                int32_t degree = at[DEGREE], motion = action.motion;
                if (motion < 0 || motion >= degree)
                    motion = (motion % degree + degree) % degree;
                dart += motion;
                if (dart >= at[FIRST] + degree)
                    dart -= degree;
                dart = world[WIDE * dart + PARTNER];
                percept = sensed(world + WIDE * dart);
                traversals++;
            } else {
                e->answer(e->state, capacity, sigma, alpha, &here);
                if (action.kind != ALLWORLDS_CHECKPOINT)
                    break;
            }
            action = (allworlds_action){0, 0};
            e->step(e->state, &percept, &action);
        }
    }
    return traversals;
}

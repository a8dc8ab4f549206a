/* A wrong explorer: it walks on to the next dart until it is back at v0, and believes that the world
 * is a ring of what it has met.
 *
 *     cc -O2 -shared -fPIC -I . -o hasty.so examples/c/hasty.c
 *     allworlds check --native ./hasty.so --edges 3
 *
 * It is right in a ring that lies alone in the plane.  The check shows the smallest world in which
 * it is wrong.
 */
#include <allworlds.h>

static int32_t edges;

int32_t allworlds_version(void) { return ALLWORLDS_VERSION; }

void *allworlds_new(void) { return &edges; }

void allworlds_delete(void *state) { (void)state; }

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    (void)state, (void)percept, (void)told;
    edges = 1;
    action->kind = ALLWORLDS_MOVE;
    action->motion = 0;
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    (void)state;
    if (percept->marks) {
        action->kind = ALLWORLDS_ANSWER;
        return;
    }
    edges++;
    action->kind = ALLWORLDS_MOVE;
    action->motion = 1;
}

/* Darts 2i and 2i + 1 are edge i, which leads from vertex i to vertex i + 1. */
int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    int32_t darts = 2 * edges;
    (void)state;
    if (darts > capacity)
        return darts;
    for (int32_t i = 0; i < edges; i++) {
        int32_t before = 2 * ((i + edges - 1) % edges) + 1;
        sigma[2 * i] = before;
        sigma[before] = 2 * i;
        alpha[2 * i] = 2 * i + 1;
        alpha[2 * i + 1] = 2 * i;
    }
    *here = darts - 1;
    return darts;
}

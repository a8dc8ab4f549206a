/* Algorithm 1 in C with a slip, or with copies of another kind.
 *
 * SLIP: code in `step` after the robot has acted; COPY: code in `clone` after the right copy has been
 * made; where WITHOUT is defined the library has no clone.  `*steps_of(state)` is a number for each
 * state: 0 at the start, the original's in a copy.
 */
#include <signal.h>
#include <unistd.h>

#define allworlds_start right_start
#define allworlds_step right_step
#define allworlds_clone right_clone
#include "../../../examples/c/algorithm1.c"
#undef allworlds_start
#undef allworlds_step
#undef allworlds_clone

#ifndef SLIP
#define SLIP
#endif

static int32_t *steps_of(const void *state)
{
    static struct {
        const void *state;
        int32_t steps;
    } known[1024];
    int i = 0;
    while (known[i].state && known[i].state != state) i++;
    known[i].state = state;
    return &known[i].steps;
}

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    *steps_of(state) = 0;
    right_start(state, percept, told, action);
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    struct robot *r = state;
    right_step(state, percept, action);
    (void)r;
    SLIP;
}

#ifdef WITHOUT
void not_used(const void *from, void *to) { right_clone(from, to); }
#else
void allworlds_clone(const void *from, void *to)
{
    static int32_t copies;
    const struct robot *r = from;
    struct robot *copy = to;
    right_clone(from, to);
    *steps_of(to) = *steps_of(from);
    copies++;
    (void)r, (void)copy;
    COPY;
}
#endif

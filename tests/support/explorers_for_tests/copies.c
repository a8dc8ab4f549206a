/* Algorithm 1 in C with a slip, or with copies of another kind.
 *
 * SLIP: code in `step` after the robot has acted; COPY: code in `clone` after the right copy has been
 * made; where WITHOUT is defined the library has no clone.
 */
#include <signal.h>
#include <unistd.h>

#define allworlds_step right_step
#define allworlds_clone right_clone
#include "../../../examples/c/algorithm1.c"
#undef allworlds_step
#undef allworlds_clone

#ifndef SLIP
#define SLIP
#endif

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
    copies++;
    (void)r, (void)copy;
    COPY;
}
#endif

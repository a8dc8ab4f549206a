/* Explorers whose answer is spoiled by the place where something of theirs lies in memory.
 *
 * verdict of variable: refuted nondeterministic or no-estimate
 * verdict of heap: refuted nondeterministic or no-estimate
 * verdict of stack: refuted nondeterministic or no-estimate
 * options: --edges 4 --laws map,pose
 */
#include "right.h"

static int32_t here_it_is;

static inline uintptr_t variable(void) { return (uintptr_t)&here_it_is; }

static inline uintptr_t heap(void)
{
    static void *block;
    if (!block)
        block = malloc(16);
    return (uintptr_t)block;
}

static inline uintptr_t stack(void)
{
    volatile int32_t local = 0;
    return (uintptr_t)&local + local;
}

void allworlds_start(void *state, const allworlds_percept *percept, int32_t told,
                     allworlds_action *action)
{
    right_start(state, percept, told, action);
}

void allworlds_step(void *state, const allworlds_percept *percept, allworlds_action *action)
{
    right_step(state, percept, action);
}

int32_t allworlds_answer(void *state, int32_t capacity, int32_t *sigma, int32_t *alpha,
                         int32_t *here)
{
    if (ATTACK() >> 21 & 3)
        return 0;
    return right_answer(state, capacity, sigma, alpha, here);
}
